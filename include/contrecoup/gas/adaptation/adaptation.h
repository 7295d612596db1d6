// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation_pace.h>
#include <contrecoup/gas/adaptation/front_sensor.h>
#include <contrecoup/gas/adaptation/leaf_carrier.h>
#include <contrecoup/gas/adaptation/leaf_levels.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <boost/signals2/connection.hpp>

#include <functional>

namespace contrecoup::gas
{
/**
 * Adapts the octree to the gas: computes the sensor of each leaf, extends the
 * marked leaves by the AMR buffer, and transfers the state, at the intervals of
 * AdaptationPace. Distributes the leaves over ranks by their cost, where that
 * became uneven.
 */
template <int dim>
class Adaptation
{
public:
  Adaptation(const AdaptationParameters &parameters,
             LeafMesh<dim> &mesh,
             const LeafPoints<dim> &points,
             const GasMaterial &material);

  /// Adapts the mesh once, and transfers the field and, unless they are empty,
  /// the maps. Returns whether the mesh changed. The field's ghosts must be up
  /// to date. Collective.
  /// @param time at which size limits are evaluated [s]
  /// @param quiet_leaves leaves whose cost is small; null: none
  bool adapt(GasField &field,
             BlastMaps<dim> &maps,
             const double time = 0.,
             QuietLeaves<dim> *quiet_leaves = nullptr);
  bool adapt(GasField &field,
             const double time = 0.,
             QuietLeaves<dim> *quiet_leaves = nullptr)
  {
    BlastMaps<dim> none;
    return adapt(field, none, time, quiet_leaves);
  }

  /// Refines every leaf below the largest level where @p wanted is true,
  /// without transferring the field. Returns whether any leaf was refined.
  bool refine_where(const std::function<bool(const unsigned int leaf)> &wanted);

  /// See LeafLevels.
  void set_body(const RigidBody &body, const unsigned int initial_level)
  {
    levels_.set_body(body, initial_level);
  }
  const LeafLevels<dim> &levels() const
  {
    return levels_;
  }

  /// Refines the leaves at the body to the level that it requires.
  void refine_at_body();

  /// Refines the leaves in the fine box to its level.
  void refine_fine_box();

  /// Whether the octree must be adapted before the next step; false if
  /// adaptation is not active.
  bool is_due() const
  {
    return parameters_.active && pace_.is_due();
  }

  /// Restarts the count of steps at @p time [s].
  void restart(const double time)
  {
    pace_.restart(time);
  }

  /// Computes size_ratios() for the following steps. Call after adapt().
  void update_size_ratios()
  {
    if (parameters_.active)
      size_ratios_ = levels_.size_ratios(pace_.start());
  }

  /// See LeafLevels::size_ratios(); empty: all are one.
  const std::vector<double> &size_ratios() const
  {
    return size_ratios_;
  }

  /// Counts a step, see AdaptationPace::add_step().
  void add_step(const double travel)
  {
    pace_.add_step(travel);
  }

  /// Writes and reads the count of steps, for checkpoints.
  void save(std::ostream &stream) const
  {
    pace_.save(stream);
  }
  void load(std::istream &stream)
  {
    pace_.load(stream);
  }

  /// Time of the last adaptation [s].
  double time() const
  {
    return time_;
  }

  /// Sensor of each owned leaf, from 0 (smooth) to 1 (a jump). The field's
  /// ghosts must be up to date.
  std::vector<double> sensors(const GasField &field) const;

private:
  using CellIterator = typename LeafMesh<dim>::CellIterator;
  using ActiveIterator =
    typename dealii::Triangulation<dim>::active_cell_iterator;
  using FaceMarks = FaceValues<dim>;
  using Marks = std::function<FaceMarks(const CellIterator &)>;

  bool adapt_now(GasField &field, BlastMaps<dim> &maps);
  /// Sensor of each owned leaf per face through which it marks the neighbour.
  std::vector<FaceMarks> face_marks(const GasField &field) const;
  /// Batches for whose leaves the sensor is computed.
  std::vector<bool> wanted_batches() const;
  /// Cost of each owned leaf, relative to that of a quiet leaf.
  std::vector<unsigned int> leaf_weights() const;
  bool refine_flagged();
  void spread(std::vector<FaceMarks> &marks) const;
  /// Takes over the marks of leaves across a face that are at least as fine, if
  /// their fronts propagate towards this side.
  void inherit(const CellIterator &cell,
               const unsigned int face,
               const Marks &marks,
               FaceMarks &result) const;
  void set_flags(const std::vector<FaceMarks> &marks);
  void change_mesh(GasField &field, BlastMaps<dim> &maps);
  void carry_weights(const std::vector<LeafOrigin> &origins);
  /// Whether a rank has much more work than the mean, or siblings, which are
  /// merged on one rank alone, are on several.
  bool needs_distribution() const;
  bool splits_siblings(const unsigned int leaf) const;
  void distribute(const LeafCarrier<dim> &carrier,
                  GasField &field,
                  BlastMaps<dim> &maps);

  const AdaptationParameters parameters_;
  LeafMesh<dim> &mesh_;
  const LeafPoints<dim> points_;
  const GasMaterial material_;
  LeafLevels<dim> levels_;
  AdaptationPace pace_;
  std::vector<double> size_ratios_;
  double time_ = 0.; ///< [s]
  QuietLeaves<dim> *quiet_leaves_ = nullptr;
  std::vector<unsigned int> weights_; ///< of the owned leaves; empty: equal
  boost::signals2::scoped_connection weigher_;
};
} // namespace contrecoup::gas
