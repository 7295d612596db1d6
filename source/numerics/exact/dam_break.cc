// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/exact/dam_break.h>

namespace contrecoup
{
const std::vector<DamBreakPoint> &martin_and_moyce_front()
{
  static const std::vector<DamBreakPoint> points{{0., 1.},
                                                 {0.41, 1.11},
                                                 {0.84, 1.22},
                                                 {1.19, 1.44},
                                                 {1.43, 1.67},
                                                 {1.63, 1.89},
                                                 {1.83, 2.11},
                                                 {1.98, 2.33},
                                                 {2.20, 2.56},
                                                 {2.32, 2.78},
                                                 {2.51, 3.00},
                                                 {2.65, 3.22},
                                                 {2.83, 3.44},
                                                 {2.98, 3.67},
                                                 {3.11, 3.89},
                                                 {3.33, 4.11}};
  return points;
}


const std::vector<DamBreakPoint> &martin_and_moyce_small_front()
{
  static const std::vector<DamBreakPoint> points{{0.849, 1.245},
                                                 {1.212, 1.443},
                                                 {1.602, 1.884},
                                                 {2.283, 2.689},
                                                 {2.950, 3.728},
                                                 {3.598, 4.528},
                                                 {3.905, 4.999},
                                                 {4.592, 5.841},
                                                 {4.961, 6.271},
                                                 {5.316, 6.717}};
  return points;
}


const std::vector<DamBreakPoint> &koshizuka_and_oka_front()
{
  static const std::vector<DamBreakPoint> points{{0., 1.},
                                                 {0.381, 1.111},
                                                 {0.769, 1.252},
                                                 {1.153, 1.505},
                                                 {1.537, 1.892},
                                                 {1.935, 2.241},
                                                 {2.323, 2.615},
                                                 {2.719, 3.003},
                                                 {3.096, 3.624}};
  return points;
}


double dam_break_front(const std::vector<DamBreakPoint> &points,
                       const double time)
{
  if (time <= points.front().time)
    return points.front().front;
  for (std::size_t i = 1; i < points.size(); ++i)
    if (time <= points[i].time)
    {
      const DamBreakPoint &a = points[i - 1], &b = points[i];
      return a.front +
             (b.front - a.front) * (time - a.time) / (b.time - a.time);
    }
  return points.back().front;
}
} // namespace contrecoup
