// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/injury/blast_injury.h>
#include <contrecoup/numerics/injury/chest_wall.h>

#include <algorithm>
#include <limits>

namespace contrecoup::gas
{
/**
 * What a person who stands at one position would be exposed to, updated once
 * per step from the arrival of the blast on: the largest load_in_flow(), and
 * the motion of the chest wall under the overpressure there. Replaces the
 * histories that measures of injury would need otherwise.
 */
struct ExposureRecord
{
  static constexpr unsigned int n_values = 6;

  double load = 0.; ///< largest so far [Pa]
  double last = 0.; ///< overpressure at the end of the last step [Pa]
  ChestWall chest;

  /// Adds overpressure and dynamic pressure [Pa] at the end of a step.
  void add_load(const double overpressure,
                const double dynamic,
                const double ambient)
  {
    load = std::max(load, load_in_flow(overpressure, dynamic, ambient));
  }

  /// Follows the chest through a step [s] that ends with @p overpressure [Pa].
  void
  add_chest(const double overpressure, const double step, const double ambient)
  {
    chest.advance(last, overpressure, step, ambient);
    last = overpressure;
  }

  /// Continues where a simple wave of @p peak overpressure [Pa] has been
  /// recorded without this: the load is standing_load(), and the motion of the
  /// chest stays unknown, not a number.
  void continue_after(const double peak, const double ambient)
  {
    load = standing_load(peak, ambient);
    chest.largest_velocity = std::numeric_limits<double>::quiet_NaN();
  }
};
} // namespace contrecoup::gas
