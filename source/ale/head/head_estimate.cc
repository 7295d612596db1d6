// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_estimate.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  using Axes = std::array<double, 3>;

  constexpr double scalp_thickness = 0.005; ///< [m]
  constexpr double scalp_density = 1100.;   ///< [kg/m^3]

  /// Radius of the sphere with the volume of the ellipsoid [m].
  double radius_of(const Axes &axes)
  {
    return std::cbrt(axes[0] * axes[1] * axes[2]);
  }

  double volume_of(const Axes &axes)
  {
    return 4. / 3. * dealii::numbers::PI * axes[0] * axes[1] * axes[2];
  }

  /// The first contact of an ellipsoid with a plane.
  struct FirstContact
  {
    double time = std::numeric_limits<double>::infinity(); ///< [s]
    double speed = 0.; ///< normal to the plane [m/s]
  };

  FirstContact first_contact(const RegionDescriptions &regions,
                             const ContactPlanes &planes,
                             const Axes &axes)
  {
    FirstContact first;
    for (const ContactPlane &plane : planes.planes())
    {
      dealii::Tensor<1, 3> reach;
      for (unsigned int d = 0; d < 3; ++d)
        reach[d] = axes[d] * plane.normal[d];
      const double gap =
        plane.normal * (dealii::Point<3>() - plane.point) - reach.norm();
      const double speed = -(regions.fastest_velocity() * plane.normal);
      const double time = std::max(0., gap) / speed;
      if (speed > 0. && time < first.time)
        first = {time, speed};
    }
    return first;
  }

  /// The skull, between two ellipsoids, as a spherical shell.
  std::optional<ShellImpact> shell_impact(const Axes &inner,
                                          const Axes &outer,
                                          const Region &skull,
                                          const double mass,
                                          const double speed)
  {
    const SolidMaterial *solid = skull.solid();
    if (solid == nullptr || !(solid->instantaneous_shear > 0.) || !(speed > 0.))
      return {};
    const double bulk = solid->bulk_modulus, shear = solid->instantaneous_shear;
    ShellImpact impact;
    impact.mass = mass;
    impact.radius = 0.5 * (radius_of(inner) + radius_of(outer));
    impact.thickness = outer[0] - inner[0];
    impact.young_modulus = 9. * bulk * shear / (3. * bulk + shear);
    impact.poisson_ratio =
      (3. * bulk - 2. * shear) / (2. * (3. * bulk + shear));
    impact.speed = speed;
    return impact;
  }
} // namespace


std::optional<HeadEstimate> estimate_head(const MeshDescription &mesh,
                                          const RegionDescriptions &regions,
                                          const ContactPlanes &planes)
{
  const LayeredHead *head = mesh.head();
  if (head == nullptr)
    return {};
  const auto &axes = head->semi_axes();
  const auto &layers = head->layers();
  HeadEstimate result;
  std::size_t skull = 0;
  for (std::size_t i = 0; i < layers.size(); ++i)
  {
    const double within = i == 0 ? 0. : axes[i - 1][2];
    const dealii::Point<3> middle(0., 0., 0.5 * (within + axes[i][2]));
    const double volume =
      volume_of(axes[i]) - (i == 0 ? 0. : volume_of(axes[i - 1]));
    result.mass += volume * regions.density_at(middle, layers[i]);
    result.has_scalp = result.has_scalp || layers[i].name == "scalp";
    if (layers[i].name == "skull")
      skull = i;
  }
  Axes covered = axes.back();
  for (double &axis : covered)
    axis += scalp_thickness;
  result.scalp_mass =
    scalp_density * (volume_of(covered) - volume_of(axes.back()));
  const dealii::Point<3> bone(
    0., 0., 0.5 * (axes[skull - 1][2] + axes[skull][2]));
  result.liquid_radius = radius_of(axes[skull - 1]);
  const FirstContact contact = first_contact(regions, planes, axes.back());
  result.contact_begins = contact.time;
  result.impact = shell_impact(axes[skull - 1],
                               axes[skull],
                               regions.region_at(bone, {"skull", {}}),
                               result.mass,
                               contact.speed);
  return result;
}
} // namespace contrecoup::ale
