// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/face_matching.h>
#include <contrecoup/gas/octree/hanging_group.h>

#include <algorithm>

namespace contrecoup::gas
{
template <int dim>
void FaceMatching<dim>::reinit()
{
  find_cut_faces();
  match_hanging_faces();
  find_neighbors();
}


template <int dim>
void FaceMatching<dim>::find_cut_faces()
{
  const auto &faces = shapes_.mesh().hanging_faces();
  is_cut_face_.assign(faces.size(), 0);
  sides_.clear();
  const auto is_cut = [this](const unsigned int leaf) {
    return leaf != no_leaf && !shapes_.fractions().is_open(leaf);
  };
  for (unsigned int i = 0; i < faces.size(); ++i)
  {
    const HangingFace<dim> &face = faces[i];
    if (!is_cut(face.coarse_leaf) &&
        std::none_of(face.fine_leaf.begin(), face.fine_leaf.end(), is_cut))
      continue;
    is_cut_face_[i] = 1;
    sides_[{face.coarse_leaf, face.coarse_face}] = {i, no_leaf};
    for (unsigned int part = 0; part < face.n_fine; ++part)
      if (face.fine_leaf[part] != no_leaf)
        sides_[{face.fine_leaf[part], face.match.face}] = {i, part};
  }
}


template <int dim>
void FaceMatching<dim>::match_hanging_faces()
{
  const auto &faces = shapes_.mesh().hanging_faces();
  for (unsigned int i = 0; i < faces.size(); ++i)
  {
    if (is_cut_face_[i] == 0)
      continue;
    const HangingFace<dim> &face = faces[i];
    if (face.coarse_leaf < shapes_.mesh().n_owned())
      match_coarse_side(face);
    for (unsigned int part = 0; part < face.n_fine; ++part)
      if (face.fine_leaf[part] != no_leaf)
        match_fine_side(face, part);
  }
}


template <int dim>
void FaceMatching<dim>::match_coarse_side(const HangingFace<dim> &face)
{
  const LeafLayout &layout = shapes_.layout();
  if (shapes_.fractions().is_closed(face.coarse_leaf))
    return;
  // Running means, so that equal parts keep every bit.
  std::vector<double> openings(layout.n_face_points, 0.);
  std::vector<double> areas(layout.n_face_points, 0.);
  const double inner = relative_inner_radius(shapes_.mesh(), face);
  for (unsigned int part = 0; part < face.n_fine; ++part)
    for (unsigned int q = 0; q < layout.n_face_points; ++q)
    {
      const unsigned int coarse = coarse_face_point(part, q);
      const unsigned int place = part % 2 * layout.n + q % layout.n;
      const double area = relative_radius(
        inner, layout.n, coarse % layout.n, place % 2 ? 0.25 : -0.25);
      areas[coarse] += area;
      openings[coarse] += (hanging_opening(face, part, q) - openings[coarse]) *
                          (area / areas[coarse]);
    }
  if (shapes_.shape(face.coarse_leaf) == nullptr &&
      std::all_of(openings.begin(), openings.end(), [](const double x) {
        return x == 1.;
      }))
    return;
  const unsigned int layer = face.coarse_face % 2 ? layout.n : 0;
  std::copy(openings.begin(),
            openings.end(),
            shapes_.changed_shape(face.coarse_leaf)
                .opening[face.coarse_face / 2]
                .begin() +
              layer * layout.n_face_points);
}


template <int dim>
void FaceMatching<dim>::match_fine_side(const HangingFace<dim> &face,
                                        const unsigned int part)
{
  const LeafLayout &layout = shapes_.layout();
  const unsigned int leaf = face.fine_leaf[part];
  const unsigned int side = face.match.face;
  if (shapes_.fractions().is_closed(leaf))
    return;
  for (unsigned int q = 0; q < layout.n_face_points; ++q)
  {
    const double open = hanging_opening(face, part, q);
    if (open != shapes_.opening({leaf, layout.face_point(side, q, 0)}, side))
      shapes_.changed_shape(leaf)
        .opening[side / 2]
                [(side % 2 ? layout.n : 0) * layout.n_face_points + q] = open;
  }
}


template <int dim>
unsigned int FaceMatching<dim>::coarse_face_point(const unsigned int part,
                                                  const unsigned int q) const
{
  const unsigned int n = shapes_.layout().n;
  unsigned int result = 0;
  for (unsigned int t = 0, factor = 1; t + 1 < dim; ++t, factor *= n)
    result += (((part >> t) % 2) * n + q / factor % n) / 2 * factor;
  return result;
}


template <int dim>
double FaceMatching<dim>::hanging_opening(const HangingFace<dim> &face,
                                          const unsigned int part,
                                          const unsigned int q) const
{
  const LeafLayout &layout = shapes_.layout();
  const OpenFractions &fractions = shapes_.fractions();
  const unsigned int coarse =
    layout.face_point(face.coarse_face, coarse_face_point(part, q), 0);
  if (!(fractions(face.coarse_leaf, coarse) > 0.))
    return 0.;
  const Subcell fine = {face.fine_leaf[part],
                        layout.face_point(face.match.face, q, 0)};
  // A staircase's own openings rest on cells of equal size beyond.
  if (shapes_.is_staircase())
    return fractions(fine.leaf, fine.point) > 0. ? 1. : 0.;
  return shapes_.opening(fine, face.match.face);
}


template <int dim>
void FaceMatching<dim>::find_neighbors()
{
  neighbors_.clear();
  const LeafMesh<dim> &mesh = shapes_.mesh();
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const unsigned int batch = leaf / mesh.width();
    bool is_near = shapes_.shape(leaf) != nullptr;
    for (unsigned int face = 0; face < 2 * dim; ++face)
      is_near = is_near ||
                shapes_.shape(mesh.neighbors(batch, face)[leaf % mesh.width()]);
    if (is_near)
      connect(leaf);
  }
}


template <int dim>
void FaceMatching<dim>::connect(const unsigned int leaf)
{
  const LeafMesh<dim> &mesh = shapes_.mesh();
  const unsigned int batch = leaf / mesh.width();
  const unsigned int lane = leaf % mesh.width();
  std::array<unsigned int, 2 * dim> neighbors;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    neighbors[face] = mesh.neighbors(batch, face)[lane];
  for (auto s = mesh.special_begin(batch); s != mesh.special_end(batch); ++s)
    if (s->lane == lane)
      neighbors[s->face] = no_leaf;
  neighbors_[leaf] = neighbors;
  for (unsigned int face = 0; face < 2 * dim; ++face)
    if (neighbors[face] != no_leaf && neighbors[face] >= mesh.first_ghost())
    {
      std::array<unsigned int, 2 * dim> none;
      none.fill(no_leaf);
      neighbors_.try_emplace(neighbors[face], none).first->second[face ^ 1U] =
        leaf;
    }
}


template <int dim>
void FaceMatching<dim>::close(const Subcell &cell)
{
  const LeafLayout &layout = shapes_.layout();
  shapes_.close(cell);
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    const unsigned int layer = shapes_.layer_of(cell, face);
    if (layer != (face % 2) * layout.n)
      continue;
    const unsigned int other = neighbor(cell.leaf, face);
    if (other != no_leaf && !shapes_.fractions().is_closed(other))
      shapes_.changed_shape(other)
        .opening[face / 2][(layout.n - layer) * layout.n_face_points +
                           shapes_.line_of(cell.point, face / 2)] = 0.;
  }
}


template class FaceMatching<2>;
template class FaceMatching<3>;
} // namespace contrecoup::gas
