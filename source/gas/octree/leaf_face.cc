// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_face.h>

#include <deal.II/base/exceptions.h>

namespace contrecoup::gas
{
template <int dim>
FaceMatch
match_faces(const typename dealii::Triangulation<dim>::cell_iterator &cell,
            const unsigned int face,
            const typename dealii::Triangulation<dim>::cell_iterator &neighbor,
            const unsigned int neighbor_face)
{
  FaceMatch match;
  match.face = neighbor_face;
  const unsigned int n_corners = 1U << (dim - 1);
  const unsigned int n_candidates = dim == 3 ? 8 : (dim == 2 ? 2 : 1);
  for (unsigned int candidate = 0; candidate < n_candidates; ++candidate)
  {
    // In 2-D only the reversal of a exists.
    match.orientation = dim == 2 ? 2 * candidate : candidate;
    bool agrees = true;
    for (unsigned int corner = 0; corner < n_corners && agrees; ++corner)
    {
      const unsigned int i = corner % 2, j = corner / 2;
      const unsigned int other =
        dim == 1 ? 0 : matched_face_point(match.orientation, i, j, 2);
      agrees = cell->vertex_index(face_corner<dim>(face, i, j)) ==
               neighbor->vertex_index(
                 face_corner<dim>(neighbor_face, other % 2, other / 2));
    }
    if (agrees)
      return match;
  }
  AssertThrow(false, dealii::ExcMessage("faces do not share their vertices"));
  return match;
}


// Linear along either coordinate: the middle of a rectangle stands for all of
// it.
template <int dim>
dealii::Tensor<1, dim>
outward_area(const typename dealii::Triangulation<dim>::cell_iterator &cell,
             const unsigned int face,
             const double a,
             const double b)
{
  const auto vertex = [&](const unsigned int i, const unsigned int j) {
    return cell->vertex(face_corner<dim>(face, i, j));
  };
  // The other directions of a face across y are in reverse cyclic order.
  const double sign = (face % 2 == 1) == (face / 2 != 1) ? 1. : -1.;
  const dealii::Tensor<1, dim> low = vertex(1, 0) - vertex(0, 0);
  if constexpr (dim == 2)
    return sign * dealii::cross_product_2d(low);
  else
  {
    const dealii::Tensor<1, dim> high = vertex(1, 1) - vertex(0, 1);
    const dealii::Tensor<1, dim> left = vertex(0, 1) - vertex(0, 0);
    const dealii::Tensor<1, dim> right = vertex(1, 1) - vertex(1, 0);
    return sign * dealii::cross_product_3d(low + b * (high - low),
                                           left + a * (right - left));
  }
}


template dealii::Tensor<1, 2>
outward_area(const dealii::Triangulation<2>::cell_iterator &,
             unsigned int,
             double,
             double);
template dealii::Tensor<1, 3>
outward_area(const dealii::Triangulation<3>::cell_iterator &,
             unsigned int,
             double,
             double);
template FaceMatch
match_faces<1>(const dealii::Triangulation<1>::cell_iterator &,
               unsigned int,
               const dealii::Triangulation<1>::cell_iterator &,
               unsigned int);
template FaceMatch
match_faces<2>(const dealii::Triangulation<2>::cell_iterator &,
               unsigned int,
               const dealii::Triangulation<2>::cell_iterator &,
               unsigned int);
template FaceMatch
match_faces<3>(const dealii::Triangulation<3>::cell_iterator &,
               unsigned int,
               const dealii::Triangulation<3>::cell_iterator &,
               unsigned int);
} // namespace contrecoup::gas
