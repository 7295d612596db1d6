// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup
{
/// Position of the front of a liquid column that collapses on a dry floor.
struct DamBreakPoint
{
  double time;  ///< t sqrt(2 g / a), with gravity g and column width a [-]
  double front; ///< distance from the wall behind the column, over a [-]
};

/// Measurements for water columns twice as high as wide, a = 2.25 in (57.15
/// mm): J. C. Martin and W. J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952)
/// 312, table 2, n^2 = 2.
const std::vector<DamBreakPoint> &martin_and_moyce_front();

/// The same for a = 1.125 in, digitised from figure 3 there.
const std::vector<DamBreakPoint> &martin_and_moyce_small_front();

/// Measurements for water columns twice as high as wide, digitised from a
/// figure: S. Koshizuka and Y. Oka, Nucl. Sci. Eng. 123 (1996) 421.
const std::vector<DamBreakPoint> &koshizuka_and_oka_front();

/// Linear interpolation of the front at @p time; constant beyond the ends.
double dam_break_front(const std::vector<DamBreakPoint> &points,
                       const double time);
} // namespace contrecoup
