// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/gas/run/modelling_plan.h>
#include <contrecoup/numerics/injury/expected_blast.h>
#include <contrecoup/numerics/injury/wave_reflection.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <optional>
#include <ostream>

namespace contrecoup::gas
{
namespace
{
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

  /// Gravity [m/s^2].
  constexpr double gravity = 9.81;
  /// Viscosity of air at 288 K [Pa s], and thermal diffusivity over it [-].
  constexpr double viscosity_of_air = 1.8e-5;
  constexpr double inverse_prandtl_number = 1.4;

  /// Thickness of a diffusive boundary layer after @p time [m].
  double diffusion_length(const double diffusivity, const double time)
  {
    return std::sqrt(diffusivity * std::max(0., time));
  }

  const std::string first_reflection = "first reflection from an open side at ";
  /// By what the run has seen of the way there.
  const std::string earliest_reflection =
    "earliest possible reflection from an open side at ";

  /// A gauge in words.
  template <int dim>
  std::string place_of(const dealii::Point<dim> &gauge)
  {
    return "the probe at " + coordinates(gauge) + " m";
  }

  /// The items on neglected physics of air, without values.
  std::vector<Assumption> omitted_physics(const bool has_probes)
  {
    std::vector<Assumption> result;
    if (has_probes)
    {
      result.push_back({"air",
                        "constant heat capacities",
                        "excess pressure behind the incident front at the "
                        "nearest of Probes/Points",
                        "-",
                        unknown,
                        0.1,
                        false,
                        "Material/Equation of state"});
      result.push_back({"gravity",
                        "left out",
                        "its speed over the gas speed at the farthest of "
                        "Probes/Points",
                        "-",
                        unknown,
                        0.05,
                        false,
                        "Time/End time"});
    }
    for (const char *name : {"viscosity", "heat_conduction"})
      result.push_back({name,
                        "left out",
                        "its boundary layer at the end over a subcell",
                        "-",
                        unknown,
                        1.,
                        false,
                        "Time/End time"});
    return result;
  }


