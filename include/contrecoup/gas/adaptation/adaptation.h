// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/front_sensor.h>
#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/adaptation/size_limits.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/signals2/connection.hpp>

#include <functional>

namespace contrecoup::gas
{
/// Which leaves are halved or merged, as subsection "Adaptation" says.
struct AdaptationParameters
{
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @throws InputError when smallest and largest contradict each other.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const unsigned int dim,
                        const unsigned int initial_refinement,
                        const unsigned int n_points,
                        const bool is_finite_volume,
                        const bool is_axis_aligned);

  /**
   * Finds in how many steps no shock that runs into gas at rest crosses the
   * buffer.
   * @param reach step size times signal rate sum_d (|u_d| + c) / h_d [-]
   */
  void find_buffer_steps(const double reach,
                         const unsigned int dim,
                         const unsigned int n_points);

  enum class Sensor
  {
    bend,          ///< jump_sensor(): bends of density and pressure
    pressure_bend, ///< the same of pressure alone, blind to contacts
    blast          ///< front_sensor(): pressure fronts
  };

  bool active = false;
  Sensor sensor = Sensor::bend;
  unsigned int interval = 5;    ///< most steps in between; 0: no such limit
  double buffer_steps = 1.;     ///< for fronts in leaves that set the step
  unsigned int least_level = 0; ///< refinements of the coarse mesh
  unsigned int most_level = 0;
  double refine = 0.3;     ///< sensor above which leaves are halved
  double coarsen = 0.1;    ///< sensor below which they are merged
  double noise = 0.02;     ///< relative jump that counts as noise
  unsigned int buffer = 1; ///< layers of leaves around marked ones
  bool only_ahead = false; ///< whether these are only where fronts run to
  /// A box whose leaves stay at this level at least; level 0: none.
  unsigned int fine_level = 0;
  std::vector<double> fine_lower; ///< [m]
  std::vector<double> fine_upper; ///< [m]
  SizeLimits limits;

private:
  void check(const unsigned int dim,
             const unsigned int n_points,
             const bool is_finite_volume,
             const bool is_axis_aligned) const;
};

/**
 * Adapts the octree to the gas: marks leaves by a sensor, spreads the marks
 * ahead of the fronts, and carries the state over. Ranks share the leaves by
 * what these cost.
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

  /// For each owned leaf, its edge length over that of the smallest leaf that
  /// fronts may have there at time @p time [s], or one if it is not smaller: a
  /// front in it has so much less of the buffer behind it [-].
  std::vector<double> front_shares(const double time) const;

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
  double time_ = 0.; ///< [s]
  QuietLeaves<dim> *quiet_leaves_ = nullptr;
  boost::signals2::scoped_connection weights_;
};
} // namespace contrecoup::gas
