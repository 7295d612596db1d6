// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// The user's choices for the domain of a scene's gas, by entries of the
/// stage "Blast"; the scene determines the rest.
struct OwnGrid
{
  std::optional<dealii::Point<3>> lower, upper;        ///< corners [m]
  std::optional<std::array<unsigned int, 3>> n_leaves; ///< coarse ones
  /// Whether the side y low is the user's own, or y high is and is not
  /// mirrored by y low = symmetry: half of the gas is then not the scene.
  bool has_unlike_sides = false;
  bool has_ground = true; ///< whether the side z low is a wall

  /// @param wrote all assignments of the user, the last of each entry counts;
  /// values that are no numbers are left to the stage, which refuses them
  static OwnGrid find(const std::vector<Assignment> &wrote);

  bool has_domain() const
  {
    return lower || upper || n_leaves;
  }
};

/// A point of a text "x, y, z" [m]; nothing if it is none.
std::optional<dealii::Point<3>> point_of(const std::string &text);
} // namespace contrecoup::coupling
