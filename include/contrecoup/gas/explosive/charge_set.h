// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/explosive/charge.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <optional>
#include <vector>

namespace contrecoup::gas
{
/// All charges of a scene, read from subsection "Charges"; they consist of the
/// explosive of subsection "Material".
template <int dim>
class ChargeSet
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// @throws InputError when the material has no explosive, and as Charge
  /// does.
  void parse_parameters(ParameterHandler &prm,
                        const GasMaterial &material,
                        const CoarseMesh<dim> &mesh);

  /// @throws InputError unless @p scheme is a finite-volume scheme and the gas
  /// around the charges is uniform and at rest.
  void check(const Scheme &scheme, const InitialState<dim> &initial_state);

  bool empty() const
  {
    return charges_.empty();
  }

  /// Derived constants of the explosive, as text for the log.
  const std::string &description() const
  {
    return description_;
  }

  /// Detonation speed D [m/s].
  double speed() const
  {
    return speed_;
  }

  /// Density of the unburned explosive [kg/m^3].
  double density() const
  {
    return density_;
  }

  /// 1 / (1 - V_CJ), V_CJ the relative volume of the Chapman-Jouguet state
  /// [-].
  double stiffness() const
  {
    return stiffness_;
  }

  /// Thickness of the burn front in subcells [-]: a wider front is smoother and
  /// reaches the Chapman-Jouguet pressure later.
  static constexpr double burn_width = 2.;

  /// Ambient pressure around the charges [Pa], computed from the ambient
  /// energy by the equation of state.
  double ambient_pressure() const
  {
    return ambient_pressure_;
  }

  /// Warnings, one for each charge of which some burns after @p end_time [s].
  std::vector<std::string> late_burns(const double end_time) const;

  /// Signed distance from the nearest charge [m], negative inside.
  double signed_distance(const dealii::Point<dim> &point) const;

  /// Time [s] when the detonation front of a charge nearer than @p max_distance
  /// [m] comes within @p lead [m] of a point; nothing if no charge is that
  /// near.
  std::optional<double> arrival(const dealii::Point<dim> &point,
                                const double max_distance,
                                const double lead) const;

  /**
   * Replaces gas in @p field by explosive at rest with its full energy.
   * Subcells that the surface of a charge cuts get a mixture. Each charge has
   * its exact mass on any mesh, unless the domain cuts it elsewhere than in
   * planes of symmetry. Collective.
   *
   * @return one line per charge for the log
   * @throws InputError for charges that overlap or miss the domain.
   */
  std::vector<std::string> fill(const LeafMesh<dim> &mesh,
                                const LeafPoints<dim> &points,
                                GasField &field) const;

private:
  std::vector<Charge<dim>> charges_;
  std::vector<std::string> names_;
  std::string description_;
  double density_ = 0.;        ///< density of the explosive [kg/m^3]
  double energy_density_ = 0.; ///< energy density of the explosive [J/m^3]
  double speed_ = 0.;
  double stiffness_ = 0.;
  double ambient_pressure_ = 0.;
  GasMaterial material_;
};
} // namespace contrecoup::gas
