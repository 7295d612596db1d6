// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/impact_plan.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  /// Kinematic viscosity of water at 37 C [m^2/s].
  constexpr double kinematic_viscosity = 0.7e-6;

  /// Gauge pressure at which water with nuclei cavitates [Pa].
  constexpr double cavitation_pressure = -1e5;

  constexpr double gravity = 9.80665;

  /// Approximate friction coefficient of skin on a wall [-].
  constexpr double usual_friction = 0.3;

  /// Fraction of the energy that may be neglected [-].
  constexpr double small_part = 0.05;

  /// Numbers of regions with a liquid that sustains any tension.
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

  Assumption for_information(const std::string &name,
                             const std::string &decision,
                             const std::string &quantity,
                             const double value,
                             const std::string &entry)
  {
    return {name, decision, quantity, "-", value, unknown, false, entry};
  }
} // namespace


bool ImpactPlan::has_friction() const
{
  return std::any_of(
    planes.begin(), planes.end(), [](const ContactPlane &plane) {
      return plane.friction > 0.;
    });
}


double ImpactPlan::expected_tension(const Region &region) const
{
  const bool is_known =
    head && head->impact &&
    end_time > head->contact_begins + 0.5 * head->impact->contact_time();
  return is_known ? -head->impact->peak_pressure(
                      std::get<Tait>(region.law).density(), head->liquid_radius)
                  : unknown;
}


double ImpactPlan::expected_friction() const
{
  // A fully rebounding body receives at most twice its normal momentum, and
  // friction at most that impulse times the coefficient.
  double largest = 0.;
  for (const ContactPlane &plane : planes)
  {
    const double inwards = std::max(0., -(velocity * plane.normal));
    const double along =
      (velocity - (velocity * plane.normal) * plane.normal).norm();
    const double coefficient = has_friction() ? plane.friction : usual_friction;
    if (inwards > 0.)
      largest = std::max(largest,
                         std::min(along, 4. * coefficient * inwards) * along /
                           velocity.norm_square());
  }
  return largest;
}


void ImpactPlan::add_liquids(std::vector<Assumption> &items) const
{
  for (const std::size_t i : tense_liquids(regions))
    items.push_back({"cavitation_" + regions[i].name,
                     "left out",
                     "least pressure of " + regions[i].name,
                     "Pa",
                     expected_tension(regions[i]),
                     cavitation_pressure,
                     true,
                     "Region " + regions[i].name + "/Least pressure"});
}


void ImpactPlan::add_contact(std::vector<Assumption> &items) const
{
  if (planes.empty())
    return;
  items.push_back(
    {"contact",
     "followed until the end time",
     "end of contact over end time",
     "-",
     head && head->impact
       ? (head->contact_begins + head->impact->contact_time()) / end_time
       : unknown,
     0.999,
     false,
     "Time/End time"});
  items.push_back(
    {"friction",
     has_friction() ? "as asked for" : "left out",
     (has_friction() ? "its work"
                     : "work of a coefficient of " + brief(usual_friction)) +
       " over the kinetic energy",
     "-",
     expected_friction(),
     has_friction() ? unknown : small_part,
     false,
     "Plane */Friction"});
}


void ImpactPlan::add_symmetry(std::vector<Assumption> &items) const
{
  const std::string entry = "Mesh/Symmetry planes",
                    wedge_entry = "Mesh/Wedge axis";
  if (computed_fraction < 1.)
  {
    items.push_back(
      for_information("symmetry",
                      (wedge.empty() ? brief(computed_fraction) + " of the body"
                                     : "a wedge about " + wedge) +
                        " is computed",
                      "saved fraction of the cost of the whole body",
                      1. - cost,
                      wedge.empty() ? entry : wedge_entry));
    items.push_back({"asymmetry",
                     "mirrored",
                     "normals of walls across planes of symmetry",
                     "-",
                     asymmetry,
                     0.,
                     false,
                     entry});
  }
  if (least_cost < cost)
    items.push_back(for_information(
      "unused_symmetry",
      (least_cost_wedge.empty() ? brief(least_cost) + " of the body"
                                : "a wedge about " + least_cost_wedge) +
        " would suffice",
      "fraction of the cost that further symmetry would save",
      1. - least_cost / cost,
      least_cost_wedge.empty() ? entry : wedge_entry));
}


std::vector<Assumption> ImpactPlan::plan() const
{
  std::vector<Assumption> items;
  add_liquids(items);
  add_contact(items);
  if (!has_body_force)
    items.push_back(
      {"gravity",
       "left out",
       "speed due to gravity over impact speed",
       "-",
       velocity.norm() > 0. ? gravity * end_time / velocity.norm() : unknown,
       small_part,
       false,
       "Body force/z"});
  if (has_liquid(regions))
    items.push_back({"viscosity",
                     "left out",
                     "boundary layer of water over a cell",
                     "-",
                     std::sqrt(kinematic_viscosity * end_time) / cell_size,
                     1.,
                     false,
                     "Mesh"});
  if (!has_brain && (head || n_pieces > 0))
    items.push_back(
      for_information("brain",
                      "none: no region gets measures of its injury",
                      "regions that Injury/Brain names",
                      0.,
                      "Injury/Brain"));
  if (head && !head->has_scalp)
    items.push_back(
      for_information("scalp",
                      "left out",
                      "mass of 5 mm of scalp over that of the head",
                      head->scalp_mass / head->mass,
                      "Mesh/Scalp thickness"));
  add_symmetry(items);
  if (!coupling.empty())
    items.push_back({"coupling",
                     "fluids and solids in turn, " + coupling,
                     "spurious energy at interfaces over total",
                     "-",
                     unknown,
                     0.01,
                     false,
                     "Coupling/Scheme"});
  if (n_pieces > 0)
    add_file(items);
  for (const Assumption &item : thresholds.assumptions())
    items.push_back(item);
  return items;
}


void ImpactPlan::add_file(std::vector<Assumption> &items) const
{
  items.push_back({"mesh",
                   "as the file has it",
                   "smallest scaled Jacobian",
                   "-",
                   scaled_jacobian,
                   0.2,
                   true,
                   "Mesh/Smallest scaled Jacobian"});
  items.push_back({"pieces",
                   "no contact between them",
                   "face-connected sets of cells",
                   "-",
                   double(n_pieces),
                   1.,
                   false,
                   "Mesh/File"});
}


std::vector<Assumption> ImpactPlan::audit(const ImpactResults &results) const
{
  std::vector<Assumption> items = unmeasured(plan());
  const auto liquids = tense_liquids(regions);
  for (std::size_t k = 0; k < liquids.size(); ++k)
    items[k].measure(results.least_pressures[liquids[k]]);
  const double friction = has_friction()
                            ? 0. - results.friction_work
                            : usual_friction * results.sliding_work;
  // A run that stops before the contact or within it has not seen its end.
  const ContactRecord &contact = results.contact;
  const bool is_followed =
    results.time >= (1. - 1e-9) * end_time ||
    (contact.begin >= 0. && !contact.lasts(results.time));
  for (Assumption &item : items)
  {
    if (item.name == "contact")
      item.measure(is_followed ? std::max(0., contact.end) / end_time
                               : unknown);
    if (item.name == "friction")
      item.measure(results.kinetic_energy > 0.
                     ? friction / results.kinetic_energy
                     : unknown);
    if (item.name == "coupling")
      item.measure(std::abs(results.interface_work) / results.largest_energy);
  }
  return items;
}
} // namespace contrecoup::ale
