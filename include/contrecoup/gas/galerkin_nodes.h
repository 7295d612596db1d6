// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/leaf_kernel.h>
#include <contrecoup/numerics/lobatto_basis.h>
#include <contrecoup/numerics/trouble_indicator.h>

#include <array>

namespace contrecoup::gas
{
/**
 * What the discontinuous Galerkin kernels on boxes and on leaves of any
 * shape share: the values at the nodes of one batch, how much of them finite
 * volumes take over, limited slopes along lines of nodes, and the end of a
 * stage, which scales towards the mean where a node would lose positivity
 * (Zhang and Shu 2010).
 *
 * @tparam LeafBase LeafKernel or MappedLeafKernel, which it derives from
 */
template <int dim, int n, typename Gas, typename LeafBase>
class GalerkinNodes : protected LeafBase
{
public:
  using Number = typename LeafBase::Number;
  using Values = typename LeafBase::Values;
  using C = Component<dim>;

protected:
  using LeafBase::batch_;
  using LeafBase::gas_;
  using LeafBase::layout_;
  using LeafBase::mesh_;
  using LeafBase::nc;
  using LeafBase::scheme_;
  static constexpr unsigned int n_points = dealii::Utilities::pow(n, dim);
  static constexpr unsigned int n_lines = n_points / n;
  using Line = std::array<Values, n>;

  /// @param more what LeafBase takes after the boundary
  template <typename Geometry>
  GalerkinNodes(const LeafMesh<dim> &mesh,
                const LeafLayout &layout,
                const Scheme &scheme,
                const Gas &gas,
                const Boundary<dim> &boundary,
                const Geometry &more)
    : LeafBase(mesh, layout, scheme, gas, boundary, more)
    , basis_(n)
    , indicator_(basis_, scheme.indicator_threshold)
  {
    subface_[0] = 0.;
    for (unsigned int i = 0; i < n; ++i)
    {
      node_[i] = basis_.nodes()[i];
      weight_[i] = basis_.weights()[i];
      subface_[i + 1] = subface_[i] + weight_[i];
      if (i > 0)
        inverse_distance_[i] = 1. / (node_[i] - node_[i - 1]);
    }
    inverse_distance_[0] = inverse_distance_[n] = inverse_distance_[1];
  }

  /// Reads the bound leaves from @p state.
  void load(const double *state);

  void set_blending();

  /**
   * Limited slopes, per relative length, of the values along a line.
   *
   * @param line primitive values
   * @param beyond the next values before and after them
   * @param inverse_distance of each to the one before, from the first to
   * @p beyond[1]; double or Number
   */
  template <typename Distance>
  Line
  subcell_slopes(const Line &line,
                 const std::array<Values, 2> &beyond,
                 const std::array<Distance, n + 1> &inverse_distance) const;

  /// Admissible left and right state at face @p f between subcells, for
  /// values that stand at the relative places @p place.
  template <typename Places>
  std::array<Values, 2> subcell_traces(const unsigned int f,
                                       const Line &line,
                                       const Line &slope,
                                       const Places &place) const;

  /// Adds the residual, restores positivity and writes the new state.
  void finish(const Stage &stage);

  /// What stage.sensor_out takes, of the values that load() read.
  Number blending_factor() const;

  const LobattoBasis basis_;
  const TroubleIndicator<dim, n> indicator_;
  std::array<double, n> node_;
  std::array<double, n> weight_;
  std::array<double, n + 1> subface_;
  std::array<double, n + 1> inverse_distance_; ///< see subcell_slopes()

  bool any_blending_ = false;
  Number blending_;
  Number reference_pressure_;
  std::array<std::array<Number, n_points>, nc> conserved_;
  std::array<std::array<Number, n_points>, nc> primitive_;
  std::array<std::array<Number, n_points>, nc> residual_; ///< rate of change
  /// What the nodes stand for where it is not the product of the weights.
  bool has_volumes_ = false;
  std::array<Number, n_points> volume_;

private:
  void restore_positivity(const Stage &stage);
  Values mean() const;
  void scale_to_mean(const Values &mean,
                     const Number &theta,
                     const bool densities_only);
};


template <int dim, int n, typename Gas, typename LeafBase>
template <typename Distance>
typename GalerkinNodes<dim, n, Gas, LeafBase>::Line
GalerkinNodes<dim, n, Gas, LeafBase>::subcell_slopes(
  const Line &line,
  const std::array<Values, 2> &beyond,
  const std::array<Distance, n + 1> &inverse_distance) const
{
  Line slope;
  for (unsigned int c = 0; c < nc; ++c)
  {
    Number backward = (line[0][c] - beyond[0][c]) * inverse_distance[0];
    for (unsigned int i = 0; i < n; ++i)
    {
      const Number next = i + 1 < n ? line[i + 1][c] : beyond[1][c];
      const Number forward = (next - line[i][c]) * inverse_distance[i + 1];
      slope[i][c] = limited_slope(scheme_.limiter, backward, forward);
      backward = forward;
    }
  }
  return slope;
}


template <int dim, int n, typename Gas, typename LeafBase>
template <typename Places>
std::array<typename GalerkinNodes<dim, n, Gas, LeafBase>::Values, 2>
GalerkinNodes<dim, n, Gas, LeafBase>::subcell_traces(const unsigned int f,
                                                     const Line &line,
                                                     const Line &slope,
                                                     const Places &place) const
{
  std::array<Values, 2> traces;
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int i = f - 1 + side;
    for (unsigned int c = 0; c < nc; ++c)
      traces[side][c] = line[i][c] + slope[i][c] * (subface_[f] - place[i]);
    restore_if_inadmissible<dim>(gas_, line[i], traces[side]);
  }
  return traces;
}
} // namespace contrecoup::gas
