// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/geometry/coarse_mesh.h>
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
 * The gas at time zero, as subsection "Initial state" of the parameter file
 * describes it. Entry "Kind" names one of the kinds that
 * initial_state_kinds lists; a subsection for each holds its numbers.
 * Lengths are those of the mesh; where "Domain/Geometry" is curvilinear,
 * coordinate 0 is the radius.
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
   * @throws InputError for a density that is not positive, a pressure that
   * @p material cannot have, a product fraction outside [0, 1], an
   * expression that cannot be read, a list of the wrong length.
   */
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasMaterial &material);

  /// The state at @p point.
  /// @throws InputError when an expression gives an unphysical state there.
  GasState<dim> value(const dealii::Point<dim> &point) const;

  /// The state at @p point before anything happened.
  GasState<dim> ambient(const dealii::Point<dim> &point) const;

  /// The time of this state [s], 0 unless a profile was made later.
  double time() const;

  /// The profile that the state is made of, or nullptr.
  const ProfileField<dim> *profile() const;

  /// Replaces the state by @p profile around @p centre, within the gas that
  /// is at the centre in the present state before anything happened.
  /// @throws InputError when it does not go with the domain.
  void set_profile(std::shared_ptr<const Profile> profile,
                   const dealii::Point<dim> &centre);

  /**
   * The length [m] that samples must resolve for cell means to be right:
   * the radius of a small energy deposit, the thickness of a thin layer;
   * infinite when there is no such length.
   */
  double smallest_feature() const;

  /**
   * A lower bound [m] of the distance from @p point to the nearest place
   * where the state is not locally constant: zero inside a smoothly varying
   * field, infinite for a uniform one. Initial refinement can follow it
   * without a risk of missing a region that is smaller than a cell.
   */
  double distance_to_feature(const dealii::Point<dim> &point) const;

  /// The pressure [Pa] above which overpressures count: that of the
  /// background; where the state has none, that at @p point.
  double ambient_pressure(const dealii::Point<dim> &point) const;

private:
  std::unique_ptr<const InitialField<dim>> field_;
  GasMaterial material_;
  Geometry geometry_ = Geometry::plane;
};

/// The kinds of initial states.
extern const std::vector<std::string> initial_state_kinds;
} // namespace contrecoup::gas
