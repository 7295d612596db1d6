// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <memory>
#include <string>
#include <vector>

namespace contrecoup::gas
{
template <int dim>
class InitialField;
template <int dim>
class ProfileField;
class Profile;

/**
 * State of the gas at time zero, read from subsection "Initial state". Entry
 * "Kind" selects one of initial_state_kinds; each kind has a subsection with
 * its values. Lengths are those of the mesh; where "Domain/Geometry" is
 * curvilinear, coordinate 0 is the radius.
 */
template <int dim>
class InitialState
{
public:
  InitialState();
  ~InitialState();

  /// Declares subsection "Initial state".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads subsections "Initial state" and "Domain", which must have been
   * declared. The material is copied.
   *
   * @throws InputError for a density that is not positive, a pressure that @p
   * material cannot have, a product fraction outside [0, 1], an expression
   * that cannot be parsed, a list of the wrong length.
   */
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasMaterial &material);

  /// State at @p point [m].
  /// @throws InputError when an expression gives an unphysical state there.
  GasState<dim> value(const dealii::Point<dim> &point) const;

  /// Ambient state at @p point [m], without any blast.
  GasState<dim> ambient(const dealii::Point<dim> &point) const;

  /// Time of this state [s]; non-zero only for a profile of a later time.
  double time() const;

  /// Profile that defines the state, or nullptr.
  const ProfileField<dim> *profile() const;

  /// Replaces the state by @p profile around @p centre [m]. The gas around the
  /// profile is the present ambient state at @p centre.
  /// @throws InputError when the profile does not fit the domain.
  void set_profile(std::shared_ptr<const Profile> profile,
                   const dealii::Point<dim> &centre);

  /**
   * Length [m] that samples must resolve for accurate means: the radius of a
   * small energy deposit, the thickness of a thin layer; infinite if there is
   * none.
   */
  double smallest_feature() const;

  /**
   * Lower bound [m] of the distance from @p point to the nearest position
   * where the state is not locally constant: zero inside a smoothly varying
   * field, infinite for a uniform one. Initial refinement uses it and cannot
   * miss a region smaller than a leaf.
   */
  double distance_to_feature(const dealii::Point<dim> &point) const;

  /// Reference pressure [Pa] of overpressures: that of the background; without
  /// a background, that at @p point.
  double ambient_pressure(const dealii::Point<dim> &point) const;

private:
  std::unique_ptr<const InitialField<dim>> field_;
  GasMaterial material_;
  Geometry geometry_ = Geometry::plane;
};

/// Names of the kinds of initial states.
extern const std::vector<std::string> initial_state_kinds;
} // namespace contrecoup::gas