  bool is_of_air(const Assumption &item)
  {
    const std::vector<Assumption> all = omitted_physics(true);
    return std::any_of(all.begin(), all.end(), [&](const Assumption &other) {
      return other.name == item.name;
    });
  }
} // namespace


template <int dim>
bool ModellingPlan<dim>::is_air() const
{
  const double ratio = ambient.pressure / ambient.density;
  return ratio > 6e4 && ratio < 1e5 && ambient.products == 0. &&
         ambient.density > 0.3;
}


template <int dim>
std::vector<Assumption> ModellingPlan<dim>::items() const
{
  std::vector<Assumption> result;
  if (dim > 1 && is_spherical && energy > 0.)
    result.push_back({"first_stage",
                      "none",
                      "fraction of the time for which 1-D suffices",
                      "-",
                      unknown,
                      unknown,
                      false,
                      "First stage/Kind"});
  if (!std::isnan(non_ideal_fraction))
    result.push_back({"equation_of_state",
                      "JWL for products",
                      "fraction of their pressure that an ideal gas lacks",
                      "-",
                      unknown,
                      unknown,
                      false,
                      "Material/Equation of state"});
  if (!open_sides.empty() && !gauges.empty())
    result.push_back({"reflection",
                      "open sides far enough away",
                      first_reflection + "a probe",
                      "s",
                      unknown,
                      end_time,
                      true,
                      "Domain/Size"});
  if (is_air() || surrounds_explosives)
    for (const Assumption &item : omitted_physics(!probes.empty()))
      result.push_back(item);
  if (skips_quiet_leaves)
    result.push_back({"quiet_leaves",
                      "not computed",
                      "fraction of skipped updates",
                      "-",
                      unknown,
                      unknown,
                      false,
                      "Method/Skip quiet leaves"});
  if (n_symmetry_planes > 0)
    result.push_back({"modelled_part",
                      n_symmetry_planes == 1   ? "half of the gas"
                      : n_symmetry_planes == 2 ? "a quarter of the gas"
                                               : "an eighth of the gas",
                      "fraction of the whole gas in masses, momenta, energies",
                      "-",
                      std::ldexp(1., -static_cast<int>(n_symmetry_planes)),
                      unknown,
                      false,
                      "Boundaries"});
  return result;
}


template <int dim>
std::vector<ReflectedPath<dim>> ModellingPlan<dim>::paths_by_open_sides() const
{
  return reflected_paths<dim>(
    centre, lower, upper, open_sides, [&](const dealii::Point<dim> &image) {
      return *std::min_element(
        gauges.begin(), gauges.end(), [&](const auto &one, const auto &other) {
          return image.distance_square(one) < image.distance_square(other);
        });
    });
}


template <int dim>
double ModellingPlan<dim>::expected_front(const double time) const
{
  return energy > 0. && is_spherical
           ? ExpectedBlast(energy, ambient.pressure, ambient.density)
               .radius(time)
           : unknown;
}


template <int dim>
double ModellingPlan<dim>::expected_reach(const double time) const
{
  if (!(energy > 0.) || !is_spherical)
    return unknown;
  const double whole =
    energy_of_wave(expected_front(time), [&](const unsigned int wall) {
      double least = std::abs(place_of_side(wall) - centre[wall / 2]);
      for (const auto &gauge : gauges)
        least =
          std::min(least, std::abs(place_of_side(wall) - gauge[wall / 2]));
      return least;
    });
  // The earliest front is at most some per cent before the point source.
  constexpr double step = 1.002;
  double reach =
    ExpectedBlast(whole, ambient.pressure, ambient.density).radius(time);
  while (earliest_front(
           whole, ambient.pressure, ambient.density, step * reach) < time)
    reach *= step;
  return reach;
}


template <int dim>
bool ModellingPlan<dim>::is_reflected_at(const dealii::Point<dim> &place) const
{
  return std::any_of(walls.begin(), walls.end(), [&](const unsigned int wall) {
    const unsigned int d = wall / 2;
    const double tolerance = 1e-9 * (upper[d] - lower[d]);
    return std::abs(place[d] - place_of_side(wall)) <= tolerance &&
           std::abs(centre[d] - place_of_side(wall)) > tolerance;
  });
}


template <int dim>
double ModellingPlan<dim>::place_of_side(const unsigned int side) const
{
  return (side % 2 == 0 ? lower : upper)[side / 2];
}


template <int dim>
double ModellingPlan<dim>::energy_of_wave(
  const double way,
  const std::function<double(unsigned int)> &behind) const
{
  const bool merges =
    std::any_of(walls.begin(), walls.end(), [&](const unsigned int wall) {
      const unsigned int d = wall / 2;
      const double gap = std::abs(place_of_side(wall) - centre[d]);
      // The energy is in full space where the centre is on the wall.
      return gap > 1e-9 * (upper[d] - lower[d]) &&
             merges_with_reflection(
               energy, ambient.pressure, {way, gap, behind(wall)});
    });
  return (merges ? energy_with_image : 1.) * energy;
}


template <int dim>
double ModellingPlan<dim>::earliest_return(const ReflectedPath<dim> &path) const
{
  const double whole =
    energy_of_wave(path.length, [&](const unsigned int wall) {
      const unsigned int d = wall / 2;
      const double place = place_of_side(wall);
      // By a side opposite to the wall, the way begins next to the wall.
      return d == path.side / 2 ? std::abs(path.image[d] - path.gauge[d]) +
                                    std::abs(place - centre[d])
                                : std::abs(place - path.gauge[d]);
    });
  return earliest_front(whole, ambient.pressure, ambient.density, path.length);
}


template <int dim>
void ModellingPlan<dim>::expect_return(Assumption &item) const
{
  double earliest = OpenSides<dim>::never;
  for (const ReflectedPath<dim> &path : paths_by_open_sides())
    if (const double time = earliest_return(path); time < earliest)
    {
      item.value = earliest = time;
      item.quantity = first_reflection + place_of(path.gauge);
    }
}


template <int dim>
double ModellingPlan<dim>::expected_end_of_symmetry() const
{
  const ExpectedBlast blast(energy, ambient.pressure, ambient.density);
  double nearest = OpenSides<dim>::never;
  for (unsigned int d = 0; d < dim; ++d)
    for (const double distance : {centre[d] - lower[d], upper[d] - centre[d]})
      if (distance > 1e-9 * (upper[d] - lower[d]))
        nearest = std::min(nearest, distance);
  return blast.arrival(nearest);
}


template <int dim>
void ModellingPlan<dim>::measure_return(const Measurements &measured,
                                        Assumption &item) const
{
  // On the way back from the side it is a weak wave.
  const double sound_speed =
    std::sqrt(1.4 * ambient.pressure / ambient.density);
  item.value = OpenSides<dim>::never;
  // Along a side it goes with the front, not at the speed of sound on the way
  // back.
  double expected = OpenSides<dim>::never;
  dealii::Point<dim> disturbed;
  for (const ReflectedPath<dim> &path : paths_by_open_sides())
  {
    const bool is_reached = measured.side_arrivals[path.side] <= measured.time;
    const double reached =
      is_reached ? measured.side_arrivals[path.side] : measured.time;
    const double back = reached + (path.length - path.to_side) / sound_speed;
    if (is_reached && energy > 0. && is_spherical)
      if (const double time = earliest_return(path); time < expected)
      {
        expected = time;
        disturbed = path.gauge;
      }
    if (back >= item.value)
      continue;
    item.value = back;
    item.quantity =
      (back > measured.time ? earliest_reflection : first_reflection) +
      place_of(path.gauge);
  }
  // The measured time is too late: the estimate stands.
  if (expected < std::min(item.value, end_time))
  {
    item.quantity = first_reflection + place_of(disturbed);
    item.value = unknown;
  }
  // A return after the end of a stopped run is not known of the whole one.
  else if (item.value > measured.time && measured.time < end_time * (1. - 1e-9))
    item.value = unknown;
}


template <int dim>
double ModellingPlan<dim>::expected_quiet_fraction() const
{
  const ExpectedBlast blast(energy, ambient.pressure, ambient.density);
  const unsigned int n = dim == 3 ? 12 : 40;
  double sum = 0., count = 0.;
  std::array<unsigned int, 3> index{};
  for (index[2] = 0; index[2] < (dim > 2 ? n : 1); ++index[2])
    for (index[1] = 0; index[1] < (dim > 1 ? n : 1); ++index[1])
      for (index[0] = 0; index[0] < n; ++index[0])
      {
        dealii::Point<dim> place;
        for (unsigned int d = 0; d < dim; ++d)
          place[d] = lower[d] + (upper[d] - lower[d]) * (index[d] + 0.5) / n;
        sum += std::min(1., blast.arrival(place.distance(centre)) / end_time);
        count += 1.;
      }
  return sum / count;
}


template <int dim>
std::vector<Assumption> ModellingPlan<dim>::plan() const
{
  std::vector<Assumption> result = items();
  const double diffusivity = viscosity_of_air / ambient.density;
  std::optional<ExpectedBlast> blast;
  double nearest = OpenSides<dim>::never, farthest = 0.;
  if (energy > 0. && is_spherical)
    blast.emplace(energy, ambient.pressure, ambient.density);
  for (const auto &probe : probes)
  {
    nearest = std::min(nearest, std::max(1e-3, probe.distance(centre)));
    farthest = std::max(farthest, probe.distance(centre));
  }
  for (Assumption &item : result)
    if (is_of_air(item) && !is_air())
      item.value = unknown;
    else if (item.name == "viscosity")
      item.value = diffusion_length(diffusivity, end_time) / smallest_subcell;
    else if (item.name == "heat_conduction")
      item.value =
        diffusion_length(diffusivity * inverse_prandtl_number, end_time) /
        smallest_subcell;
    else if (item.name == "equation_of_state")
      item.value = non_ideal_fraction;
    else if (!blast)
      continue;
    else if (item.name == "first_stage")
      item.value = std::min(1., expected_end_of_symmetry() / end_time);
    else if (item.name == "reflection")
      expect_return(item);
    else if (item.name == "air")
      item.value = excess_pressure_of_perfect_air(
        blast->overpressure(nearest), ambient.pressure, ambient.density);
    else if (item.name == "gravity")
      item.value =
        gravity * end_time /
        speed_behind_shock(blast->overpressure(std::max(1e-3, farthest)),
                           ambient.pressure,
                           ambient.density);
    else if (item.name == "quiet_leaves" && !adapts)
      item.value = expected_quiet_fraction();
  return result;
}


template <int dim>
std::vector<Assumption>
ModellingPlan<dim>::audit(const Measurements &measured) const
{
  ModellingPlan<dim> known = *this;
  if (std::isnan(non_ideal_fraction))
    known.non_ideal_fraction = measured.non_ideal_fraction;
  std::vector<Assumption> result = known.items();
  // The fraction of the time for which 1-D suffices is not measured.
  result.erase(std::remove_if(result.begin(),
                              result.end(),
                              [](const Assumption &item) {
                                return item.name == "first_stage";
                              }),
               result.end());
  const double diffusivity = viscosity_of_air / ambient.density;
  double strongest = 0., weakest = OpenSides<dim>::never;
  for (const double peak : measured.peaks)
  {
    strongest = std::max(strongest, peak);
    if (peak > 0.)
      weakest = std::min(weakest, peak);
  }
  for (Assumption &item : result)
    if (is_of_air(item) && !is_air())
      item.value = unknown;
    else if (item.name == "viscosity")
      item.value = diffusion_length(diffusivity, measured.time) /
                   measured.smallest_subcell;
    else if (item.name == "heat_conduction")
      item.value =
        diffusion_length(diffusivity * inverse_prandtl_number, measured.time) /
        measured.smallest_subcell;
    else if (item.name == "reflection")
      measure_return(measured, item);
    else if (item.name == "quiet_leaves")
      item.value = measured.skipped;
    else if (item.name == "equation_of_state")
      item.value = measured.non_ideal_fraction;
    else if (!(strongest > 0.))
      continue;
    else if (item.name == "air")
      item.value = excess_pressure_of_perfect_air(
        strongest, ambient.pressure, ambient.density);
    else if (item.name == "gravity")
      item.value =
        gravity * measured.time /
        speed_behind_shock(weakest, ambient.pressure, ambient.density);
  return result;
}


template <int dim>
void ModellingPlan<dim>::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(&energy), sizeof(energy));
  stream.write(reinterpret_cast<const char *>(&centre), sizeof(centre));
  stream.write(reinterpret_cast<const char *>(&non_ideal_fraction),
               sizeof(non_ideal_fraction));
}


template <int dim>
void ModellingPlan<dim>::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(&energy), sizeof(energy));
  stream.read(reinterpret_cast<char *>(&centre), sizeof(centre));
  stream.read(reinterpret_cast<char *>(&non_ideal_fraction),
              sizeof(non_ideal_fraction));
}


template class ModellingPlan<1>;
template class ModellingPlan<2>;
template class ModellingPlan<3>;
} // namespace contrecoup::gas
