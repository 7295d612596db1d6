// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/scene_layout.h>
#include <contrecoup/geometry/shape/composed_shapes.h>
#include <contrecoup/numerics/injury/wave_reflection.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace contrecoup::coupling
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// First intersection of the ray along -x from @p begin with the surface, by
  /// sphere tracing; nothing if the ray leaves the box.
  std::optional<Point<3>> hit(const Shape &surface, const Point<3> &begin)
  {
    const auto box = surface.bounding_box();
    const double near_enough = 1e-7;
    Point<3> place = begin;
    while (place[0] > box.lower_bound(0))
    {
      const double free = surface.value(place);
      if (free < near_enough)
        return place;
      place[0] -= free;
    }
    return {};
  }


  /// A length to four digits, rounded up.
  std::string at_least(const double length)
  {
    const double digit = std::pow(10., std::floor(std::log10(length)) - 3.);
    return brief(std::ceil(length / digit) * digit);
  }


  /// Volume of the unit ball.
  constexpr double ball = 4. / 3. * boost::math::double_constants::pi;

} // namespace


SceneLayout::SceneLayout(const SceneParameters &scene,
                         const Shape &surface,
                         const std::optional<dealii::BoundingBox<3>> &unturned,
                         const OwnGrid &own)
  : body(own_box(surface))
  , unturned(unturned.value_or(body))
  , own_(own)
{
  if (body.lower_bound(2) < -1e-6)
    throw InputError("Body: it reaches " + brief(-body.lower_bound(2)) +
                     " m below the ground z = 0; Body/Shift lifts it");
  charge_radius =
    std::cbrt(scene.mass / (ball * scene.explosive.jwl.reference_density));
  place_charge(scene, surface);
  choose_levels(scene);
  check_charge(scene);
  find_symmetry(scene, surface);
  constexpr double far = 1e6; // [m]
  place_probe(
    {{Point<3>(-far, is_half ? 0. : -far, 0.), Point<3>(far, far, far)}});
  const ExpectedBlast blast = point_source(scene);
  expect_front(scene, blast);
  const Point<3> image(charge[0], charge[1], -charge[2]);
  last_arrival = blast.arrival(farthest_distance(body, image));
  const IncidentWave wave = incident_wave(scene);
  for (const GaugeRaster &gauge : gauges(scene))
  {
    const double way = farthest_distance(gauge.box(), charge);
    last_arrival = std::max(last_arrival,
                            wave.value(BlastQuantity::arrival, way) +
                              wave.nearest_duration(way));
  }
  // The ground sends the charge's energy into one half of the air.
  const ExpectedBlast outward(2. * scene.energy(), air_pressure, air_density);
  front_distance = outward.radius(scene.end_time);
  if (arrival >= scene.end_time)
    throw InputError("Scene/End time = " + brief(scene.end_time) +
                     " s: the blast reaches the body at " + brief(arrival) +
                     " s only");
  size_domain(scene, outward);
  if (own_.has_domain())
  {
    take_domain(scene);
    place_probe(dealii::BoundingBox<3>({lower, upper}));
  }
}


void SceneLayout::place_charge(const SceneParameters &scene,
                               const Shape &surface)
{
  if (scene.place)
    charge = *scene.place;
  else
  {
    const double outside = body.upper_bound(0) + scene.distance;
    const auto front = hit(surface, {outside, 0., scene.height});
    if (front)
      charge = {(*front)[0] + scene.distance, 0., scene.height};
    else
    {
      // Nearest position outside the body at this distance, by bisection.
      double low = 0.5 * (body.lower_bound(0) + body.upper_bound(0));
      double high = outside;
      const auto distance_at = [&](const double x) {
        const Point<3> place(x, 0., scene.height);
        return surface.value(place) < 0.
                 ? 0.
                 : place.distance(surface.nearest(place));
      };
      const double least = distance_at(low);
      if (least > scene.distance)
        throw InputError(
          "Charge/Distance = " + brief(scene.distance) +
          " m: at Charge/Height = " + brief(scene.height) +
          " m a charge is at least " + at_least(least) +
          " m from the body; give that Distance, a Height from " +
          brief(body.lower_bound(2)) + " to " + brief(body.upper_bound(2)) +
          " m, or Charge/Place");
      for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        (distance_at(middle) < scene.distance ? low : high) = middle;
      }
      charge = {high, 0., scene.height};
    }
  }
  const auto skin = hit(surface, charge);
  distance_along_x =
    skin ? charge[0] - (*skin)[0] : std::numeric_limits<double>::quiet_NaN();
  nearest_skin = surface.nearest(charge);
  distance = surface.value(charge) < 0. ? 0. : charge.distance(nearest_skin);
  // The nearest place in its surroundings need not be the nearest of all.
  if (!scene.place)
    distance = std::min(distance, scene.distance);
  if (distance <= 0.)
    throw InputError("Charge: its centre " + coordinates(charge) +
                     " m is in the body");
  is_surface_burst =
    own_.has_ground &&
    IncidentWave::is_surface_burst(
      scene.explosive.tnt.pressure * scene.mass, charge[2], distance);
}


