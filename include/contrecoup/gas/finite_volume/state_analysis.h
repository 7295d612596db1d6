// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/leaf_kernel.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Computes shock sensor and signal rate of a new state, reports unphysical
 * leaves and fills padding lanes; for finite volumes on boxes.
 */
template <int dim, typename Gas, typename Real = double>
class StateAnalysis
{
public:
  using Leaves = LeafKernel<dim, Gas, Real>;
  using Number = typename Leaves::Number;
  using Values = typename Leaves::Values;
  using C = Component<dim>;

  StateAnalysis(const LeafMesh<dim> &mesh,
                const LeafLayout &layout,
                const Gas &gas,
                Leaves &leaves)
    : mesh_(mesh)
    , layout_(layout)
    , gas_(gas)
    , leaves_(leaves)
    , primitive_(Leaves::nc * layout.n_points)
  {}

  /// Reports unphysical leaves of @p batch in stage.results.state, fills its
  /// padding lanes and, where stage.results.signal_rate is asked for, computes
  /// that and stage.results.sensor.
  /// @param weight see analyse()
  template <typename Weight>
  void conclude(const unsigned int batch,
                const BasicStage<Real> &stage,
                const Weight &weight)
  {
    Real *values = stage.results.state + batch * layout_.batch_size();
    fill_padding(batch, values);
    const bool converts = stage.results.signal_rate != nullptr;
    report(batch,
           converts ? load<true, true>(values) : load<true, false>(values),
           stage);
    if (converts)
      find_rate_and_sensor(batch, stage, weight);
  }

  /// Computes stage.results.sensor and stage.results.signal_rate of
  /// stage.results.state in @p batch.
  /// @param weight weight(direction, point) is the factor of the pressure jump
  /// between the point and the next
  template <typename Weight>
  void analyse(const unsigned int batch,
               const BasicStage<Real> &stage,
               const Weight &weight)
  {
    load<false, true>(stage.results.state + batch * layout_.batch_size());
    find_rate_and_sensor(batch, stage, weight);
  }

  /// Padding lanes of the batch copy the first, so that they never overflow.
  void fill_padding(const unsigned int batch, Real *out) const
  {
    for (unsigned int lane = mesh_.n_filled_lanes(batch); lane < Leaves::width;
         ++lane)
      for (std::size_t i = 0; i < layout_.batch_size(); i += Leaves::width)
        out[i + lane] = out[i];
  }

private:
  template <typename Weight>
  void find_rate_and_sensor(const unsigned int batch,
                            const BasicStage<Real> &stage,
                            const Weight &weight)
  {
    leaves_.bind_burn(batch, stage);
    find_largest_rate(stage).store(stage.results.signal_rate +
                                   batch * Leaves::width);
    const Number shock =
      select_less(Number(0.), largest_jump(weight), Number(1.), Number(0.));
    shock.store(stage.results.sensor + batch * Leaves::width);
  }

  /// Notes a leaf of the batch as unphysical where @p smallest has no positive
  /// number in its lane.
  void report(const unsigned int batch,
              const Number &smallest,
              const BasicStage<Real> &stage) const
  {
    for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch); ++lane)
      if (!(smallest[lane] > 0.))
        *stage.results.unphysical_leaf = batch * Leaves::width + lane;
  }

  /// Reads the values of a batch. With @p converts they become primitive_; with
  /// @p checks the result has no positive number in lanes with an unphysical
  /// point.
  template <bool checks, bool converts>
  Number load(const Real *values);
  /// Largest signal rate; the pressures become those that unburned explosive
  /// exerts.
  Number find_largest_rate(const BasicStage<Real> &stage);
  /// Largest positive jump of the pressure between neighbouring points beyond
  /// a tenth of it, in compressed gas.
  template <typename Weight>
  Number largest_jump(const Weight &weight) const;

  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Gas gas_;
  Leaves &leaves_;
  dealii::AlignedVector<Number> primitive_; ///< [component][point]
};


template <int dim, typename Gas, typename Real>
template <bool checks, bool converts>
typename StateAnalysis<dim, Gas, Real>::Number
StateAnalysis<dim, Gas, Real>::load(const Real *values)
{
  Number smallest(1.);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < Leaves::nc; ++c)
      u[c].load(values + layout_.value(c, q));
    if constexpr (checks)
      smallest = std::min(smallest, is_admissible<dim>(gas_, u));
    if constexpr (converts)
    {
      const Values p = to_primitive<dim>(gas_, u);
      for (unsigned int c = 0; c < Leaves::nc; ++c)
        primitive_[c * layout_.n_points + q] = p[c];
    }
  }
  return smallest;
}


template <int dim, typename Gas, typename Real>
typename StateAnalysis<dim, Gas, Real>::Number
StateAnalysis<dim, Gas, Real>::find_largest_rate(const BasicStage<Real> &stage)
{
  const unsigned int batch = leaves_.batch();
  const Burn *burn = leaves_.burn();
  Number rate(0.);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values p;
    for (unsigned int c = 0; c < Leaves::nc; ++c)
      p[c] = primitive_[c * layout_.n_points + q];
    Number least_speed(0.);
    if (burn != nullptr)
    {
      const Number burned =
        burn->fraction(leaves_.progress(q, stage.end_time), p[C::density]);
      least_speed = (Number(1.) - burned) * burn->speed;
      primitive_[C::pressure * layout_.n_points + q] =
        burn->pressure(p[C::pressure], burned);
    }
    rate =
      std::max(rate,
               signal_rate<dim>(
                 gas_, p, mesh_.template extents<Real>(batch), least_speed));
  }
  return rate;
}


template <int dim, typename Gas, typename Real>
template <typename Weight>
typename StateAnalysis<dim, Gas, Real>::Number
StateAnalysis<dim, Gas, Real>::largest_jump(const Weight &weight) const
{
  const double threshold = 0.1;
  Number shock(0.);
  for (unsigned int d = 0; d < dim; ++d)
  {
    const unsigned int s = layout_.stride(d);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      if ((q / s) % layout_.n + 1 < layout_.n)
      {
        const Number *p = &primitive_[C::pressure * layout_.n_points + q];
        const Number *u = &primitive_[(C::velocity + d) * layout_.n_points + q];
        const Number jump =
          (std::abs(p[s] - p[0]) - std::min(p[0], p[s]) * threshold) *
          weight(d, q);
        shock = std::max(shock, select_less(u[s], u[0], jump, Number(0.)));
      }
  }
  return shock;
}
} // namespace contrecoup::gas
