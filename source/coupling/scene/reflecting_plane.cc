// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/model_bias.h>
#include <contrecoup/coupling/scene/reflecting_plane.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::coupling
{
using dealii::Point;

namespace
{
  /// Speed of a shock by its overpressure in parts of the ambient pressure
  /// (Rankine-Hugoniot) [m/s].
  double front_speed(const double over)
  {
    return SceneLayout::sound_speed * std::sqrt(1. + 6. / 7. * over);
  }

  /// Speed of a shock of the same overpressure in the flow behind that one
  /// [m/s].
  double following_speed(const double over)
  {
    const double squared = 1. + 6. / 7. * over;
    const double compression = 6. * squared / (squared + 5.);
    return front_speed(over) * (1. - 1. / compression) +
           std::sqrt((1. + over) / compression) *
             front_speed(over / (1. + over));
  }

  /// Earliest arrival of a reflection at the distance @p way from the charge's
  /// image; the plane is at the distance @p plane on this way [m].
  double earliest_arrival(const IncidentWave &wave,
                          const double plane,
                          const double way)
  {
    constexpr unsigned int n_steps = 200;
    const double step = (way - plane) / n_steps;
    double time = wave.value(BlastQuantity::arrival, plane);
    for (unsigned int i = 0; i < n_steps; ++i)
      time += step / following_speed(wave.value(BlastQuantity::overpressure,
                                                plane + (i + 0.5) * step) /
                                     SceneLayout::air_pressure);
    return time;
  }
} // namespace


Point<3> ReflectingPlane::image(const Point<3> &charge) const
{
  Point<3> mirrored = charge;
  mirrored[direction] = 2. * place - charge[direction];
  return mirrored;
}


double ReflectingPlane::distance(const Point<3> &point) const
{
  return std::abs(point[direction] - place);
}


std::vector<ReflectingPlane>
reflecting_planes(const SceneLayout &layout,
                  const std::vector<ChosenSide> &sides)
{
  std::vector<ReflectingPlane> planes;
  if (layout.has_ground() && !layout.is_surface_burst)
    planes.push_back({"ground", "", 2, 0.});
  for (const ChosenSide &side : sides)
    if ((side.kind == "wall" || side.kind == "symmetry") &&
        side.name != "z low")
      planes.push_back(
        {(side.kind == "wall" ? "" : "plane of ") + side.in_words(layout),
         side.entry(),
         side.direction,
         side.place(layout)});
  return planes;
}


std::vector<ReflectingPlane> open_planes(const SceneLayout &layout,
                                         const std::vector<ChosenSide> &sides)
{
  std::vector<ReflectingPlane> planes;
  for (unsigned int side = 0; side < 6; ++side)
  {
    const unsigned int d = side / 2;
    const bool is_high = side % 2 == 1;
    const std::string name =
      std::string(1, "xyz"[d]) + (is_high ? " high" : " low");
    const bool is_chosen =
      std::any_of(sides.begin(), sides.end(), [&](const ChosenSide &one) {
        return one.name == name && one.kind != "open";
      });
    const bool is_closed = (name == "z low" && layout.has_ground()) ||
                           (name == "y low" && layout.is_half);
    if (!is_chosen && !is_closed)
      planes.push_back(
        {name, "", d, (is_high ? layout.upper : layout.lower)[d]});
  }
  return planes;
}


Reflection reflection_at(const SceneParameters &scene,
                         const SceneLayout &layout,
                         const ReflectingPlane &plane,
                         const Point<3> &place)
{
  // Error of the tables' arrivals.
  constexpr double accuracy = 0.05;
  const IncidentWave wave = layout.incident_wave(scene);
  const double direct = place.distance(layout.charge);
  const double mirrored = place.distance(plane.image(layout.charge));
  const double before = plane.distance(layout.charge);
  const double to_plane =
    std::clamp(mirrored * before / (before + plane.distance(place)),
               std::min(layout.charge_radius, mirrored),
               mirrored);
  const double arrival = wave.value(BlastQuantity::arrival, direct);
  const double delay = earliest_arrival(wave, to_plane, mirrored) - arrival;
  return {plane.name,
          std::max(delay, 0.),
          (mirrored - direct) / SceneLayout::sound_speed,
          delay <= accuracy * arrival};
}


std::vector<Reflection> reflections_at(const SceneParameters &scene,
                                       const SceneLayout &layout,
                                       const std::vector<ChosenSide> &sides,
                                       const dealii::Point<3> &place)
{
  std::vector<Reflection> all;
  for (const ReflectingPlane &plane : reflecting_planes(layout, sides))
    all.push_back(reflection_at(scene, layout, plane, place));
  return all;
}


std::vector<std::string> grazed_sides(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const std::vector<ChosenSide> &sides)
{
  std::vector<std::string> names;
  const Point<3> place = layout.probe.value_or(layout.nearest_skin);
  for (const ReflectingPlane &plane : open_planes(layout, sides))
    if (reflection_at(scene, layout, plane, place).merges)
      names.push_back(plane.name);
  return names;
}


double open_reflection_at_body(const SceneParameters &scene,
                               const SceneLayout &layout,
                               const std::vector<ChosenSide> &sides)
{
  double way = std::numeric_limits<double>::infinity();
  for (const ReflectingPlane &plane : open_planes(layout, sides))
  {
    const Point<3> image = plane.image(layout.charge);
    way = std::min(way, image.distance(nearest_place(layout.body, image)));
    if (layout.probe)
      way = std::min(way, image.distance(*layout.probe));
  }
  return std::isfinite(way) ? layout.point_source(scene).arrival(way) : way;
}


double merged_rise(const SceneParameters &scene,
                   const SceneLayout &layout,
                   const BlastQuantity quantity)
{
  const auto value = [&](const bool is_merged) {
    return IncidentWave(
             scene.explosive.tnt, scene.mass, scene.energy(), is_merged)
      .value(quantity, layout.distance);
  };
  const double rise = value(true) / value(false) - 1.;
  return std::isfinite(rise) ? rise : unknown;
}


bool sees_reflection(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const ReflectingPlane &plane)
{
  const Point<3> image = plane.image(layout.charge);
  const Point<3> nearest = nearest_place(layout.body, image);
  return !(layout.incident_wave(scene).value(
             BlastQuantity::arrival, image.distance(nearest)) > scene.end_time);
}
} // namespace contrecoup::coupling
