// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/record/open_sides.h>
#include <contrecoup/gas/run/reflected_path.h>
#include <contrecoup/gas/state/gas_state.h>

#include <functional>
#include <limits>
#include <vector>

namespace contrecoup::gas
{
/**
 * Assumptions of a gas run: before the run with estimates for the blast that
 * the scene is expected to have (ExpectedBlast), after the run with measured
 * values. Values that depend on an unknown blast are NaN in the plan.
 *
 *   first_stage       fraction of the time for which 1-D suffices; plan only
 *   equation_of_state fraction of the pressure of explosive products that an
 *                     ideal gas lacks
 *   reflection        waves reflected at open sides reach all gauges after the
 *                     end time: not earlier than the front would come from the
 *                     blast's image behind the side, as along a side that it
 *                     meets at grazing angle; not judged of a run that stopped
 *                     before they could
 *   air               constant heat capacities
 *   gravity           its speed is small compared with that of the gas
 *   viscosity,        their boundary layers at the end are thinner than the
 *   heat_conduction   smallest subcell
 *   quiet_leaves      fraction of the updates that is skipped; estimated only
 *                     for meshes that do not adapt
 *   modelled_part     fraction of the whole that planes of symmetry leave, and
 *                     that sums of the gas are of
 *
 * In gas around explosives that is unlike air at about sea level the items from
 * air to heat_conduction are unknown; any other such gas has none of them.
 */
template <int dim>
class ModellingPlan
{
public:
  /// Energy of the blast in full space [J]; 0: unknown; negative: not yet
  /// determined.
  double energy = -1.;
  dealii::Point<dim> centre;
  bool is_spherical = true; ///< whether the blast spreads in three dimensions
  GasState<dim> ambient;
  bool surrounds_explosives = false; ///< whether the ambient gas does
  dealii::Point<dim> lower, upper;   ///< of the domain [m]
  std::vector<unsigned int> open_sides, walls;
  std::vector<dealii::Point<dim>> probes;
  /// All places that no reflection from open sides may reach: the probes, and
  /// those of lines and planes.
  std::vector<dealii::Point<dim>> gauges;
  double end_time = 0.;         ///< [s]
  double smallest_subcell = 0.; ///< edge [m]
  bool skips_quiet_leaves = true;
  bool adapts = false; ///< whether leaves follow the blast
  unsigned int n_symmetry_planes = 0;
  /// Largest difference between the pressure of products and that of an ideal
  /// gas with the same density, energy and Grueneisen coefficient, over the
  /// pressure [-]; NaN without products.
  double non_ideal_fraction = std::numeric_limits<double>::quiet_NaN();

  /// Values measured by a run.
  struct Measurements
  {
    double time = 0.; ///< end of the run [s]
    std::array<double, 2 * dim> side_arrivals;
    /// Peak overpressures of the first wave at the probes but for those with
    /// is_reflected_at() [Pa].
    std::vector<double> peaks;
    double smallest_subcell = 0.; ///< [m]
    double skipped = 0.;          ///< fraction of skipped updates [-]
    /// As in the plan, at the end of the run.
    double non_ideal_fraction = std::numeric_limits<double>::quiet_NaN();
  };

  /// Expected distance of the blast front from its centre at @p time [m]; NaN
  /// if unknown.
  double expected_front(const double time) const;
  /// Largest distance of the front, with the reflection by walls that it has
  /// merged with: what reflections from open sides cannot outrun [m].
  double expected_reach(const double time) const;

  /// Whether a place is on a wall that reflects the blast, as one through its
  /// centre does not.
  bool is_reflected_at(const dealii::Point<dim> &place) const;

  std::vector<Assumption> plan() const;
  std::vector<Assumption> audit(const Measurements &measured) const;

  /// Writes and reads the blast, which a later state does not show, for
  /// checkpoints.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  /// All items without values.
  std::vector<Assumption> items() const;
  /// Energy of the wave at the distance @p way from the centre: that of charge
  /// and image where it has merged with its reflection by a wall; @p behind
  /// gives how far the way continues from a wall [m].
  double
  energy_of_wave(double way,
                 const std::function<double(unsigned int wall)> &behind) const;
  /// Earliest time at which the reflection on a way may come [s].
  double earliest_return(const ReflectedPath<dim> &path) const;
  double place_of_side(unsigned int side) const;
  /// The shortest one to a gauge by each open side.
  std::vector<ReflectedPath<dim>> paths_by_open_sides() const;
  /// Sets time and place of the first reflection that the blast is expected to
  /// have, and of the measured one.
  void expect_return(Assumption &item) const;
  void measure_return(const Measurements &measured, Assumption &item) const;
  /// Time at which the front reaches the nearest side that is not a plane
  /// through the centre, where spherical symmetry ends [s].
  double expected_end_of_symmetry() const;
  double expected_quiet_fraction() const;
  /// Whether the ambient gas is air at about sea level.
  bool is_air() const;
};
} // namespace contrecoup::gas
