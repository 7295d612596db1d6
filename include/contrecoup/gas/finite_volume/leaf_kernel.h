// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/neighbor_reader.h>
#include <contrecoup/gas/stage/operator_context.h>
#include <contrecoup/gas/stage/stage.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Not a kernel itself, but what the finite-volume kernels share on a batch of
 * leaves: readers of the neighbours, the state beyond the domain's boundary on
 * boxes (walls and most open sides: BatchSweep), programmed burn, which leaves
 * contain a shock, and which contain one at an open boundary.
 *
 * A line is a row of points of a leaf along one direction; it is numbered
 * like the points of the leaf face that it starts from.
 */
template <int dim, typename Gas, typename Real = double>
class LeafKernel
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int width = n_lanes<Real>; ///< of a batch
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  using C = Component<dim>;

  /// @param positions places of the points along an edge, from 0 to 1
  LeafKernel(const OperatorContext<dim> &context,
             const Gas &gas,
             const std::vector<double> &positions);

  /// Prepares for the leaves of @p batch.
  void bind(const unsigned int batch, const BasicStage<Real> &stage);

  /// Sets burn_ alone.
  void bind_burn(const unsigned int batch, const BasicStage<Real> &stage);

  /// Burn::progress() of a point of the batch, where burn_ is set.
  Number progress(const unsigned int point, const double time) const;

  /// Fills line_progress_ for a line, where burn_ is set.
  void fill_progress(const unsigned int direction, const unsigned int line);

  /// The states left and right of face @p f of the line, as unburned
  /// explosive makes them.
  template <typename State>
  void
  apply_burn_pressure(const unsigned int f, State &left, State &right) const
  {
    burn_->template apply_burn_pressure<dim>(line_progress_[f], left);
    burn_->template apply_burn_pressure<dim>(line_progress_[f + 1], right);
  }

  /// Pressure that cell @p i of the line, in this state, exerts.
  Number exerted_pressure(const unsigned int i, const Values &cell) const
  {
    if (burn_ == nullptr)
      return cell[C::pressure];
    return burn_->pressure(
      cell[C::pressure],
      burn_->fraction(line_progress_[i + 1], cell[C::density]));
  }

  /// Reader of the neighbours across @p face.
  const NeighborReader<Real> &neighbors(const unsigned int face) const
  {
    return neighbors_[face];
  }
  unsigned int batch() const
  {
    return batch_;
  }
  const Boundary<dim> &boundary() const
  {
    return boundary_;
  }
  /// Null where neither a leaf of the batch nor a neighbour is still to burn.
  const Burn *burn() const
  {
    return burn_;
  }
  /// Burn::progress() from fill_progress(), of the line's first point; those of
  /// points -1 to n are next to it.
  const Number *line_progress() const
  {
    return &line_progress_[1];
  }
  /// Shock sensor of the leaves.
  const Number &sensor() const
  {
    return sensor_;
  }
  /// Shock sensor of the neighbours across @p face.
  const Number &neighbor_sensor(const unsigned int face) const
  {
    return neighbor_sensor_[face];
  }
  /// One in lanes of leaves with a shock at an open boundary along a
  /// direction, else zero.
  const Number &leaving(const unsigned int direction) const
  {
    return leaving_[direction];
  }

  /// Primitive state beyond the boundary in the lane of @p special, from
  /// and to values in the frame of the line.
  void fill_boundary(const SpecialFace &special,
                     const unsigned int line,
                     const Values &inside,
                     Values &outside) const;

  /// Slot of a hanging face's data that belongs to this side.
  static unsigned int slot_of(const SpecialFace &special)
  {
    return special.kind == SpecialFace::Kind::coarse_side ? 0
                                                          : 1 + special.part;
  }

  /// Whether shocked leaves are among the batch and its neighbours and the
  /// flux asks for shear factors.
  bool needs_shear_factor() const
  {
    return needs_shear_factor_;
  }

  /// Whether a shock may be leaving any leaf of the batch through an open
  /// boundary along a direction.
  bool any_leaving(const unsigned int direction) const
  {
    return any_leaving_[direction];
  }

  /**
   * Replaces a flux between two points of a leaf by the Rusanov flux of the
   * points' own states, in the lanes of leaves that a shock may be leaving
   * through an open boundary along @p direction: the wider a front is
   * numerically when it leaves, the less of it comes back.
   */
  void widen_open_flux(const unsigned int direction,
                       const Values &left,
                       const Values &right,
                       Values &flux) const;

protected:
  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  const Boundary<dim> &boundary_;
  const std::vector<double> positions_;

  unsigned int batch_ = 0;
  double time_ = 0.;
  const Real *in_ = nullptr;
  bool bounds_velocity_slopes_ = false; ///< see Stage::bound_velocity_slopes
  /// Set where a leaf of the batch or a neighbour is still to burn.
  const Burn *burn_ = nullptr;
  /// Burn::progress() of cells -1 to n of a line.
  dealii::AlignedVector<Number> line_progress_;
  Number sensor_; ///< of the leaves themselves
  std::array<Number, 2 * dim> neighbor_sensor_;
  std::array<Number, dim> leaving_; ///< see leaving()
  std::array<bool, dim> any_leaving_;

private:
  /// @param shock positive in lanes of leaves that hold or meet a shock
  void find_leaving(const Number &shock);
  void fill_progress_beyond(const unsigned int face, const unsigned int line);

  bool needs_shear_factor_ = false;
  std::array<NeighborReader<Real>, 2 * dim> neighbors_;
};
} // namespace contrecoup::gas
