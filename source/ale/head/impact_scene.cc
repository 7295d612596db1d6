// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/impact_scene.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
void ImpactScene::declare_parameters(ParameterHandler &prm)
{
  MeshDescription::declare_parameters(prm);
  RegionDescriptions::declare_parameters(prm);
  ContactPlanes::declare_parameters(prm);
  {
    const Section section(prm, "Body force");
    for (const char *const name : {"x", "y", "z"})
      declare_string(prm,
                     name,
                     "0",
                     "Body force per mass [m/s^2], a muParser expression of "
                     "t; with particles also of the initial x, y, z.");
  }
  {
    const Section section(prm, "Scheme");
    declare_double(
      prm,
      "Courant number",
      "0.3",
      0.01,
      1.,
      "-",
      "Step size over the time that signals take to cross a cell.");
    declare_integer(
      prm,
      "Largest number of retries",
      "10",
      0,
      50,
      "How often a step may be halved when a cell inverts, 0 to 50.");
  }
  const Section section(prm, "Probes");
  declare_points(
    prm,
    "Points",
    "",
    "m",
    selecting("Probe positions; the cell there at the start is recorded."));
}


void ImpactScene::parse_parameters(ParameterHandler &prm)
{
  mesh.parse_parameters(prm);
  regions.parse_parameters(prm);
  planes.parse_parameters(prm);
  {
    const Section section(prm, "Body force");
    for (unsigned int d = 0; d < 3; ++d)
    {
      const std::string name(1, "xyz"[d]);
      acceleration[d] = Expression("Body force/" + name, prm.get(name));
    }
  }
  {
    const Section section(prm, "Scheme");
    courant_number = read_double(prm, "Courant number");
    largest_retries = read_unsigned(prm, "Largest number of retries");
  }
  {
    const Section section(prm, "Probes");
    probes = read_points<3>(prm, "Points");
  }
  const Section section(prm, "Time");
  end_time = read_double(prm, "End time");
}


bool ImpactScene::has_body_force() const
{
  return std::any_of(acceleration.begin(),
                     acceleration.end(),
                     [](const Expression &one) { return !one.is_zero(); });
}


double ImpactScene::motion_along(const unsigned int axis) const
{
  const double component = regions.largest_components()[axis];
  double motion =
    component > 0. ? component / regions.fastest_velocity().norm() : 0.;
  for (const ContactPlane &plane : planes.planes())
    motion = std::max(motion, std::abs(plane.normal[axis]));
  return acceleration[axis].is_zero() ? motion : 1.;
}


ImpactPlan ImpactScene::plan(const HeadRecord &head) const
{
  ImpactPlan plan;
  plan.regions = regions.regions();
  plan.planes = planes.planes();
  plan.head = estimate_head(mesh, regions, planes);
  plan.end_time = end_time;
  plan.thresholds = head.own_thresholds();
  plan.has_brain = head.has_brain();
  plan.velocity = regions.fastest_velocity();
  plan.computed_fraction = plan.cost = plan.least_cost =
    mesh.computed_fraction();
  plan.has_body_force = has_body_force();
  for (unsigned int d = 0; d < 3; ++d)
    if (has_symmetry_plane(d))
      plan.asymmetry = std::max(plan.asymmetry, motion_along(d));
  return plan;
}
} // namespace contrecoup::ale
