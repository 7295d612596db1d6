// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/explosive/charge.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/materials/gas_material.h>

#include <optional>
#include <vector>

namespace contrecoup::gas
{
/// The charges of a scene, as subsection "Charges" describes them: all of the
/// explosive that subsection "Material" names.
template <int dim>
class ChargeSet
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// @throws InputError where the material has no explosive, and as Charge
  /// does.
  void parse_parameters(ParameterHandler &prm,
                        const GasMaterial &material,
                        const CoarseMesh<dim> &mesh);

  /// @throws InputError unless @p scheme is of finite volumes and the gas
  /// around the charges is uniform and at rest.
  void check(const Scheme &scheme, const InitialState<dim> &initial_state);

  bool empty() const
  {
    return charges_.empty();
  }

  /// What the constants of the explosive amount to, for the log.
  const std::string &description() const
  {
    return description_;
  }

  /// Detonation speed D [m/s].
  double speed() const
  {
    return speed_;
  }

  /// Of the unburned explosive [kg/m^3].
  double density() const
  {
    return density_;
  }

  /// 1 / (1 - V) at the Chapman-Jouguet state [-].
  double stiffness() const
  {
    return stiffness_;
  }

  /// Thickness of the burning zone in cells.
  double burn_width() const
  {
    return burn_width_;
  }

  /// Pressure of the gas around the charges, as the equation of state gives
  /// it back from its energy [Pa].
  double ambient_pressure() const
  {
    return ambient_pressure_;
  }

  /// Distance from the nearest charge [m], negative inside.
  double signed_distance(const dealii::Point<dim> &point) const;

  /// When the detonation has come to within @p lead [m] of a point, of the
  /// charges that are nearer than @p reach [m]; nothing if there are none.
  std::optional<double> arrival(const dealii::Point<dim> &point,
                                const double reach,
                                const double lead) const;

  /**
   * Puts the explosive, at rest and with all its energy, in the place of the
   * gas that @p field holds. Cells that a surface cuts get a mixture, and a
   * charge has its exact mass whatever the cells are, unless the boundary
   * cuts it elsewhere than in planes of symmetry. Collective.
   * @return one line for the log for each charge
   * @throws InputError for charges that overlap or miss the domain.
   */
  std::vector<std::string> fill(const LeafMesh<dim> &mesh,
                                const LeafPoints<dim> &points,
                                GasField &field) const;

private:
  std::vector<Charge<dim>> charges_;
  std::vector<std::string> names_;
  std::string description_;
  double density_ = 0.;        ///< of the explosive [kg/m^3]
  double energy_density_ = 0.; ///< of the explosive [J/m^3]
  double speed_ = 0.;
  double stiffness_ = 0.;
  double burn_width_ = 2.;
  double ambient_pressure_ = 0.;
  GasMaterial material_;
};
} // namespace contrecoup::gas