IncidentWave SceneLayout::incident_wave(const SceneParameters &scene) const
{
  return {scene.explosive.tnt, scene.mass, scene.energy(), is_surface_burst};
}


ExpectedBlast SceneLayout::point_source(const SceneParameters &scene) const
{
  return {(is_surface_burst ? IncidentWave::surface_mass : 1.) * scene.energy(),
          air_pressure,
          air_density};
}


double SceneLayout::earliest_return(const SceneParameters &scene,
                                    const Point<3> &image,
                                    const Point<3> &place) const
{
  const double way = image.distance(place);
  // From above, the way begins at the ground.
  const double behind = image[2] == charge[2]
                          ? place[2]
                          : std::abs(image[2] - place[2]) + charge[2];
  const bool merges =
    is_surface_burst ||
    (has_ground() &&
     reflection_delay(incident_wave(scene), {way, charge[2], behind}).merges);
  return earliest_front((merges ? energy_with_image : 1.) * scene.energy(),
                        air_pressure,
                        air_density,
                        way);
}


double SceneLayout::expected_phase(const SceneParameters &scene,
                                   const double way) const
{
  const double bias = model_bias(scene.burst(is_surface_burst), way).duration;
  return incident_wave(scene).nearest_duration(way) *
         (std::isfinite(bias) ? 1. + bias : 1.);
}


void SceneLayout::choose_levels(const SceneParameters &scene)
{
  positive_phase = expected_phase(scene, distance);
  levels = scene.accuracy.levels;
  // Leaves of the user may be larger than those of the presets.
  const double largest = leaf / subcells / std::pow(2., levels);
  while (cell_size() > largest * (1. + 1e-9))
    ++levels;
  const unsigned int most = levels + max_extra_levels;
  const auto is_coarse = [&]() {
    return scene.cell_size > 0.
             ? cell_size() > scene.cell_size * (1. + 1e-9)
             : levels < most &&
                 (cells_per_phase() < scene.accuracy.cells_per_phase ||
                  cells_across() < least_cells_across);
  };
  if (scene.cell_size > 0.)
    levels = 0;
  while (is_coarse())
    ++levels;
  if (cells_across() < 1.)
    throw InputError(
      "Body: its shortest side, " + brief(1e3 * shortest_side()) +
      " mm, is less than a cell of the gas, " + brief(1e3 * cell_size()) +
      " mm; check the unit of its file, or choose a smaller "
      "Scene/Cell size");
  // Fronts before the body keep the difference of the preset's levels.
  const unsigned int difference =
    scene.accuracy.levels - scene.accuracy.front_levels;
  front_levels = levels > difference ? levels - difference : 0;
}


void SceneLayout::expect_front(const SceneParameters &scene,
                               const ExpectedBlast &blast)
{
  earliest_arrival = blast.arrival(distance);
  const IncidentWave wave = incident_wave(scene);
  arrival = wave.value(BlastQuantity::arrival, distance);
  overpressure = wave.value(BlastQuantity::overpressure, distance);
}


void SceneLayout::check_charge(const SceneParameters &scene) const
{
  const std::string charge_of =
    "the charge of " + brief(scene.mass) + " kg of " + scene.explosive.title +
    " has a radius of " + brief(charge_radius) + " m";
  const auto largest_mass = [&](const double radius) {
    return brief(scene.mass * std::pow(radius / charge_radius, 3), 3) + " kg";
  };
  const std::string height = scene.place ? "Charge/Place" : "Charge/Height";
  if (charge[2] < charge_radius * (1. - 1e-9))
    throw InputError(height + ": " + brief(charge[2]) +
                     " m above the ground, " + charge_of +
                     " and would be cut by it; at least that height, or a "
                     "Mass of at most " +
                     largest_mass(charge[2]) + ", is needed");
  // Smallest number of skin subcells between charge and body.
  constexpr double least_cells = 2.;
  // Subcells of the first stage that the front needs while the charge burns.
  constexpr double least_radial_cells = 10.;
  const double cell = cell_size();
  const double gap =
    std::max(least_cells * cell, least_radial_cells * radial_cell);
  if (distance < charge_radius + gap)
    throw InputError(
      std::string(scene.place ? "Charge/Place" : "Charge/Distance") + ": " +
      brief(distance) + " m from the body, " + charge_of + "; with cells of " +
      brief(1e3 * cell) + " mm at the skin its surface must be " + brief(gap) +
      " m away, its centre at least " + brief(charge_radius + gap) + " m; a " +
      (scene.cell_size > 0. ? "smaller Scene/Cell size"
                            : "finer Scene/Accuracy") +
      " allows less");
}


