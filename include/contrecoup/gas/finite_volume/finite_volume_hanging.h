// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/hanging_traces.h>

namespace contrecoup::gas
{
/**
 * Fluxes and halo values of hanging faces for the finite-volume scheme on
 * axis-aligned leaves. The flux is computed once for each fine subcell
 * face, from a linear reconstruction on both sides; the coarse side gets
 * the mean of the fluxes over its face's area, so that nothing is lost.
 */
template <int dim, typename Gas, typename Real = double>
class FiniteVolumeHanging : private HangingTraces<dim, Gas, Real>
{
public:
  using Base = HangingTraces<dim, Gas, Real>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;

  /// @param primitives of the state that stages read
  FiniteVolumeHanging(const OperatorContext<dim> &context,
                      const Gas &gas,
                      PrimitiveField<dim, Gas, Real> &primitives);

  /// @param openings where a rigid body is, what it leaves open: differences
  /// across closed faces count as zero in the limiter, and the coarse side gets
  /// the mean over what is open
  void compute(const HangingGroup<dim> &group,
               const BasicStage<Real> &stage,
               HangingData<dim, Real> &hanging,
               const HangingOpenings<dim, Real> *openings = nullptr);

private:
  using Base::coarse_flux_;
  using Base::fine_flux_;
  using Base::gas_;
  using Base::layout_;
  using Base::n_fine;
  using Base::nc;
  using Base::open_sum_;
  using Base::openings_;
  using Base::scheme_;

  void part_fluxes(const HangingGroup<dim> &group, const unsigned int part);
  Number inner_radii(const HangingGroup<dim> &group) const;
  void average_fluxes(const HangingGroup<dim> &group);
  void average_open_fluxes(const HangingGroup<dim> &group);

  dealii::AlignedVector<Values> first_flux_; ///< of each coarse subcell face
};
} // namespace contrecoup::gas
