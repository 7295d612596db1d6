// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/hanging_openings.h>
#include <contrecoup/gas/kernel/hanging_writer.h>
#include <contrecoup/gas/kernel/primitive_field.h>
#include <contrecoup/gas/kernel/stage.h>
#include <contrecoup/gas/octree/hanging_group.h>
#include <contrecoup/gas/octree/neighbor_reader.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Fluxes and halo values of hanging faces for the finite-volume scheme on
 * axis-aligned leaves. The flux is computed once for each fine subcell
 * face, from a linear reconstruction on both sides; the coarse side gets
 * the mean of the fluxes over its face's area, so that nothing is lost.
 */
template <int dim, typename Gas, typename Real = double>
class FiniteVolumeHanging
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  using C = Component<dim>;

  /// @param primitives of the state that stages read
  FiniteVolumeHanging(const LeafLayout &layout,
                      const Scheme &scheme,
                      const Gas &gas,
                      PrimitiveField<dim, Gas, Real> &primitives);

  /// @param openings where a rigid body is, what it leaves open: slopes do not
  /// look through what is closed, and the coarse side gets the mean over what
  /// is open
  void compute(const HangingGroup<dim> &group,
               const BasicStage<Real> &stage,
               HangingData<dim, Real> &hanging,
               const HangingOpenings<dim, Real> *openings = nullptr);

private:
  static constexpr unsigned int n_fine = HangingFace<dim>::n_fine;

  void load(const HangingGroup<dim> &group);
  /// Reads two layers at @p face of the leaves, of which @p point_at(q) is
  /// the face point that meets the coarse one q.
  template <typename PointAt>
  void load_leaves(const unsigned int *leaves,
                   const unsigned int face,
                   const PointAt &point_at,
                   std::array<dealii::AlignedVector<Values>, 2> &layers);
  void load_progress(const HangingGroup<dim> &group,
                     const BasicStage<Real> &stage);
  void average_fine_side();
  void average_open_fine_side();
  /// Slopes of the coarse subcells, zero where the subcell's own parts
  /// would not all be admissible: then no trace holds more than twice what
  /// the subcell has.
  void limit_coarse_slopes();
  /// Adds the slopes to the traces on the coarse side (inside) and the fine
  /// one (outside) at a fine face point, and sets the fine side's halo.
  void reconstruct(const unsigned int part,
                   const unsigned int point,
                   Values &inside,
                   Values &outside);
  void part_fluxes(const HangingGroup<dim> &group, const unsigned int part);
  Number inner_radii(const HangingGroup<dim> &group) const;
  void average_fluxes(const HangingGroup<dim> &group);
  void average_open_fluxes(const HangingGroup<dim> &group);
  void store(const HangingGroup<dim> &group, HangingData<dim, Real> &hanging);

  /// Slope of the coarse values along face coordinate @p t at a point,
  /// from the neighbours on the same leaf.
  Values tangential_slope(const unsigned int point, const unsigned int t) const;

  /// Coarse face point that fine point (a, b) of a part lies in, and its
  /// distance from that point's centre in coarse subcells.
  unsigned int
  coarse_point(const unsigned int part,
               const unsigned int fine_point,
               std::array<double, dim == 1 ? 1 : dim - 1> &distance) const;

  /// Fine face point in the fine leaf's own numbering.
  unsigned int fine_point(const HangingGroup<dim> &group,
                          const unsigned int point) const;

  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  PrimitiveField<dim, Gas, Real> &primitives_;
  NeighborReader<Real> reader_;
  bool bounds_velocity_slopes_ = false; ///< see Stage::bound_velocity_slopes
  const HangingOpenings<dim, Real> *openings_ = nullptr;
  /// Set where a leaf of the group is still to burn.
  const Burn *burn_ = nullptr;

  /// Primitive values by [layer][face point], coarse numbering.
  std::array<dealii::AlignedVector<Values>, 2> coarse_;
  std::array<std::array<dealii::AlignedVector<Values>, 2>, n_fine> fine_;
  /// Burn::progress() next to the face, where burn_ is set.
  dealii::AlignedVector<Number> coarse_progress_;
  std::array<dealii::AlignedVector<Number>, n_fine> fine_progress_;
  /// Slopes by [direction][face point]: along the face coordinates, then
  /// out of the leaf.
  std::array<dealii::AlignedVector<Values>, dim> coarse_slope_;
  dealii::AlignedVector<Values> coarse_halo_;
  std::array<dealii::AlignedVector<Values>, n_fine> fine_halo_;
  dealii::AlignedVector<Values> coarse_flux_;
  dealii::AlignedVector<Values> first_flux_; ///< of each coarse subcell face
  /// Sum of what its fine ones have open, or of the volumes beyond it.
  dealii::AlignedVector<Number> open_sum_;
  std::array<dealii::AlignedVector<Values>, n_fine> fine_flux_;
  HangingWriter<dim, Real, nc> writer_;
};
} // namespace contrecoup::gas
