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
  std::string name; ///< "ground", "wall at x = 3.2 m"
  /// Entry with which the user made the plane; empty for the ground.
  std::string entry;
  unsigned int direction; ///< of its normal: 0, 1, 2 for x, y, z
  double place;           ///< coordinate of the plane [m]

  dealii::Point<3> image(const dealii::Point<3> &charge) const;
  /// Distance of a point from the plane [m].
  double distance(const dealii::Point<3> &point) const;
};

/// The reflecting planes of a scene, without the ground of a surface burst,
/// whose reflection the tables of the incident wave contain.
/// @param sides sides of the domain that the user chose
std::vector<ReflectingPlane>
reflecting_planes(const SceneLayout &layout,
                  const std::vector<ChosenSide> &sides);

/// The open sides of the domain, with names such as "x low". They send back
/// some of the wave, at grazing angles all of it.
std::vector<ReflectingPlane> open_planes(const SceneLayout &layout,
                                         const std::vector<ChosenSide> &sides);

/// Delay between the incident wave at a place and its reflection by a plane.
struct Reflection
{
  std::string plane; ///< name of the plane
  /// Least delay [s]: the wave goes to the plane as the front, and from there
  /// through the flow behind the front as a shock of the same strength.
  double least_delay;
  /// Largest delay [s]: the detour at the speed of sound.
  double largest_delay;
  /// Whether the reflection may have merged with the incident wave: its least
  /// delay is within the error of the tables' arrivals.
  bool merges;
};

/// The reflection by one plane at a place.
Reflection reflection_at(const SceneParameters &scene,
                         const SceneLayout &layout,
                         const ReflectingPlane &plane,
                         const dealii::Point<3> &place);

/// The reflections by all reflecting planes at a place.
/// @param sides sides of the domain that the user chose
std::vector<Reflection> reflections_at(const SceneParameters &scene,
                                       const SceneLayout &layout,
                                       const std::vector<ChosenSide> &sides,
                                       const dealii::Point<3> &place);

/// Names of the open sides along which the front runs before it reaches the
/// probe next to the body, or the nearest skin. Such sides disturb the wave
/// from its arrival on.
std::vector<std::string> grazed_sides(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const std::vector<ChosenSide> &sides);

/// Earliest arrival of the front from the charge's image behind an open side at
/// the body or the probe next to it [s]; infinite without open sides.
double open_reflection_at_body(const SceneParameters &scene,
                               const SceneLayout &layout,
                               const std::vector<ChosenSide> &sides);

/// Relative rise of a quantity of the incident wave at the body's distance by a
/// reflection that has merged with that wave, taken as the rise by the ground
/// of a surface burst [-]; NaN where the tables do not reach.
double merged_rise(const SceneParameters &scene,
                   const SceneLayout &layout,
                   BlastQuantity quantity);

/// Whether the front from the charge's image behind a plane comes to the body
/// before the end time.
bool sees_reflection(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const ReflectingPlane &plane);
} // namespace contrecoup::coupling
