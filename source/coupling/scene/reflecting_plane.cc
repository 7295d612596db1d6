// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/reflecting_plane.h>
#include <contrecoup/numerics/injury/wave_reflection.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::coupling
{
using dealii::Point;

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
  const double direct = place.distance(layout.charge);
  const ReflectionWay way{
    direct, plane.distance(layout.charge), plane.distance(place)};
  const ReflectionDelay delay =
    reflection_delay(layout.incident_wave(scene), way);
  return {plane.name,
          delay.least,
          (way.mirrored() - direct) / SceneLayout::sound_speed,
          delay.merges};
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
  double earliest = std::numeric_limits<double>::infinity();
  for (const ReflectingPlane &plane : open_planes(layout, sides))
  {
    const Point<3> image = plane.image(layout.charge);
    std::vector<Point<3>> places{nearest_place(layout.body, image)};
    if (layout.probe)
      places.push_back(*layout.probe);
    for (const Point<3> &place : places)
      earliest =
        std::min(earliest, layout.earliest_return(scene, image, place));
  }
  return earliest;
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
