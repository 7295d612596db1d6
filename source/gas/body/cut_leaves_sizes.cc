// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/octree/hanging_group.h>

#include <algorithm>

namespace contrecoup::gas
{
template <int dim>
unsigned int CutLeaves<dim>::coarse_face_point(const unsigned int part,
                                               const unsigned int q) const
{
  unsigned int result = 0, factor = 1, rest = q;
  for (unsigned int t = 0; t + 1 < dim; ++t)
  {
    result += (((part >> t) % 2) * layout_.n + rest % layout_.n) / 2 * factor;
    factor *= layout_.n;
    rest /= layout_.n;
  }
  return result;
}


template <int dim>
double CutLeaves<dim>::hanging_opening(const HangingFace<dim> &face,
                                       const unsigned int part,
                                       const unsigned int q) const
{
  const unsigned int coarse =
    layout_.face_point(face.coarse_face, coarse_face_point(part, q), 0);
  if (!(fractions_(face.coarse_leaf, coarse) > 0.))
    return 0.;
  const Cell fine = {face.fine_leaf[part],
                     layout_.face_point(face.match.face, q, 0)};
  // A staircase's own openings rest on cells of equal size beyond.
  if (treatment() == RigidBody::Treatment::staircase)
    return fractions_(fine.leaf, fine.point) > 0. ? 1. : 0.;
  return opening(fine, face.match.face);
}


template <int dim>
void CutLeaves<dim>::match_sizes()
{
  const auto &faces = mesh_->hanging_faces();
  is_cut_face_.assign(faces.size(), 0);
  sides_.clear();
  const auto is_cut = [this](const unsigned int leaf) {
    return leaf != no_leaf && !fractions_.is_open(leaf);
  };
  for (unsigned int i = 0; i < faces.size(); ++i)
    if (is_cut(faces[i].coarse_leaf) || std::any_of(faces[i].fine_leaf.begin(),
                                                    faces[i].fine_leaf.end(),
                                                    is_cut))
      is_cut_face_[i] = 1;
  match_cut_faces();
}


template <int dim>
void CutLeaves<dim>::match_cut_faces()
{
  const auto &faces = mesh_->hanging_faces();
  for (unsigned int i = 0; i < faces.size(); ++i)
  {
    if (is_cut_face_[i] == 0)
      continue;
    const HangingFace<dim> &face = faces[i];
    sides_[{face.coarse_leaf, face.coarse_face}] = {i, no_leaf};
    if (face.coarse_leaf < mesh_->n_owned())
      match_coarse_side(face);
    for (unsigned int part = 0; part < face.n_fine; ++part)
      if (face.fine_leaf[part] != no_leaf)
      {
        sides_[{face.fine_leaf[part], face.match.face}] = {i, part};
        match_fine_side(face, part);
      }
  }
}


template <int dim>
typename CutLeaves<dim>::Shape &
CutLeaves<dim>::own_shape(const unsigned int leaf)
{
  if (matched_of_[leaf] < 0)
  {
    Shape copy;
    if (const Shape *known = shape(leaf))
      copy = *known;
    else
    {
      copy.fraction.assign(layout_.n_points, 1.);
      for (auto &faces : copy.opening)
        faces.assign((layout_.n + 1) * layout_.n_face_points, 1.);
      fractions_.set(leaf, copy.fraction);
    }
    matched_of_[leaf] = static_cast<int>(matched_shapes_.size());
    matched_shapes_.push_back(std::move(copy));
  }
  return matched_shapes_[matched_of_[leaf]];
}


template <int dim>
void CutLeaves<dim>::match_coarse_side(const HangingFace<dim> &face)
{
  if (fractions_.is_closed(face.coarse_leaf))
    return;
  // Running means, so that equal parts keep every bit.
  std::vector<double> openings(layout_.n_face_points, 0.);
  std::vector<double> areas(layout_.n_face_points, 0.);
  const double inner = relative_inner_radius(*mesh_, face);
  for (unsigned int part = 0; part < face.n_fine; ++part)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    {
      const unsigned int coarse = coarse_face_point(part, q);
      const unsigned int place = part % 2 * layout_.n + q % layout_.n;
      const double area = relative_radius(
        inner, layout_.n, coarse % layout_.n, place % 2 ? 0.25 : -0.25);
      areas[coarse] += area;
      openings[coarse] += (hanging_opening(face, part, q) - openings[coarse]) *
                          (area / areas[coarse]);
    }
  if (shape(face.coarse_leaf) == nullptr &&
      std::all_of(openings.begin(), openings.end(), [](const double x) {
        return x == 1.;
      }))
    return;
  const unsigned int layer = face.coarse_face % 2 ? layout_.n : 0;
  std::copy(openings.begin(),
            openings.end(),
            own_shape(face.coarse_leaf).opening[face.coarse_face / 2].begin() +
              layer * layout_.n_face_points);
}


template <int dim>
void CutLeaves<dim>::match_fine_side(const HangingFace<dim> &face,
                                     const unsigned int part)
{
  const unsigned int leaf = face.fine_leaf[part];
  const unsigned int side = face.match.face;
  if (fractions_.is_closed(leaf))
    return;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    const double open = hanging_opening(face, part, q);
    if (open != opening({leaf, layout_.face_point(side, q, 0)}, side))
      own_shape(leaf)
        .opening[side / 2]
                [(side % 2 ? layout_.n : 0) * layout_.n_face_points + q] = open;
  }
}


template class CutLeaves<2>;
template class CutLeaves<3>;
} // namespace contrecoup::gas
