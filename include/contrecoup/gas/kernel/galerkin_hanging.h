// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/stage.h>
#include <contrecoup/gas/octree/hanging_group.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/state/primitive.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Fluxes of hanging faces for the discontinuous Galerkin scheme on
 * axis-aligned leaves, by mortars: the coarse trace is interpolated to the
 * nodes of each fine face, the flux computed there once, and its L2
 * projection given to the coarse side (Kopriva 1996), which keeps the
 * integral.
 */
template <int dim, typename Gas, typename Real = double>
class GalerkinHanging
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;

  GalerkinHanging(const LeafLayout &layout,
                  const Scheme &scheme,
                  const Gas &gas);

  void compute(const HangingGroup<dim> &group,
               const BasicStage<Real> &stage,
               HangingData<dim, Real> &hanging);

private:
  static constexpr unsigned int n_fine = HangingFace<dim>::n_fine;
  using Trace = dealii::AlignedVector<Values>;

  Values gather(const Real *state,
                const unsigned int *offsets,
                const unsigned int point) const;
  void restore_positivity();
  void part_fluxes(const HangingGroup<dim> &group, const unsigned int part);
  void conserve_radially(const HangingGroup<dim> &group, const Values &base);
  void store(const HangingGroup<dim> &group,
             HangingData<dim, Real> &hanging) const;
  unsigned int fine_point(const HangingGroup<dim> &group,
                          const unsigned int point) const;
  /// Adds to @p to the difference of @p from and @p base after the matrix of
  /// that half was applied to it in each direction of the face. Equal values
  /// then stay what they are, to the last bit.
  template <typename Matrices>
  void apply(const Matrices &matrices,
             const unsigned int part,
             const Values &base,
             const Trace &from,
             Trace &to) const;

  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  const LobattoBasis basis_;
  std::vector<double> subcell_begin_; ///< relative, from 0 to 1

  Trace coarse_;                   ///< conserved, at the coarse nodes
  Trace mortar_;                   ///< the same at the fine nodes
  std::array<Trace, n_fine> fine_; ///< conserved, coarse numbering
  std::array<Trace, n_fine> fine_flux_;
  Trace coarse_flux_;
};
} // namespace contrecoup::gas
