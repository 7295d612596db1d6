// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/impact_plan.h>
#include <contrecoup/base/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  /// Of water at 37 C [m^2/s].
  constexpr double kinematic_viscosity = 0.7e-6;

  /// Pressure below the ambient one at which water cavitates, at the latest if
  /// it has germs [Pa].
  constexpr double cavitation_pressure = -1e5;

  constexpr double gravity = 9.80665;

  /// Regions whose liquid bears any tension.
  std::vector<std::size_t> tense_liquids(const std::vector<Region> &regions)
  {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < regions.size(); ++i)
    {
      const auto *const liquid = std::get_if<Tait>(&regions[i].law);
      if (liquid != nullptr && !(liquid->cavitation_density() > 0.))
        result.push_back(i);
    }
    return result;
  }

  bool has_liquid(const std::vector<Region> &regions)
  {
    return std::any_of(
      regions.begin(), regions.end(), [](const Region &region) {
        return std::holds_alternative<Tait>(region.law);
      });
  }

  Assumption cavitation(const Region &region, const double least_pressure)
  {
    return {"cavitation_" + region.name,
            "left out",
            "least pressure of " + region.name,
            "Pa",
            least_pressure,
            cavitation_pressure,
            true,
            "Region " + region.name + "/Least pressure"};
  }
} // namespace


std::vector<Assumption> ImpactPlan::plan() const
{
  std::vector<Assumption> items;
  for (const std::size_t i : tense_liquids(regions))
    items.push_back(cavitation(regions[i], unknown));
  if (!has_body_force)
    items.push_back(
      {"gravity",
       "left out",
       "its speed over that of the matter",
       "-",
       largest_speed > 0. ? gravity * end_time / largest_speed : unknown,
       0.05,
       false,
       "Body force/z"});
  if (has_liquid(regions))
    items.push_back({"viscosity",
                     "left out",
                     "its layer in water over a cell",
                     "-",
                     std::sqrt(kinematic_viscosity * end_time) / cell_size,
                     1.,
                     false,
                     "Mesh"});
  if (has_planes)
    items.push_back({"friction",
                     "as asked for",
                     "its work over the kinetic energy",
                     "-",
                     unknown,
                     unknown,
                     false,
                     "Plane */Friction"});
  if (part < 1.)
    items.push_back({"symmetry",
                     "a part is computed",
                     "of the whole body",
                     "-",
                     part,
                     unknown,
                     false,
                     "Mesh/Symmetry planes"});
  return items;
}


std::vector<Assumption> ImpactPlan::audit(const Findings &findings) const
{
  std::vector<Assumption> items = plan();
  const auto liquids = tense_liquids(regions);
  for (std::size_t k = 0; k < liquids.size(); ++k)
    items[k].value = findings.least_pressures[liquids[k]];
  for (Assumption &item : items)
    if (item.name == "friction")
      item.value = findings.kinetic_energy > 0.
                     ? (0. - findings.friction_work) / findings.kinetic_energy
                     : unknown;
  return items;
}
} // namespace contrecoup::ale
