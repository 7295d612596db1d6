// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene_parameters.h>
#include <contrecoup/geometry/shape.h>
#include <contrecoup/numerics/expected_blast.h>

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
  /// Edge of the cells that the blast begins with, in 1-D [m].
  static constexpr double radial_cell = 0.001;
  /// Coarse leaves of the largest domain: hundreds of gigabytes of gas.
  static constexpr double most_leaves = 1e7;

  /**
   * Finds the charge's place, the plane of symmetry, and a domain so large
   * that what the open sides send back, as if they were mirrors, reaches the
   * body only after the end time: the front of the blast that
   * ExpectedBlast has in free air of 101325 Pa and 1.225 kg/m^3.
   * @param surface of the body
   * @throws InputError for a charge that overlaps the body or the ground or is
   *   nearer to the skin than cells resolve, a body below ground, a symmetry
   *   that is asked for and is not there, and times and distances that need
   *   more leaves than most_leaves
   */
  SceneLayout(const SceneParameters &scene, const Shape &surface);

  dealii::BoundingBox<3> body;
  dealii::Point<3> charge; ///< its centre [m]
  double charge_radius;    ///< [m]
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

  /// Whether the front has swept more than the charge's mass of air when it
  /// reaches the body, so that what is expected there is worth a word.
  bool is_far(const SceneParameters &scene) const;

  /// Edge of the cells at the skin [m].
  double cell_size(const SceneParameters &scene) const;

private:
  void place_charge(const SceneParameters &scene, const Shape &surface);
  void check_charge(const SceneParameters &scene) const;
  void find_symmetry(const SceneParameters &scene, const Shape &surface);
  /// Leaves of the domain along each direction below and above 0 that a front
  /// needs which gets so far [m].
  std::array<std::array<double, 2>, 3> leaves_for(double reach) const;
  void size_domain(const SceneParameters &scene, const ExpectedBlast &blast);
};
} // namespace contrecoup::coupling
