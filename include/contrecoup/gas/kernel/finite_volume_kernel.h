// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/leaf_kernel.h>
#include <contrecoup/gas/octree/radial_weights.h>

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
class FiniteVolumeKernel : protected LeafKernel<dim, Gas, Real>
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

protected:
  using Base::batch_;
  using Base::gas_;
  using Base::layout_;
  using Base::mesh_;
  using Base::nc;
  using Base::scheme_;
  static constexpr int ghosts = 2;

  void load(const Real *state);
  /// Radii of the bound batch, in curvilinear geometry.
  void bind_radii()
  {
    if constexpr (dim < 3)
      if (!radial_.is_plane())
        radial_.reinit(mesh_.origins(batch_)[0], mesh_.extents(batch_)[0]);
  }
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
  /// Traces at the faces of the line. Differences between cells whose common
  /// face has no gas, touch_ = 0, do not count if @p masked.
  template <bool masked>
  void reconstruct();
  void line_fluxes(const unsigned int direction);
  void add_flux_differences(const unsigned int direction,
                            const unsigned int line);
  void finish(const BasicStage<Real> &stage);
  /// Notes lanes without a positive number as unphysical.
  void report(const Number &smallest, const BasicStage<Real> &stage) const;
  /// Padding lanes copy the first, so that they never overflow.
  void fill_padding(Real *out) const;
  /// One where there is gas between cells face - 1 and face of the line, from
  /// -1 to n + 1, else zero.
  Number &touch(const int face)
  {
    return touch_[face + 1];
  }
  /// Largest positive jump of the pressure between neighbouring points beyond
  /// a tenth of it, in compressed gas; @p weight(direction, point) is its
  /// factor between point and the next.
  template <typename Weight>
  Number largest_jump(const Weight &weight) const;
  /// Largest signal rate of the points that are loaded; their pressures
  /// become those that unburned explosive exerts.
  Number largest_rate(const BasicStage<Real> &stage);
  void store_sensors(const Number &rate,
                     const Number &jump,
                     const BasicStage<Real> &stage) const;

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
  dealii::AlignedVector<Number> touch_;       ///< see touch()
};


template <int dim, typename Gas, typename Real>
template <typename Weight>
inline typename FiniteVolumeKernel<dim, Gas, Real>::Number
FiniteVolumeKernel<dim, Gas, Real>::largest_jump(const Weight &weight) const
{
  const double threshold = 0.1;
  Number shock(0.);
  for (unsigned int d = 0; d < dim; ++d)
  {
    const unsigned int s = layout_.stride(d);
    for (unsigned int q = 0; q < layout_.n_points; ++q)
      if ((q / s) % layout_.n + 1 < layout_.n)
      {
        const Number *p = &primitive_[C::energy * layout_.n_points + q];
        const Number *u = &primitive_[(C::momentum + d) * layout_.n_points + q];
        const Number jump =
          (std::abs(p[s] - p[0]) - std::min(p[0], p[s]) * threshold) *
          weight(d, q);
        shock = std::max(shock, select_less(u[s], u[0], jump, Number(0.)));
      }
  }
  return shock;
}
} // namespace contrecoup::gas
