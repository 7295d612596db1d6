// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/materials/gas_material.h>

#include <memory>
#include <optional>
#include <vector>

namespace contrecoup::gas
{
/**
 * A profile put into a domain: around a centre (spherical ones in 1-D, in
 * axisymmetric 2-D and in 3-D), around an axis along z (cylindrical ones in
 * plane 2-D and in 3-D) or around such an axis and along it (axisymmetric
 * ones, in axisymmetric 2-D and in 3-D). Around it is the background.
 */
template <int dim>
class ProfileField : public InitialField<dim>
{
public:
  /// Declares subsection "Profile" of "Initial state".
  static void declare_parameters(ParameterHandler &prm);

  /// Reads the subsections "Background" and "Profile" of the current one and
  /// the profile.
  ProfileField(ParameterHandler &prm,
               const GasMaterial &material,
               Geometry geometry);

  /// @throws InputError when the profile does not go with the geometry or
  /// its ambient state is not @p background.
  ProfileField(std::shared_ptr<const Profile> profile,
               const dealii::Point<dim> &centre,
               const GasState<dim> &background,
               const GasMaterial &material,
               Geometry geometry);

  const Profile &profile() const
  {
    return *profile_;
  }
  /// Place of the profile's centre or of the origin of its axis [m].
  const dealii::Point<dim> &centre() const
  {
    return centre_;
  }
  double time() const override
  {
    return profile_->data().time;
  }

  GasState<dim> value(const dealii::Point<dim> &point) const override;
  GasState<dim> ambient(const dealii::Point<dim> &) const override
  {
    return background_;
  }
  std::optional<double> background_pressure() const override
  {
    return background_.pressure;
  }

  /// The undisturbed conserved state: density, momentum, energy, products.
  const std::vector<double> &ambient_state() const
  {
    return ambient_;
  }

  /// Bounds of a window of the profile around a place.
  struct Window
  {
    std::array<double, 2> place{}; ///< in the profile's coordinates [m]
    std::array<double, 2> width{}; ///< [m]
    std::array<double, 2> reach{}; ///< from the place to the far corners [m]
    /// Unit vectors of the profile's directions there.
    std::array<dealii::Tensor<1, dim>, 2> direction;
  };

  /// The window that stands for a parallelepiped around @p place with these
  /// edges: as wide as a bar with the same mean square distance from its
  /// middle, and at the mean distance from the centre, so that a mean over
  /// the window is one over the parallelepiped to third order.
  Window window(const dealii::Point<dim> &place,
                const std::array<dealii::Tensor<1, dim>, dim> &edges) const;

  /// Whether the window's reach and @p distance more are outside of the
  /// raster.
  bool is_beyond(const Window &window, const double distance = 0.) const;

  /// Relative change within the window's reach, see Profile::variation().
  double variation(const Window &window) const;

  /// Mean excess of the conserved quantities over the ambient state in the
  /// window, which is taken no narrower than the profile's cells.
  void mean(const Window &window, std::vector<double> &excess) const;

  /// The part of the profile's whole body within the box between @p lower
  /// and @p upper: 1, or a half for each plane through the centre that
  /// bounds the box; nothing when the box cuts it otherwise.
  std::optional<double> part_within(const dealii::Point<dim> &lower,
                                    const dealii::Point<dim> &upper) const;

  /// Volume integrals of the excess of density, energy and products over
  /// that part [kg, J, kg].
  std::array<double, 3> totals(const double part,
                               const dealii::Point<dim> &lower,
                               const dealii::Point<dim> &upper) const;

private:
  void check(Geometry geometry) const;

  std::shared_ptr<const Profile> profile_;
  dealii::Point<dim> centre_;
  GasState<dim> background_;
  GasMaterial material_;
  std::vector<double> ambient_;
  /// Directions of the domain that the profile's radius spans.
  unsigned int n_radial_ = dim;
  bool is_axisymmetric_target_ = false;
};
} // namespace contrecoup::gas
