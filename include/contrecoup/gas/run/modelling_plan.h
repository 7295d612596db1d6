// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/record/open_sides.h>
#include <contrecoup/gas/state/gas_state.h>

#include <limits>
#include <vector>

namespace contrecoup::gas
{
/**
 * What a gas run takes for granted, as estimated before it from the blast
 * that its scene is expected to be (ExpectedBlast), and as measured after it.
 * What depends on an unknown blast is NaN in the plan.
 *
 *   first_stage      part of the time in which 1-D would do; plan alone
 *   equation_of_state part of the pressure of explosive products that an ideal
 *                    gas would not give
 *   reflection       waves that come back from open sides are later than the
 *                    end time at all probes
 *   air              heat capacities are constant
 *   gravity          its speed stays far below that of the gas
 *   viscosity,       layers that they make in the time of the run are thinner
 *   heat_conduction  than a cell
 *   quiet_leaves     part of the updates that need not be computed
 */
template <int dim>
class ModellingPlan
{
public:
  /// Energy of the blast in full space [J]; 0: none can be foreseen; below 0:
  /// not looked for yet.
  double energy = -1.;
  dealii::Point<dim> centre;
  bool is_spherical = true; ///< whether it spreads in all three directions
  GasState<dim> ambient;
  dealii::Point<dim> lower, upper; ///< of the domain [m]
  std::vector<unsigned int> open_sides;
  std::vector<dealii::Point<dim>> probes;
  double end_time = 0.;         ///< [s]
  double smallest_subcell = 0.; ///< edge [m]
  bool skips_quiet_leaves = true;
  /// Largest difference of the pressure of products from that of an ideal gas
  /// of their density, energy and Grueneisen coefficient, over the pressure
  /// [-]; NaN: there are no products.
  double non_ideal_fraction = std::numeric_limits<double>::quiet_NaN();

  /// What a run found.
  struct Measurements
  {
    double time = 0.; ///< when it ended [s]
    std::array<double, 2 * dim> side_arrivals;
    std::vector<double> peaks;    ///< overpressures at the probes [Pa]
    double smallest_subcell = 0.; ///< [m]
    double skipped = 0.;          ///< part of the updates [-]
    /// As in the plan, in the end.
    double non_ideal_fraction = std::numeric_limits<double>::quiet_NaN();
  };

  /// Distance of the blast's front from its centre at @p time [m]; NaN: not
  /// known.
  double expected_front(const double time) const;

  std::vector<Assumption> plan() const;
  std::vector<Assumption> audit(const Measurements &measured) const;

  /// The blast, which a later state no longer shows, for checkpoints.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  /// All items but for their values.
  std::vector<Assumption> items() const;
  /// Distance that a wave goes from the centre by @p side to a probe, as if
  /// the side reflected it like a mirror, and straight to the side [m].
  std::pair<double, double>
  reflected_path(const unsigned int side,
                 const dealii::Point<dim> &probe) const;
  double expected_return() const;
  /// When the front reaches what is not spherical: the nearest side that is
  /// no plane through the centre [s].
  double expected_end_of_symmetry() const;
  double measured_return(const Measurements &measured) const;
  double expected_quiet_fraction() const;
  /// Whether the ambient gas is air as at ground level.
  bool is_air() const;
};
} // namespace contrecoup::gas
