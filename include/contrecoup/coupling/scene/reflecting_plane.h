// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/chosen_side.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Rigid plane that reflects the blast as if the charge had an image behind
/// it: the ground, or a side of the domain that the user made a wall.
struct ReflectingPlane
{
  std::string name;  ///< "ground", "wall at x = 3.2 m"
  std::string entry; ///< that the user made it with; empty: none
  unsigned int direction;
  double place; ///< coordinate of the plane [m]

  dealii::Point<3> image(const dealii::Point<3> &charge) const;
  /// Distance of a point from the plane [m].
  double distance(const dealii::Point<3> &point) const;
};

/// The planes of a scene. The ground of a surface burst is none: the incident
/// wave has what it reflects.
/// @param sides that the user chose
std::vector<ReflectingPlane>
reflecting_planes(const SceneLayout &layout,
                  const std::vector<ChosenSide> &sides);

/// The open sides of the domain, which send back some of the wave, and all of
/// it at grazing angles; the names are "x low" and the like.
std::vector<ReflectingPlane> open_planes(const SceneLayout &layout,
                                         const std::vector<ChosenSide> &sides);

/// When the reflection by a plane follows the incident wave at a place.
struct Reflection
{
  std::string plane; ///< its name
  /// As fast as the reflection can be: to the plane as the front, and from
  /// there in the flow behind the front, as a wave of the same strength [s]
  double least_delay;
  double largest_delay; ///< at the speed of sound [s]
  /// Whether it may be one with the incident wave, since it can be as early as
  /// that, within what the tables know of arrivals.
  bool merges;
};

Reflection reflection_at(const SceneParameters &scene,
                         const SceneLayout &layout,
                         const ReflectingPlane &plane,
                         const dealii::Point<3> &place);

/// Those by all planes.
/// @param sides that the user chose
std::vector<Reflection> reflections_at(const SceneParameters &scene,
                                       const SceneLayout &layout,
                                       const std::vector<ChosenSide> &sides,
                                       const dealii::Point<3> &place);

/// Open side that the front runs along before it reaches the probe beside the
/// body, or the nearest skin: what comes from there may be one with the wave.
/// Empty: none.
std::string grazed_side(const SceneParameters &scene,
                        const SceneLayout &layout,
                        const std::vector<ChosenSide> &sides);

/// When the front can come from the charge's image behind an open side to the
/// body, or to the probe beside it [s]; infinite without open sides.
double open_reflection_at_body(const SceneParameters &scene,
                               const SceneLayout &layout,
                               const std::vector<ChosenSide> &sides);

/// What a plane adds to a quantity of the incident wave at the body's distance
/// where its reflection has merged with that: what the ground adds to a surface
/// burst [-]; NaN: unknown.
double merged_rise(const SceneParameters &scene,
                   const SceneLayout &layout,
                   BlastQuantity quantity);

/// Whether the reflection by a plane comes to the body before the end time: by
/// the front on the way from the charge's image.
bool sees_reflection(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const ReflectingPlane &plane);
} // namespace contrecoup::coupling
