// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/hanging_traces.h>
#include <contrecoup/gas/stage/face_axes.h>

#include <deal.II/base/tensor.h>

namespace contrecoup::gas
{
/**
 * Fluxes and halo values of hanging faces for the finite-volume scheme on
 * leaves of any shape. A flux is computed once for each fine subcell face, in
 * its frame, and integrated over it; the coarse subcell gets the sum. Momentum
 * fluxes exclude the pressure of the subcell on that side. Fluxes of either
 * side are positive towards increasing index of that side.
 */
template <int dim, typename Gas, typename Real = double>
class MappedHanging : private HangingTraces<dim, Gas, Real>
{
public:
  using Base = HangingTraces<dim, Gas, Real>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;
  using C = Component<dim>;

  /// @param primitives of the state that stages read
  MappedHanging(const OperatorContext<dim> &context,
                const Gas &gas,
                PrimitiveField<dim, Gas, Real> &primitives);

  /// Measures the faces of all groups of @p mesh.
  void reinit(const LeafMesh<dim> &mesh,
              const std::vector<HangingGroup<dim>> &groups);

  /// Fills @p hanging for one of the groups of the last reinit().
  /// @param index number of @p group among them
  void compute(const unsigned int index,
               const HangingGroup<dim> &group,
               const BasicStage<Real> &stage,
               HangingData<dim, Real> &hanging);

private:
  using Vector = dealii::Tensor<1, dim, Number>;
  using Base::burn_;
  using Base::coarse_;
  using Base::coarse_flux_;
  using Base::fine_;
  using Base::fine_flux_;
  using Base::gas_;
  using Base::layout_;
  using Base::n_fine;
  using Base::nc;
  using Base::scheme_;

  /// From the coarse to the fine side, in the coarse numbering.
  Vector &
  area(const unsigned int group, const unsigned int part, const unsigned int q)
  {
    return areas_[(group * n_fine + part) * layout_.n_face_points + q];
  }
  void measure(const LeafMesh<dim> &mesh,
               const HangingGroup<dim> &group,
               const unsigned int index);
  void part_fluxes(const unsigned int index,
                   const HangingGroup<dim> &group,
                   const unsigned int part);
  /// Flux per area between two states along the axes of a face.
  Values flux_between(const unsigned int part,
                      const unsigned int q,
                      const Values &inside,
                      const Values &outside) const;
  /// Integral of a flux over a face, less the force of a pressure @p own.
  static Values
  integral(const FaceAxes<dim, Number> &axes, Values flux, const Number &own);
  Number exerted_pressure(const Values &state, const Number &progress) const;

  dealii::AlignedVector<Vector> areas_; ///< see area()
};
} // namespace contrecoup::gas
