// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/leaf_kernel.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>
#include <contrecoup/numerics/scheme/trouble_indicator.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/**
 * What the discontinuous Galerkin kernels on boxes and on leaves of any
 * shape share: the values at the nodes of one batch, how much of them finite
 * volumes take over, limited slopes in the nodes' subcells, and the end of a
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
  using Real = typename Number::value_type;
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
      weight_[i] = basis_.weights()[i];
      subface_[i + 1] = subface_[i] + weight_[i];
      center_[i] = 0.5 * (subface_[i] + subface_[i + 1]);
    }
    for (unsigned int i = 1; i < n; ++i)
      inverse_distance_[i] = 1. / (center_[i] - center_[i - 1]);
    inverse_distance_[0] = inverse_distance_[n] = 1. / (2. * center_[0]);
    for (unsigned int i = 0; i < n; ++i)
      slope_weights_.emplace_back(1. / inverse_distance_[i],
                                  1. / inverse_distance_[i + 1],
                                  center_[i] - subface_[i],
                                  subface_[i + 1] - center_[i]);
  }

  /// Reads the bound leaves from @p state.
  void load(const Real *state);

  /// Finds how much finite volumes take over, @p least or more.
  void set_blending(const Number &least = Number(0.));

  /**
   * Limited slopes, per relative length, in the subcells of a line.
   *
   * @param line primitive values
   * @param beyond the next values before and after them
   */
  Line subcell_slopes(const Line &line,
                      const std::array<Values, 2> &beyond) const;

  /// Admissible left and right state at face @p f between subcells.
  std::array<Values, 2> subcell_traces(const unsigned int f,
                                       const Line &line,
                                       const Line &slope) const;

  /// Adds the residual, restores positivity and writes the new state.
  void finish(const BasicStage<Real> &stage);

  /// What stage.sensor_out takes, of the values that load() read.
  Number blending_factor() const;

  const LobattoBasis basis_;
  const TroubleIndicator<dim, n> indicator_;
  std::array<double, n> weight_;
  std::array<double, n + 1> subface_; ///< ends of the nodes' subcells
  /// Middle of each subcell, for which its nodal value stands there.
  std::array<double, n> center_;
  /// From the middle before to that of subcell i, likewise behind the last.
  std::array<double, n + 1> inverse_distance_;
  std::vector<SlopeWeights> slope_weights_;

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
  void bound_products();
  void restore_positivity(const BasicStage<Real> &stage);
  Values mean() const;
  void scale_to_mean(const Values &mean,
                     const Number &theta,
                     const bool densities_only);
};
} // namespace contrecoup::gas
