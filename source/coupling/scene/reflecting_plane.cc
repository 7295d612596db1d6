// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/model_bias.h>
#include <contrecoup/coupling/scene/reflecting_plane.h>

#include <algorithm>
#include <cmath>

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
  Point<3> nearest;
  for (unsigned int d = 0; d < 3; ++d)
    nearest[d] = std::clamp(
      image[d], layout.body.lower_bound(d), layout.body.upper_bound(d));
  return !(layout.incident_wave(scene).value(
             BlastQuantity::arrival, image.distance(nearest)) > scene.end_time);
}
} // namespace contrecoup::coupling
