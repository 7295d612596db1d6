// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/body_mass.h>
#include <contrecoup/numerics/injury/chest_wall.h>
#include <contrecoup/numerics/injury/load_injury.h>
#include <contrecoup/solid/injury/chest_injury.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace contrecoup::solid
{
void ChestInjury::declare_parameters(dealii::ParameterHandler &prm)
{
  declare_list(
    prm,
    "Chest",
    "0.12, 0, 1.3",
    3,
    3,
    -1e6,
    1e6,
    "m",
    selecting("Position of the chest; the pressure is that on the nearest "
              "loaded facet."));
  declare_bool(prm,
               "Chest load",
               "true",
               "Whether injuries by the load on the chest are reported; false "
               "where the blast reports them for its gauge \"chest\".");
  declare_double(prm,
                 "Chest radius",
                 "0.06",
                 0.,
                 1.,
                 "m",
                 "Radius around Chest within which the inward velocity of "
                 "boundary facets is averaged.");
  declare_body_mass(prm,
                    "Mass of the person, with which limits of lungs scale.");
}


void ChestInjury::parse_parameters(dealii::ParameterHandler &prm,
                                   const double phantom_mass)
{
  place_ = read_point<3>(prm, "Chest");
  reports_load_ = prm.get_bool("Chest load");
  radius_ = read_double(prm, "Chest radius");
  mass_ = read_body_mass(prm, phantom_mass);
  guesses_mass_ = is_mass_of_body(prm) && std::isnan(phantom_mass);
}


std::vector<std::string> ChestInjury::measure_names() const
{
  return reports_load_
           ? injury_measures_of({"chest"})
           : std::vector<std::string>{"injury_chest_wall_velocity_mesh"};
}


void ChestInjury::record(const double time,
                         const double pressure,
                         const double wall_velocity)
{
  times_.push_back(time);
  pressures_.push_back(pressure);
  wall_velocities_.push_back(wall_velocity);
}


std::vector<InjuryMeasure> ChestInjury::measures() const
{
  if (times_.size() < 2)
    return {};
  const auto [outward, inward] =
    std::minmax_element(wall_velocities_.begin(), wall_velocities_.end());
  // A wave from behind moves the wall outward alone, after round-off at rest.
  constexpr double round_off = 1e-9;
  std::vector<InjuryMeasure> list{
    known_measure("injury_chest_wall_velocity_mesh",
                  *inward > -round_off * *outward ? *inward : 0.)};
  list.back().is_cut = *inward > 0. && *inward == wall_velocities_.back();
  if (reports_load_)
    add_load(list);
  return list;
}


void ChestInjury::add_load(std::vector<InjuryMeasure> &list) const
{
  const LoadInjury injury = load_injury(times_, pressures_, mass_);
  const double velocity = injury.chest_wall_velocity;
  const auto add =
    [&](const std::string &name, const double value, const bool is_cut) {
      list.push_back(known_measure(name, value));
      list.back().is_cut = is_cut;
    };
  add("injury_chest_pressure_peak",
      injury.pulse.peak,
      pressures_.back() >= injury.pulse.peak);
  add("injury_chest_wall_velocity", velocity, injury.is_velocity_cut);
  add("injury_adjusted_severity",
      thorax_injury_index(velocity),
      injury.is_velocity_cut);
  if (injury.pulse.duration > 0.)
  {
    add("injury_lung_exposure", injury.lung_exposure, injury.pulse.is_cut);
    list.back().limits += "; for a body mass of " + brief(mass_, 3) + " kg";
  }
}


void ChestInjury::restore(std::vector<double> times,
                          std::vector<double> pressures,
                          std::vector<double> wall_velocities)
{
  times_ = std::move(times);
  pressures_ = std::move(pressures);
  wall_velocities_ = std::move(wall_velocities);
}
} // namespace contrecoup::solid