void SceneLayout::find_symmetry(const SceneParameters &scene,
                                const Shape &surface)
{
  const unsigned int n_samples = 2000;
  const double near_surface = 0.1 * body.side_length(1);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0., 1.);
  asymmetry = std::abs(charge[1]);
  for (unsigned int i = 0; i < n_samples; ++i)
  {
    Point<3> place;
    for (unsigned int d = 0; d < 3; ++d)
      place[d] = body.lower_bound(d) + part(random) * body.side_length(d);
    if (std::abs(surface.value(place)) > near_surface)
      continue;
    Point<3> image = surface.project(place);
    image[1] *= -1.;
    asymmetry = std::max(asymmetry, std::abs(surface.distance(image)));
  }
  symmetry_limit = 0.01 * body.side_length(1);
  is_half = asymmetry < symmetry_limit &&
            (scene.symmetry == "y" ||
             (scene.symmetry == "auto" && !own_.has_unlike_sides &&
              !(own_.lower && (*own_.lower)[1] != 0.)));
  // A charge on the plane of symmetry is centred on it.
  if (is_half)
    charge[1] = 0.;
  if (scene.symmetry == "y" && !is_half)
    throw InputError("Scene/Symmetry = y: body or charge differ by " +
                     brief(asymmetry) + " m between both sides of y = 0");
  if (is_half && own_.has_unlike_sides)
    throw InputError("Scene/Symmetry = y: the sides y low and y high of "
                     "Blast/Boundaries differ; y low = symmetry mirrors y "
                     "high, Scene/Symmetry = none has both sides");
}


void SceneLayout::place_probe(const dealii::BoundingBox<3> &domain)
{
  constexpr double most = 0.35; // [m]
  const double least = std::min(4. * cell_size(), most);
  probe.reset();
  // In the middle between body and side, where that is nearer.
  const auto gap_for = [&](const double room) {
    return std::min(most, 0.5 * room);
  };
  const double below = gap_for(body.lower_bound(1) - domain.lower_bound(1));
  const double above = gap_for(domain.upper_bound(1) - body.upper_bound(1));
  const double gap = std::max(below, above);
  if (distance <= body.side_length(1) || gap < least)
    return;
  // On the charge's side of the body unless the other one has more room, no
  // farther from the charge than the body.
  const bool at_low =
    charge[1] < body.lower_bound(1) ? below == gap : above < gap;
  const double beside =
    at_low ? body.lower_bound(1) - gap : body.upper_bound(1) + gap;
  const double aside = std::clamp(beside - charge[1], -distance, distance);
  // Not below zero by round-off.
  const double room =
    std::sqrt(std::max(0., distance * distance - aside * aside));
  // A charge on the ground sends a jet along it, below most of the body.
  constexpr double steepest = 0.7; // of the way
  const double up =
    is_surface_burst
      ? std::max(0.,
                 std::min({body.center()[2] - charge[2],
                           steepest * room,
                           domain.upper_bound(2) - least - charge[2]}))
      : 0.;
  const double along = std::sqrt(std::max(0., room * room - up * up));
  const double toward = body.center()[0] < charge[0] ? -1. : 1.;
  const Point<3> place = charge + Point<3>(toward * along, aside, up);
  // The ground may be near: that of the user's scene is everywhere.
  const bool is_free = place[0] - domain.lower_bound(0) >= least &&
                       domain.upper_bound(0) - place[0] >= least &&
                       place[1] - domain.lower_bound(1) >= least &&
                       domain.upper_bound(1) - place[1] >= least &&
                       domain.upper_bound(2) - place[2] >= least;
  if (is_free)
    probe = place;
}


std::vector<GaugeRaster> SceneLayout::gauges(const SceneParameters &scene) const
{
  std::vector<GaugeRaster> all = scene.gauges;
  if (probe)
    all.push_back({*probe, *probe, "Probes/Points"});
  return all;
}


double SceneLayout::unobstructed_distance() const
{
  double way = distance;
  for (unsigned int d = 0; d < 3; ++d)
  {
    way = std::min(way, upper[d] - charge[d]);
    const bool is_open = d == 0 || (d == 1 && !is_half);
    if (is_open)
      way = std::min(way, charge[d] - lower[d]);
  }
  return way;
}


bool SceneLayout::is_far(const SceneParameters &scene) const
{
  return ball * std::pow(distance, 3) * air_density > scene.mass;
}


double SceneLayout::cell_size(const unsigned int level) const
{
  return leaf_edge / subcells / std::pow(2., level);
}


double SceneLayout::cell_size() const
{
  return cell_size(levels);
}


double SceneLayout::shortest_side() const
{
  return std::min({unturned.side_length(0),
                   unturned.side_length(1),
                   unturned.side_length(2)});
}


double SceneLayout::seen_area() const
{
  const Tensor<1, 3> way = charge - nearest_skin;
  double area = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    double face = std::abs(way[d]) / way.norm();
    for (unsigned int e = 0; e < 3; ++e)
      if (e != d)
        face *= std::min(body.side_length(e), 2. * distance);
    area += face;
  }
  return area;
}


double SceneLayout::cells_across() const
{
  return shortest_side() / cell_size();
}


double SceneLayout::cells_per_phase() const
{
  return sound_speed * positive_phase / cell_size();
}
} // namespace contrecoup::coupling
