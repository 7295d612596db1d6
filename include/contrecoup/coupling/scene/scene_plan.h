// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/coupling/scene/scene_layout.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Side of the domain that the user chose to be another than the scene's: the
/// ground a wall, a plane of symmetry, all others open.
struct ChosenSide
{
  std::string name; ///< "x low"
  std::string kind; ///< "wall"
  unsigned int direction;
  bool is_high;

  /// Entry of the scene that chooses it.
  std::string entry() const
  {
    return "Blast/Boundaries/" + name;
  }
  /// Coordinate of the side [m].
  double place(const SceneLayout &layout) const
  {
    return (is_high ? layout.upper : layout.lower)[direction];
  }
  /// "wall at x = -3.84 m"
  std::string in_words(const SceneLayout &layout) const;
};

/// Sides that the user chose. Without corners of the user, domains keep the
/// size that they have with open sides; tables know nothing of these sides.
/// @param wrote all assignments of the user
std::vector<ChosenSide> find_chosen_sides(const std::vector<Assignment> &wrote,
                                          const SceneLayout &layout);

/// Assumptions of a scene in addition to those of its blast, with estimates
/// from the layout alone: symmetry, sides of the domain that the user chose, a
/// body at rest for the gas, small strain, no gravity, a lung that the load
/// does not crush, and a sufficient end time.
/// @param wrote all assignments of the user
/// @param body_mass [kg]
std::vector<Assumption> scene_plan(const SceneParameters &scene,
                                   const SceneLayout &layout,
                                   const std::vector<Assignment> &wrote,
                                   double body_mass,
                                   bool has_lung);

/// Measured values of these assumptions and of those of the tasks; empty for
/// tasks without results; sides are where the plan has them.
/// @param plan scene_plan() of the scene
/// @param folder of the scene
std::vector<Assumption> scene_audit(const SceneParameters &scene,
                                    const SceneLayout &layout,
                                    const std::vector<Assumption> &plan,
                                    const std::string &folder);

/// Plan of a task from its summary; empty without a summary.
std::vector<Assumption> task_plan(const std::string &folder);
} // namespace contrecoup::coupling
