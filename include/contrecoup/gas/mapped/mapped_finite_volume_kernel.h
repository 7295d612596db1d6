// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/mapped/mapped_leaf_kernel.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * One stage of the finite-volume scheme on one batch of leaves of any
 * shape: multilinear images of the cube, with neighbours in any
 * orientation. Primitive variables are reconstructed along the index lines
 * of the leaf, which are straight and evenly divided within it; the flux
 * through a subcell face is that of a Riemann problem in the frame of the face.
 *
 * With Scheme::gradient_limiter, one factor for each subcell and variable
 * limits the differences of all directions together; faces between leaves
 * are limited along the line in any case, so that both sides agree.
 *
 * Fluxes through hanging faces are those of MappedHanging.
 */
template <int dim, typename Gas, typename Real = double>
class MappedFiniteVolumeKernel : private MappedLeafKernel<dim, Gas, Real>
{
public:
  using Base = MappedLeafKernel<dim, Gas, Real>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;
  using C = Component<dim>;

  MappedFiniteVolumeKernel(const OperatorContext<dim> &context, const Gas &gas);

  /// Does @p stage on the leaves of @p batch.
  void update(const unsigned int batch,
              const BasicStage<Real> &stage,
              const HangingData<dim, Real> &hanging);

  /// Computes only sensor and signal rate of the state stage.results.state.
  void analyse(const unsigned int batch, const BasicStage<Real> &stage);

private:
  using Vector = typename Base::Vector;
  using Base::batch_;
  using Base::gas_;
  using Base::layout_;
  using Base::mesh_;
  using Base::nc;
  using Base::scheme_;
  static constexpr int n_beyond = Base::n_beyond;

  void load(const Real *state);
  void limit_gradients();
  void limit_increments(const int i, const unsigned int point);
  void sweep(const unsigned int direction,
             const HangingData<dim, Real> &hanging);
  void fill_line(const unsigned int direction, const unsigned int line);
  void reconstruct(const unsigned int direction, const unsigned int line);
  void line_fluxes(const unsigned int direction, const unsigned int line);
  /// Replaces fluxes through hanging faces at the ends of the line.
  void take_hanging_fluxes(const unsigned int direction,
                           const unsigned int line,
                           const HangingData<dim, Real> &hanging);
  void add_flux_differences(const unsigned int direction,
                            const unsigned int line);
  void finish(const BasicStage<Real> &stage);
  void store_sensors(const BasicStage<Real> &stage);
  /// Burned fraction of a point, where burn_ is set.
  Number burned(const unsigned int point, const double time) const;
  Number largest_signal_rate(const double time) const;
  Number shock_sensor() const;

  /// Cells of the line from -2 to n + 1.
  Values &cell(const int i)
  {
    return line_[i + n_beyond];
  }

  typename Base::Metric metric_;
  dealii::AlignedVector<Number> primitive_; ///< [component][point]
  dealii::AlignedVector<Number> residual_;  ///< [component][point]
  dealii::AlignedVector<Number> factor_;    ///< of gradients, likewise
  dealii::AlignedVector<Number> below_;     ///< room towards the smallest
  dealii::AlignedVector<Number> above_;     ///< and largest neighbour
  dealii::AlignedVector<Values> line_;      ///< see cell()
  dealii::AlignedVector<Values> left_;      ///< trace left of each face
  dealii::AlignedVector<Values> right_;     ///< trace right of each face
  /// Fluxes integrated over each face of the line; of the momentum flux, the
  /// tangential stress alone.
  dealii::AlignedVector<Values> flux_;
  dealii::AlignedVector<Number> normal_stress_; ///< at each face [Pa]
};
} // namespace contrecoup::gas
