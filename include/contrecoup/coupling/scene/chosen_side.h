// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>
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
} // namespace contrecoup::coupling
