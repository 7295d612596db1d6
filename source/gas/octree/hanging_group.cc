// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/hanging_group.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace contrecoup::gas
{
namespace
{
  template <int dim>
  auto kind_of(const HangingFace<dim> &face)
  {
    return std::make_tuple(
      face.coarse_face, face.match.face, face.match.orientation);
  }

  template <int dim>
  void fill_lane(HangingGroup<dim> &group,
                 const unsigned int lane,
                 const unsigned int index,
                 const LeafMesh<dim> &mesh,
                 const LeafLayout &layout)
  {
    const HangingFace<dim> &face = mesh.hanging_faces()[index];
    group.face[lane] = index;
    group.inner_radius[lane] = relative_inner_radius(mesh, face);
    group.is_radial =
      group.is_radial || std::isfinite(group.inner_radius[lane]);
    group.coarse_leaf[lane] = face.coarse_leaf;
    group.coarse_offset[lane] = layout.offset(face.coarse_leaf);
    unsigned int present = no_leaf;
    for (const unsigned int leaf : face.fine_leaf)
      if (leaf != no_leaf)
        present = leaf;
    const auto count = [&](const unsigned int leaf) {
      if (leaf < mesh.n_owned())
        group.first_batch = std::min(group.first_batch, leaf / layout.width);
    };
    count(face.coarse_leaf);
    std::for_each(face.fine_leaf.begin(), face.fine_leaf.end(), count);
    for (unsigned int part = 0; part < face.n_fine; ++part)
    {
      const unsigned int leaf =
        face.fine_leaf[part] != no_leaf ? face.fine_leaf[part] : present;
      group.fine_leaf[part][lane] = leaf;
      group.fine_offset[part][lane] = layout.offset(leaf);
    }
  }
} // namespace


template <int dim>
double relative_inner_radius(const LeafMesh<dim> &mesh,
                             const HangingFace<dim> &face)
{
  const unsigned int leaf = face.coarse_leaf;
  if (radial_exponent(mesh.coarse_mesh().geometry()) == 0 ||
      face.coarse_face / 2 == 0 || leaf >= mesh.n_owned())
    return std::numeric_limits<double>::infinity();
  return mesh.origins(leaf / double_width)[0][leaf % double_width] /
         mesh.extents(leaf / double_width)[0][leaf % double_width];
}


template <int dim>
std::vector<HangingGroup<dim>> group_hanging_faces(const LeafMesh<dim> &mesh,
                                                   const LeafLayout &layout)
{
  const auto &faces = mesh.hanging_faces();
  std::vector<unsigned int> order(faces.size());
  for (unsigned int i = 0; i < order.size(); ++i)
    order[i] = i;
  std::stable_sort(order.begin(),
                   order.end(),
                   [&](const unsigned int i, const unsigned int j) {
                     return kind_of(faces[i]) < kind_of(faces[j]);
                   });

  std::vector<HangingGroup<dim>> groups;
  for (const unsigned int index : order)
  {
    const auto &face = faces[index];
    if (groups.empty() || groups.back().n_filled == layout.width ||
        groups.back().coarse_face != face.coarse_face ||
        !(groups.back().match == face.match))
    {
      groups.emplace_back();
      groups.back().coarse_face = face.coarse_face;
      groups.back().match = face.match;
      for (unsigned int lane = 0; lane < layout.width; ++lane)
        fill_lane(groups.back(), lane, index, mesh, layout);
    }
    fill_lane(groups.back(), groups.back().n_filled++, index, mesh, layout);
  }
  std::stable_sort(
    groups.begin(), groups.end(), [](const auto &a, const auto &b) {
      return a.first_batch < b.first_batch;
    });
  return groups;
}


#define CONTRECOUP_INSTANTIATE(dim)                                \
  template double relative_inner_radius(const LeafMesh<dim> &,     \
                                        const HangingFace<dim> &); \
  template std::vector<HangingGroup<dim>> group_hanging_faces(     \
    const LeafMesh<dim> &, const LeafLayout &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
