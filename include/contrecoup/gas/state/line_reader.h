// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/octree/neighbor_reader.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Primitive variables as input of the sensors: for one batch of leaves at a
 * time, at its points and along lines of points, with one more point beyond
 * either end. The pressure is the exerted one; see Burn.
 */
template <int dim, typename Gas, typename Real>
class LineReader
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int n_variables = n_conserved<dim, Gas>;
  using Values = std::array<Number, n_variables>;

  /// The arguments must outlive this object; ghosts of @p field must be up to
  /// date.
  LineReader(const LeafMesh<dim> &mesh,
             const LeafPoints<dim> &points,
             const Gas &gas,
             const GasField &field)
    : mesh_(mesh)
    , points_(points)
    , gas_(gas)
    , field_(field)
    , layout_(field.layout())
    , primitive_(n_variables * layout_.n_points)
  {
    for (unsigned int i = 0; i <= layout_.n; ++i)
      distance_.push_back(distance_after(i));
  }

  /// Converts the leaves of @p batch to primitive variables.
  void bind(const unsigned int batch)
  {
    batch_ = batch;
    const Real *state =
      field_.template state<Real>() + batch * layout_.batch_size();
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      Values u;
      for (unsigned int c = 0; c < n_variables; ++c)
        u[c].load(state + layout_.value(c, q));
      Values p = to_primitive<dim>(gas_, u);
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
        apply_burn_pressure(batch * n_lanes<Real> + lane, q, lane, p);
      for (unsigned int c = 0; c < n_variables; ++c)
        primitive_[c * layout_.n_points + q] = p[c];
    }
    for (unsigned int face = 0; face < 2 * dim; ++face)
      neighbors_[face].reinit(mesh_.neighbors(batch, face), layout_);
  }

  const LeafLayout &layout() const
  {
    return layout_;
  }

  /// Values of a variable at all points.
  const Number *values(const unsigned int variable) const
  {
    return &primitive_[variable * layout_.n_points];
  }

  /// Edge lengths of the leaves in a direction [m].
  Number extent(const unsigned int direction) const
  {
    return mesh_.template extents<Real>(batch_)[direction];
  }

  /// Distance from entry @p i of a line to the next, in edge lengths of the
  /// leaf [-].
  double distance(const unsigned int i) const
  {
    return distance_[i];
  }

  /**
   * Reads some variables along a line of points.
   *
   * @param lines output, layout().n + 2 entries per variable: one point beyond
   * the lower end, the points of the line, one beyond the upper end. At
   * special faces the entry beyond the end is extrapolated linearly.
   */
  template <std::size_t n_lines>
  void read(const unsigned int direction,
            const unsigned int line,
            const std::array<unsigned int, n_lines> &variables,
            const std::array<Number *, n_lines> &lines) const
  {
    const unsigned int n = layout_.n;
    const unsigned int first = layout_.face_point(2 * direction, line, 0);
    const Values below = beyond(2 * direction, line);
    const Values above = beyond(2 * direction + 1, line);
    for (std::size_t k = 0; k < n_lines; ++k)
    {
      lines[k][0] = below[variables[k]];
      for (unsigned int i = 0; i < n; ++i)
        lines[k][i + 1] =
          values(variables[k])[first + i * layout_.stride(direction)];
      lines[k][n + 1] = above[variables[k]];
    }
    for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
         ++s)
      if (s->face / 2 == direction)
        for (Number *values : lines)
          go_on_linearly(values, s->face % 2, s->lane);
  }

private:
  /// Replaces the pressure in @p p by the exerted pressure.
  void apply_burn_pressure(const unsigned int leaf,
                           const unsigned int point,
                           const unsigned int lane,
                           Values &p) const
  {
    Number &pressure = p[Component<dim>::pressure];
    if (field_.burn() != nullptr)
      pressure[lane] =
        field_.exerted_pressure(pressure[lane], field_.burned(leaf, point));
  }

  /// Primitive variables of the next point across a face; a Galerkin node that
  /// coincides with the leaf's own is skipped.
  Values beyond(const unsigned int face, const unsigned int line) const
  {
    const unsigned int depth =
      points_.is_galerkin() ? std::min(1U, layout_.n - 1) : 0;
    const unsigned int point = layout_.face_point(face ^ 1U, line, depth);
    Values u;
    for (unsigned int c = 0; c < n_variables; ++c)
      u[c] = neighbors_[face].read(field_.template state<Real>() +
                                   layout_.value(c, point));
    Values p = to_primitive<dim>(gas_, u);
    for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
      apply_burn_pressure(mesh_.neighbors(batch_, face)[lane], point, lane, p);
    return p;
  }

  void go_on_linearly(Number *values,
                      const unsigned int side,
                      const unsigned int lane) const
  {
    const unsigned int n = layout_.n;
    const unsigned int next = side == 1 ? n : 1;
    const unsigned int inner = n == 1 ? next : (side == 1 ? n - 1 : 2);
    values[side == 1 ? n + 1 : 0][lane] =
      2. * values[next][lane] - values[inner][lane];
  }

  double distance_after(const unsigned int i) const
  {
    const unsigned int n = layout_.n;
    if (n == 1)
      return 1.;
    if (!points_.is_galerkin())
      return 1. / n;
    const unsigned int from = i == 0 ? 0 : (i == n ? n - 2 : i - 1);
    return points_.position(from + 1) - points_.position(from);
  }

  const LeafMesh<dim> &mesh_;
  const LeafPoints<dim> &points_;
  const Gas gas_;
  const GasField &field_;
  const LeafLayout layout_;
  unsigned int batch_ = 0;
  dealii::AlignedVector<Number> primitive_; ///< [variable][point]
  std::array<NeighborReader<Real>, 2 * dim> neighbors_;
  std::vector<double> distance_;
};
} // namespace contrecoup::gas
