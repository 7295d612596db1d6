// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_box.h>

#include <deal.II/base/geometry_info.h>
#include <deal.II/base/quadrature_lib.h>

namespace contrecoup::gas
{
template <int dim>
dealii::Point<dim> LeafBox<dim>::place(const dealii::Point<dim> &x) const
{
  if (curved_shapes != nullptr)
    return curved_shapes->place(cell, x);
  if (!is_box())
  {
    dealii::Point<dim> result;
    for (unsigned int v = 0; v < vertices.size(); ++v)
      result +=
        dealii::GeometryInfo<dim>::d_linear_shape_function(x, v) * vertices[v];
    return result;
  }
  dealii::Point<dim> result = origin;
  for (unsigned int d = 0; d < dim; ++d)
    result[d] += extents[d] * x[d];
  return result;
}


template <int dim>
double LeafBox<dim>::jacobian(const dealii::Point<dim> &x) const
{
  if (curved_shapes != nullptr)
    return dealii::determinant(curved_shapes->derivative(cell, x));
  dealii::Tensor<2, dim> derivative;
  for (unsigned int v = 0; v < vertices.size(); ++v)
    derivative += dealii::outer_product(
      vertices[v],
      dealii::GeometryInfo<dim>::d_linear_shape_function_gradient(x, v));
  if (is_box())
    for (unsigned int d = 0; d < dim; ++d)
      derivative[d][d] = extents[d];
  return dealii::determinant(derivative);
}


template <int dim>
double point_volume(const LeafBox<dim> &box,
                    const LeafPoints<dim> &points,
                    const unsigned int q)
{
  if (box.is_box())
    return points.volume(box.origin, box.extents, q);
  const auto index = points.indices(q);
  double sum = 0.;
  // Exact for the Jacobian of a multilinear map.
  const dealii::QGauss<dim> samples(2);
  for (unsigned int s = 0; s < samples.size(); ++s)
  {
    dealii::Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double begin = points.subcell_begin(index[d]);
      const double end = points.subcell_end(index[d]);
      x[d] = begin + samples.point(s)[d] * (end - begin);
    }
    sum += samples.weight(s) * box.jacobian(x);
  }
  return sum * points.relative_volume(q);
}


template <int dim>
LeafBox<dim> leaf_box(const LeafMesh<dim> &mesh, const unsigned int leaf)
{
  LeafBox<dim> box;
  if (!mesh.coarse_mesh().is_axis_aligned())
  {
    const auto &cell = mesh.cell(leaf);
    for (const unsigned int v : cell->vertex_indices())
      box.vertices.push_back(cell->vertex(v));
    const auto around = cell->bounding_box().get_boundary_points();
    box.origin = around.first;
    box.extents = around.second - around.first;
    box.curved_shapes = mesh.curved_shapes();
    box.cell = cell->active_cell_index();
    return box;
  }
  for (unsigned int d = 0; d < dim; ++d)
  {
    box.origin[d] = mesh.origins(leaf / double_width)[d][leaf % double_width];
    box.extents[d] = mesh.extents(leaf / double_width)[d][leaf % double_width];
  }
  return box;
}


template <int dim>
dealii::Tensor<1, dim> outward_area(const LeafMesh<dim> &mesh,
                                    const unsigned int leaf,
                                    const unsigned int face,
                                    const double a,
                                    const double b)
{
  const auto &cell = mesh.stored_cell(leaf);
  return mesh.curved_shapes() != nullptr
           ? mesh.curved_shapes()->outward_area(
               cell->active_cell_index(), face, a, b)
           : outward_area<dim>(cell, face, a, b);
}


template dealii::Tensor<1, 2>
outward_area(const LeafMesh<2> &, unsigned int, unsigned int, double, double);
template dealii::Tensor<1, 3>
outward_area(const LeafMesh<3> &, unsigned int, unsigned int, double, double);

#define CONTRECOUP_INSTANTIATE(dim)                               \
  template struct LeafBox<dim>;                                   \
  template double point_volume(                                   \
    const LeafBox<dim> &, const LeafPoints<dim> &, unsigned int); \
  template LeafBox<dim> leaf_box(const LeafMesh<dim> &, unsigned int)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
