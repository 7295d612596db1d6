// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene_parameters.h>
#include <contrecoup/geometry/shape.h>

#include <array>

namespace contrecoup::coupling
{
/**
 * Where things of a scene are, and how large its domain must be: what a person
 * who prepares a blast with a body would work out on paper.
 */
struct SceneLayout
{
  /// Edge of coarse leaves [m]; at the skin these are halved, see
  /// SceneParameters::Accuracy, and hold four cells along each edge.
  static constexpr double leaf = 0.64;
  static constexpr unsigned int subcells = 4;

  /**
   * Finds the charge's place, the plane of symmetry, and a domain so large
   * that what the open sides send back, as if they were mirrors, reaches the
   * body only after the end time: the front of the blast that
   * ExpectedBlast has in free air of 101325 Pa and 1.225 kg/m^3.
   * @param surface of the body
   * @throws InputError for a charge in the body or below ground, a body below
   *   ground, and a symmetry that is asked for and is not there
   */
  SceneLayout(const SceneParameters &scene, const Shape &surface);

  dealii::BoundingBox<3> body;
  dealii::Point<3> charge; ///< its centre [m]
  double distance;         ///< from there to the body [m]
  double asymmetry;        ///< of the body's surface [m]
  /// What half of the gas allows of it: a hundredth of the body's width, less
  /// than persons differ from side to side [m].
  double symmetry_limit;
  bool is_half;        ///< whether y > 0 alone is computed
  double arrival;      ///< of the front at the body, expected [s]
  double last_arrival; ///< of the ground's reflection at all of the body [s]
  double overpressure; ///< behind that front [Pa]
  double reach;        ///< of the front at the end time [m]
  dealii::Point<3> lower, upper; ///< corners of the domain [m]
  std::array<unsigned int, 3> n_leaves;

  /// Distance from the charge to the body or an open side, whichever is
  /// nearer [m].
  double free_way() const;

  /// Edge of the cells at the skin [m].
  double cell_size(const SceneParameters &scene) const;

private:
  void place_charge(const SceneParameters &scene, const Shape &surface);
  void find_symmetry(const SceneParameters &scene, const Shape &surface);
  void size_domain(double end_time);
};
} // namespace contrecoup::coupling
