// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <vector>

namespace contrecoup
{
/// The front of a column of liquid that collapses along a dry floor.
struct DamBreakPoint
{
  double time;  ///< t sqrt(2 g / a), g gravity, a the column's width [-]
  double front; ///< from the wall behind the column, over a [-]
};

/// Measured on columns of water twice as high as wide, a = 2.25 in (57.15 mm):
/// J. C. Martin and W. J. Moyce, Phil. Trans. R. Soc. Lond. A 244 (1952) 312,
/// table 2, n^2 = 2.
const std::vector<DamBreakPoint> &martin_and_moyce_front();

/// The same with a = 1.125 in, read off figure 3 there.
const std::vector<DamBreakPoint> &martin_and_moyce_small_front();

/// Measured on columns of water twice as high as wide, read off a figure: S.
/// Koshizuka and Y. Oka, Nucl. Sci. Eng. 123 (1996) 421.
const std::vector<DamBreakPoint> &koshizuka_and_oka_front();

/// The front at @p time, along straight lines between the points; the first or
/// last one beyond them.
double dam_break_front(const std::vector<DamBreakPoint> &points,
                       const double time);
} // namespace contrecoup
