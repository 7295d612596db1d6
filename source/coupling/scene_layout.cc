// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/text.h>
#include <contrecoup/coupling/scene_layout.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/expected_blast.h>

#include <cmath>
#include <random>

namespace contrecoup::coupling
{
using dealii::Point;

namespace
{
  constexpr double air_pressure = 101325.; // [Pa]
  constexpr double air_density = 1.225;    // [kg/m^3]
  constexpr double most_leaves = 1e8;

  /// Where a ray along -x from @p begin first meets the surface, by steps of
  /// the distance to it; no point when it leaves the box.
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


  /// From @p place to the corner of the box that is farthest from it.
  double farthest_distance(const dealii::BoundingBox<3> &box,
                           const Point<3> &place)
  {
    double squares = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      squares += std::pow(std::max(std::abs(box.lower_bound(d) - place[d]),
                                   std::abs(box.upper_bound(d) - place[d])),
                          2);
    return std::sqrt(squares);
  }


  double energy_of(const SceneParameters &scene)
  {
    const JwlParameters &jwl = find_explosive(scene.explosive).jwl;
    return scene.mass *
           (jwl.energy_density / jwl.reference_density + scene.afterburn);
  }


  std::string text_of(const Point<3> &point)
  {
    return brief(point[0]) + ", " + brief(point[1]) + ", " + brief(point[2]);
  }
} // namespace


SceneLayout::SceneLayout(const SceneParameters &scene, const Shape &surface)
  : body(surface.bounding_box())
{
  if (body.lower_bound(2) < -1e-6)
    throw InputError("Body: it reaches " + brief(-body.lower_bound(2)) +
                     " m below the ground z = 0; Body/Shift lifts it");
  place_charge(scene, surface);
  find_symmetry(scene, surface);
  const ExpectedBlast blast(energy_of(scene), air_pressure, air_density);
  arrival = blast.arrival(distance);
  const Point<3> image(charge[0], charge[1], -charge[2]);
  last_arrival = blast.arrival(farthest_distance(body, image));
  overpressure = blast.overpressure(distance);
  reach = blast.radius(scene.end_time);
  if (arrival >= scene.end_time)
    throw InputError("Scene/End time = " + brief(scene.end_time) +
                     " s: the blast reaches the body at " + brief(arrival) +
                     " s only");
  size_domain(scene.end_time);
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
      // The nearest place: from inside of the box outwards, by bisection.
      double low = 0.5 * (body.lower_bound(0) + body.upper_bound(0));
      double high = outside;
      if (surface.value({low, 0., scene.height}) > scene.distance)
        throw InputError("Charge/Distance = " + brief(scene.distance) +
                         " m: at the height of " + brief(scene.height) +
                         " m the body is farther away than that; Charge/Place "
                         "gives the place itself");
      for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle = 0.5 * (low + high);
        (surface.value({middle, 0., scene.height}) < scene.distance ? low
                                                                    : high) =
          middle;
      }
      charge = {high, 0., scene.height};
    }
  }
  distance = surface.distance(charge);
  if (distance <= 0.)
    throw InputError("Charge: its centre " + text_of(charge) +
                     " m is in the body");
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
  is_half = scene.symmetry != "none" && asymmetry < symmetry_limit;
  if (scene.symmetry == "y" && !is_half)
    throw InputError("Scene/Symmetry = y: body or charge differ by " +
                     brief(asymmetry) + " m between both sides of y = 0");
}


void SceneLayout::size_domain(const double end_time)
{
  // Where an open side must be, at least, along direction d: the charge's
  // mirror image in it is farther from the body than the front gets, and it
  // leaves a leaf's room to body and charge.
  const auto side = [&](const unsigned int d, const double sign) {
    const double farthest =
      sign > 0. ? body.upper_bound(d) : -body.lower_bound(d);
    const double place = sign * charge[d];
    double across = 0.;
    for (unsigned int e = 0; e < 3; ++e)
      if (e != d)
        across += std::pow(std::max({0.,
                                     body.lower_bound(e) - charge[e],
                                     charge[e] - body.upper_bound(e)}),
                           2);
    const double along = std::sqrt(std::max(0., reach * reach - across));
    return std::max(0.5 * (along + farthest + place),
                    std::max(farthest, place) + leaf);
  };
  double n_all = 1.;
  for (unsigned int d = 0; d < 3; ++d)
    n_all *= (side(d, 1.) + side(d, -1.)) / leaf;
  if (n_all > most_leaves)
    throw InputError(
      "Scene/End time = " + brief(end_time) + " s: the blast reaches " +
      brief(reach) + " m until then; its domain of " +
      brief(side(0, 1.) + side(0, -1.)) + " x " +
      brief(side(1, 1.) + side(1, -1.)) + " x " + brief(side(2, 1.)) +
      " m is too large to be computed in cells of the body's size");
  for (unsigned int d = 0; d < 3; ++d)
  {
    const int n_upper = static_cast<int>(std::ceil(side(d, 1.) / leaf));
    int n_lower = static_cast<int>(std::ceil(side(d, -1.) / leaf));
    if (d == 2 || (d == 1 && is_half))
      n_lower = 0;
    lower[d] = -n_lower * leaf;
    upper[d] = n_upper * leaf;
    n_leaves[d] = static_cast<unsigned int>(n_upper + n_lower);
  }
}


double SceneLayout::free_way() const
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


double SceneLayout::cell_size(const SceneParameters &scene) const
{
  return leaf / subcells / std::pow(2., scene.accuracy.levels);
}
} // namespace contrecoup::coupling
