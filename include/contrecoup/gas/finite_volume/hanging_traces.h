// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/hanging_openings.h>
#include <contrecoup/gas/finite_volume/hanging_writer.h>
#include <contrecoup/gas/finite_volume/primitive_field.h>
#include <contrecoup/gas/octree/hanging_group.h>
#include <contrecoup/gas/octree/neighbor_reader.h>
#include <contrecoup/gas/stage/operator_context.h>
#include <contrecoup/gas/stage/stage.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Basis of the finite-volume schemes on a group of hanging faces: the gas on
 * both sides, the traces at each fine subcell face from a linear reconstruction
 * on either side, and the halo values. Differences are those along the index
 * lines of the leaves, with velocities along the coordinate axes, so that the
 * leaves may have any shape.
 */
template <int dim, typename Gas, typename Real = double>
class HangingTraces
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  using C = Component<dim>;

protected:
  static constexpr unsigned int n_fine = HangingFace<dim>::n_fine;

  /// @param primitives of the state that stages read
  HangingTraces(const OperatorContext<dim> &context,
                const Gas &gas,
                PrimitiveField<dim, Gas, Real> &primitives);

  /// Reads the leaves of a group, sets the coarse side's halo and limits its
  /// slopes.
  /// @param openings where a rigid body is, what it leaves open
  void prepare(const HangingGroup<dim> &group,
               const BasicStage<Real> &stage,
               const HangingOpenings<dim, Real> *openings = nullptr);

  /// States at a fine face point on the coarse side (inside) and the fine one
  /// (outside); sets the fine side's halo.
  void reconstruct(const unsigned int part,
                   const unsigned int point,
                   Values &inside,
                   Values &outside);

  /// The coarse and the fine side's state at a fine face point, as unburned
  /// explosive makes them.
  template <typename State>
  void apply_burn_pressure(const unsigned int part,
                           const unsigned int point,
                           State &coarse,
                           State &fine) const
  {
    if (burn_ == nullptr)
      return;
    std::array<double, dim == 1 ? 1 : dim - 1> distance;
    const unsigned int at = coarse_point(part, point, distance);
    burn_->template apply_burn_pressure<dim>(coarse_progress_[at], coarse);
    burn_->template apply_burn_pressure<dim>(fine_progress_[part][point], fine);
  }

  /// Writes fluxes and halos of both sides.
  void store(const HangingGroup<dim> &group, HangingData<dim, Real> &hanging);

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
  const HangingOpenings<dim, Real> *openings_ = nullptr;
  /// Set where a leaf of the group is still to burn.
  const Burn *burn_ = nullptr;

  /// Primitive values by [layer][face point], coarse numbering.
  std::array<dealii::AlignedVector<Values>, 2> coarse_;
  std::array<std::array<dealii::AlignedVector<Values>, 2>, n_fine> fine_;
  /// Burn::progress() next to the face, where burn_ is set.
  dealii::AlignedVector<Number> coarse_progress_;
  std::array<dealii::AlignedVector<Number>, n_fine> fine_progress_;
  dealii::AlignedVector<Values> coarse_flux_;
  std::array<dealii::AlignedVector<Values>, n_fine> fine_flux_;
  /// Sums for each coarse subcell's face: the volumes of the fine subcells
  /// beyond it (set by average_open_fine_side()), then its fine faces' openings
  /// (set where fluxes are averaged).
  dealii::AlignedVector<Number> open_sum_;
  dealii::AlignedVector<Values> open_mean_; ///< of open_sum_

  /// Replaces @p means by open_mean_ in lanes whose face is cut.
  void take_in_cut_lanes(dealii::AlignedVector<Values> &means) const;

private:
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
  /// Slope of the coarse values along face coordinate @p t at a point,
  /// from the neighbours on the same leaf.
  Values tangential_slope(const unsigned int point, const unsigned int t) const;

  NeighborReader<Real> reader_;
  bool bounds_velocity_slopes_ = false; ///< see Stage::bound_velocity_slopes
  /// Slopes by [direction][face point]: along the face coordinates, then
  /// out of the leaf.
  std::array<dealii::AlignedVector<Values>, dim> coarse_slope_;
  dealii::AlignedVector<Values> coarse_halo_;
  std::array<dealii::AlignedVector<Values>, n_fine> fine_halo_;
  HangingWriter<dim, Real, nc> writer_;
};
} // namespace contrecoup::gas
