// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/gas/conditions/profile.h>
#include <contrecoup/materials/gas_material.h>

#include <memory>
#include <optional>
#include <vector>

namespace contrecoup::gas
{
/**
 * Profile placed in a domain: spherical profiles around a centre (in 1-D,
 * axisymmetric 2-D and 3-D), cylindrical ones around an axis parallel to z (in
 * plane 2-D and 3-D), axisymmetric ones around and along such an axis (in
 * axisymmetric 2-D and in 3-D). The gas around the profile is the background.
 */
template <int dim>
class ProfileField : public InitialField<dim>
{
public:
  /// Declares subsection "Profile" of "Initial state".
  static void declare_parameters(ParameterHandler &prm);

  /// Reads the subsections "Background" and "Profile" of the current one and
  /// the profile file.
  ProfileField(ParameterHandler &prm,
               const GasMaterial &material,
               Geometry geometry);

  /// @throws InputError when the profile does not fit the geometry or its
  /// ambient state differs from @p background.
  ProfileField(std::shared_ptr<const Profile> profile,
               const dealii::Point<dim> &centre,
               const GasState<dim> &background,
               const GasMaterial &material,
               Geometry geometry);

  const Profile &profile() const
  {
    return *profile_;
  }
  /// Position of the profile's centre or of the origin of its axis [m].
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

  /// Ambient conserved state: density, momentum, energy, products.
  const std::vector<double> &ambient_state() const
  {
    return ambient_;
  }

  /// Window of the profile around a position.
  struct Window
  {
    /// centre, in the profile's coordinates [m]
    std::array<double, 2> place{};
    std::array<double, 2> width{}; ///< edge lengths [m]
    /// Half the extents of the parallelepiped [m]
    std::array<double, 2> half_extent{};
    /// Unit vectors of the profile's directions at the centre.
    std::array<dealii::Tensor<1, dim>, 2> direction;
  };

  /// Window that replaces a parallelepiped around @p place with edge vectors
  /// @p edges. Its width has the same second moment as the parallelepiped, and
  /// its centre lies at the mean distance from the profile's centre, so that
  /// the mean over the window agrees with the mean over the parallelepiped to
  /// third order.
  Window window(const dealii::Point<dim> &place,
                const std::array<dealii::Tensor<1, dim>, dim> &edges) const;

  /// Whether the extents of the parallelepiped, enlarged by @p distance [m],
  /// lie outside of the raster.
  bool is_beyond(const Window &window, const double distance = 0.) const;

  /// Relative variation within the extents of the parallelepiped, see
  /// Profile::variation().
  double variation(const Window &window) const;

  /// Mean excess of the conserved quantities over the ambient state in the
  /// window, whose width is at least that of the profile's cells.
  void mean(const Window &window, std::vector<double> &excess) const;

  /// Fraction of the profile inside the box between @p lower and @p upper [m]:
  /// 1, halved for each side of the box that is a plane through the centre;
  /// nothing if the box cuts the profile otherwise.
  std::optional<double> fraction_within(const dealii::Point<dim> &lower,
                                        const dealii::Point<dim> &upper) const;

  /// Volume integrals of the excess of density, energy and products over the
  /// @p fraction of the profile [kg, J, kg].
  std::array<double, 3> totals(const double fraction,
                               const dealii::Point<dim> &lower,
                               const dealii::Point<dim> &upper) const;

private:
  void check(Geometry geometry) const;

  std::shared_ptr<const Profile> profile_;
  dealii::Point<dim> centre_;
  GasState<dim> background_;
  GasMaterial material_;
  std::vector<double> ambient_;
  /// Number of directions of the domain that the profile's radius spans.
  unsigned int n_radial_ = dim;
  bool is_axisymmetric_target_ = false;
};
} // namespace contrecoup::gas
