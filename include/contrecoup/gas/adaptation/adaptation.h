// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation_pace.h>
#include <contrecoup/gas/adaptation/front_sensor.h>
#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <boost/signals2/connection.hpp>

#include <functional>

namespace contrecoup::gas
{
/**
 * Adapts the octree to the gas: marks leaves by a sensor, spreads the marks
 * ahead of the fronts, and carries the state over, as often as AdaptationPace
 * says. Ranks share the leaves by what these cost.
 */
template <int dim>
class Adaptation
{
public:
  Adaptation(const AdaptationParameters &parameters,
             LeafMesh<dim> &mesh,
             const LeafPoints<dim> &points,
             const GasMaterial &material);

  /// Adapts mesh, field and, unless they are empty, maps once. Returns
  /// whether anything changed. The field's ghosts must be up to date.
  /// Collective.
  /// @param time for limits of size [s]
  /// @param quiet_leaves leaves that cost nothing; null: none
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

  /// Halves every leaf below the largest level for which @p wanted is
  /// true, without carrying the field over. Returns whether any was.
  bool refine_where(const std::function<bool(const unsigned int leaf)> &wanted);

  /// Leaves that meet the surface of @p body, and those within one such leaf
  /// of it, shall be halved as often as the body says beyond @p initial_level,
  /// neither more nor less; the body must outlive this object.
  void set_body(const RigidBody &body, const unsigned int initial_level)
  {
    body_ = &body;
    initial_level_ = initial_level;
  }

  /// Halves the leaves at the body until they have their level.
  void refine_at_body();

  /// Halves the leaves in the fine box until they have its level.
  void refine_fine_box();

  /// Whether the octree must adapt before the next step; never where the
  /// parameters forbid it.
  bool is_due() const
  {
    return parameters_.active && pace_.is_due();
  }

  /// Counts steps anew from @p time on [s].
  void restart(const double time)
  {
    pace_.restart(time);
  }

  /// For each owned leaf at time @p time [s], the ratio of its edge length to
  /// that of the smallest leaf that fronts may have there, at most 1: a front
  /// in a smaller leaf, beside a body, has a buffer that is thinner by it [-].
  std::vector<double> size_ratios(const double time) const;

  /// Finds size_ratios() for steps from here on. Call after mesh and state
  /// changed, and after adapt().
  void update_size_ratios()
  {
    size_ratios_ =
      parameters_.active ? size_ratios(pace_.start()) : std::vector<double>();
  }

  /// What update_size_ratios() found; empty: all are one.
  const std::vector<double> &size_ratios() const
  {
    return size_ratios_;
  }

  /// Counts a step, see AdaptationPace::add_step().
  void add_step(const double buffer_share)
  {
    pace_.add_step(buffer_share);
  }

  /// The count, for checkpoints.
  void save(std::ostream &stream) const
  {
    pace_.save(stream);
  }
  void load(std::istream &stream)
  {
    pace_.load(stream);
  }

  /// When it adapted last [s].
  double time() const
  {
    return time_;
  }

  /// The finest level that fine box and limits of size let an owned leaf have
  /// at time @p time [s].
  unsigned int most_level(const unsigned int leaf, const double time) const;

  /// The coarsest level that an owned leaf can have beside the leaves at the
  /// body.
  unsigned int least_level_near_body(const unsigned int leaf) const;

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
  /// Sensor of each owned leaf, by the face through which it marks the next.
  std::vector<FaceMarks> face_marks(const GasField &field) const;
  /// Batches whose leaves are looked at.
  std::vector<bool> wanted_batches() const;
  /// Levels that a leaf may have.
  SizeLimits::Levels levels(const unsigned int leaf) const;
  /// What fine box and limits leave of the levels @p general at time @p time
  /// [s].
  SizeLimits::Levels narrowed(const unsigned int leaf,
                              SizeLimits::Levels general,
                              const double time) const;
  /// See RigidBody::layers_to().
  double layers_from_body(const unsigned int leaf) const;
  /// Level that the leaf shall have if it is at the body.
  unsigned int body_level(const unsigned int leaf) const;
  bool is_in_fine_box(const dealii::Point<dim> &place) const;
  void weigh_leaves();
  /// What a leaf costs that persists, is merged or halved, in parts of the
  /// cost of a quiet one.
  unsigned int weight(const typename LeafMesh<dim>::CellIterator &cell) const;
  bool refine_flagged();
  void spread(std::vector<FaceMarks> &marks) const;
  /// Takes over the marks of leaves beyond a face, that are not coarser,
  /// if they mark what is on this side of it.
  void inherit(const CellIterator &cell,
               const unsigned int face,
               const Marks &marks,
               FaceMarks &result) const;
  void set_flags(const std::vector<FaceMarks> &marks);
  void carry_over(GasField &field, BlastMaps<dim> &maps);
  /// In 1-D, changes the flags so that neighbours stay within one level and
  /// siblings merge together.
  void balance_line();
  void carry_over_line(GasField &field, BlastMaps<dim> &maps);

  const AdaptationParameters parameters_;
  LeafMesh<dim> &mesh_;
  const LeafPoints<dim> points_;
  const GasMaterial material_;
  const RigidBody *body_ = nullptr;
  unsigned int initial_level_ = 0;
  AdaptationPace pace_;
  std::vector<double> size_ratios_;
  double time_ = 0.; ///< [s]
  QuietLeaves<dim> *quiet_leaves_ = nullptr;
  boost::signals2::scoped_connection weights_;
};
} // namespace contrecoup::gas
