// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/cut_cell.h>
#include <contrecoup/gas/body/leaf_shape.h>
#include <contrecoup/gas/octree/lattice.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// A grid of values at the corners or centres of subcells, and where they
  /// are.
  template <int dim>
  struct Grid
  {
    Grid(const LeafBox<dim> &box,
         const unsigned int n_cells,
         const double shift,
         const unsigned int n,
         const RigidBody &body)
      : n(n)
    {
      const double smallest = box.extents.norm() / n_cells * 1e-12;
      values.resize(dealii::Utilities::pow(n, dim));
      for (unsigned int i = 0; i < values.size(); ++i)
      {
        dealii::Point<dim> place = box.origin;
        const auto index = lattice_indices<dim>(i, n);
        for (unsigned int d = 0; d < dim; ++d)
          place[d] += box.extents[d] * ((index[d] + shift) / n_cells);
        const double value = body.value(place);
        values[i] = std::abs(value) < smallest ? 0. : value;
      }
    }

    /// Index of the value at these places along the directions.
    unsigned int index(const std::array<unsigned int, dim> &place) const
    {
      unsigned int result = 0;
      for (unsigned int d = dim; d-- > 0;)
        result = result * n + place[d];
      return result;
    }

    unsigned int n;
    std::vector<double> values;
  };


  /// Mean radius of the open part of an edge along the radius, in parts of that
  /// in its middle.
  /// @param inner inner radius of the leaf [m]
  /// @param length of the edge [m]
  /// @param index of the edge in the leaf
  /// @param part that is open
  /// @param is_inner whether this part is next to its inner end
  double open_radius(const double inner,
                     const double length,
                     const unsigned int index,
                     const double part,
                     const bool is_inner)
  {
    const double begin = inner + index * length;
    const double middle = is_inner ? 0.5 * part : 1. - 0.5 * part;
    return (begin + middle * length) / (begin + 0.5 * length);
  }


  /// Calls function(layer, point) for all faces across a direction.
  template <typename Function>
  void for_each_face(const LeafLayout &layout,
                     const unsigned int direction,
                     const Function &function)
  {
    for (unsigned int layer = 0; layer <= layout.n; ++layer)
      for (unsigned int line = 0; line < layout.n_face_points; ++line)
        // The cell above the face, or the one below the last layer.
        function(layer,
                 layout.face_point(
                   2 * direction, line, std::min(layer, layout.n - 1)));
  }
} // namespace


template <int dim>
bool LeafShape<dim>::is_open() const
{
  const auto all_one = [](const std::vector<double> &values) {
    return std::all_of(
      values.begin(), values.end(), [](const double x) { return x == 1.; });
  };
  return all_one(fraction) &&
         std::all_of(opening.begin(), opening.end(), all_one);
}


template <int dim>
LeafShape<dim> cut_shape(const LeafBox<dim> &box,
                         const LeafLayout &layout,
                         const RigidBody &body,
                         const bool is_axisymmetric)
{
  constexpr unsigned int n_corners = 1U << dim;
  const Grid<dim> grid(box, layout.n, 0., layout.n + 1, body);
  std::array<unsigned int, n_corners> corner;
  for (unsigned int v = 0; v < n_corners; ++v)
    corner[v] = grid.index(lattice_indices<dim>(v, 2));
  LeafShape<dim> shape;
  for (unsigned int q = 0; q < layout.n_points; ++q)
  {
    const unsigned int first = grid.index(lattice_indices<dim>(q, layout.n));
    std::array<double, n_corners> values;
    for (unsigned int v = 0; v < n_corners; ++v)
      values[v] = grid.values[first + corner[v]];
    // No smaller number, so that changes can be divided by it.
    const double fraction = positive_fraction<n_corners>(values);
    shape.fraction.push_back(fraction > 0. ? std::max(fraction, 1e-14) : 0.);
  }
  for (unsigned int d = 0; d < dim; ++d)
    for_each_face(
      layout, d, [&](const unsigned int layer, const unsigned int q) {
        auto place = lattice_indices<dim>(q, layout.n);
        place[d] = layer;
        const unsigned int first = grid.index(place);
        std::array<double, n_corners / 2> values;
        for (unsigned int v = 0; v < n_corners / 2; ++v)
          values[v] =
            grid.values[first + corner[face_corner<dim>(2 * d, v % 2, v / 2)]];
        double fraction = positive_fraction<n_corners / 2>(values);
        if (d == 1 && is_axisymmetric)
          fraction *= open_radius(box.origin[0],
                                  box.extents[0] / layout.n,
                                  place[0],
                                  fraction,
                                  values[0] > 0.);
        shape.opening[d].push_back(fraction);
      });
  return shape;
}


template <int dim>
LeafShape<dim> staircase_shape(const LeafBox<dim> &box,
                               const LeafLayout &layout,
                               const RigidBody &body)
{
  // Centres from one before the first to one behind the last.
  const Grid<dim> grid(box, layout.n, -0.5, layout.n + 2, body);
  const auto is_open = [&](std::array<unsigned int, dim> place) {
    for (unsigned int &i : place)
      ++i;
    return grid.values[grid.index(place)] > 0. ? 1. : 0.;
  };
  LeafShape<dim> shape;
  for (unsigned int q = 0; q < layout.n_points; ++q)
    shape.fraction.push_back(is_open(lattice_indices<dim>(q, layout.n)));
  for (unsigned int d = 0; d < dim; ++d)
    for_each_face(
      layout, d, [&](const unsigned int layer, const unsigned int q) {
        auto place = lattice_indices<dim>(q, layout.n);
        place[d] = layer;
        auto below = place;
        --below[d];
        shape.opening[d].push_back(is_open(place) * is_open(below));
      });
  return shape;
}


#define CONTRECOUP_INSTANTIATE(dim)                                     \
  template struct LeafShape<dim>;                                       \
  template LeafShape<dim> cut_shape(                                    \
    const LeafBox<dim> &, const LeafLayout &, const RigidBody &, bool); \
  template LeafShape<dim> staircase_shape(                              \
    const LeafBox<dim> &, const LeafLayout &, const RigidBody &)

CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
