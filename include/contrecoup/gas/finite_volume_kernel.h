// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/leaf_kernel.h>
#include <contrecoup/gas/radial_weights.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * One stage of the finite-volume scheme on one batch of axis-aligned
 * leaves: primitive variables, limited linear reconstruction along each
 * direction (van Leer 1979), a Riemann flux at each subcell face, and the
 * sum of the fluxes. Reads two layers of the neighbours; writes its own
 * leaves only.
 */
template <int dim, typename Gas, typename Real = double>
class FiniteVolumeKernel : private LeafKernel<dim, Gas, Real>
{
public:
  using Base = LeafKernel<dim, Gas, Real>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;
  using C = Component<dim>;

  FiniteVolumeKernel(const LeafMesh<dim> &mesh,
                     const LeafLayout &layout,
                     const Scheme &scheme,
                     const Gas &gas,
                     const Boundary<dim> &boundary);

  /// Does @p stage on the leaves of @p batch.
  void update(const unsigned int batch,
              const BasicStage<Real> &stage,
              const HangingData<dim, Real> &hanging);

  /// Computes only sensor and signal rate of the state stage.out.
  void analyse(const unsigned int batch, const BasicStage<Real> &stage);

private:
  using Base::batch_;
  using Base::gas_;
  using Base::layout_;
  using Base::mesh_;
  using Base::nc;
  using Base::scheme_;
  static constexpr int ghosts = 2;

  void load(const Real *state);
  void sweep(const unsigned int direction,
             const HangingData<dim, Real> &hanging);
  void fill_line(const unsigned int direction, const unsigned int line);
  void fill_line_ends(const unsigned int direction,
                      const unsigned int line,
                      const HangingData<dim, Real> &hanging);
  void fill_ghost_lane(const SpecialFace &special,
                       const unsigned int line,
                       const HangingData<dim, Real> &hanging);
  void fill_compression(const unsigned int direction, const unsigned int line);
  void reconstruct();
  void line_fluxes(const unsigned int direction);
  void add_flux_differences(const unsigned int direction,
                            const unsigned int line);
  void finish(const BasicStage<Real> &stage);

  /// Cells of the line from -2 to n + 1, velocity in the frame of the line.
  Values &cell(const int i)
  {
    return line_[i + ghosts];
  }

  RadialWeights radial_;
  dealii::AlignedVector<Number> primitive_;   ///< [component][point]
  dealii::AlignedVector<Number> residual_;    ///< [component][point]
  dealii::AlignedVector<Values> line_;        ///< cells with ghosts
  dealii::AlignedVector<Values> left_;        ///< trace left of each face
  dealii::AlignedVector<Values> right_;       ///< trace right of each face
  dealii::AlignedVector<Values> flux_;        ///< at each face of the line
  dealii::AlignedVector<Number> compression_; ///< cells -1 to n, transverse
};
} // namespace contrecoup::gas
