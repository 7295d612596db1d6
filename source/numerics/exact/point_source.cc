// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/point_source.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <sstream>

namespace contrecoup
{
namespace
{
  /// A table row, in logarithms: scaled radius x = ln(R / length),
  /// overpressure ratio y = ln(p / p_0 - 1), lead over sound z = ln((R - c_0
  /// t) / length), and the derivatives of y and z with respect to x.
  struct Row
  {
    double x, y, dy, z, dz;
  };

  constexpr std::array<Row, 44> table = {{
    {-4.2816147, 10.99121774, -2.99994103, -4.28338973, 0.99733513},
    {-4.20868609, 10.77243643, -2.99992661, -4.21066652, 0.99702648},
    {-3.71151174, 9.28099075, -2.99971068, -3.71569101, 0.99371858},
    {-3.43113554, 8.43999369, -2.99930987, -3.43750638, 0.99041533},
    {-3.16713677, 7.64827666, -2.99846957, -3.17661645, 0.9857198},
    {-2.92945389, 6.9357583, -2.99688234, -2.94301846, 0.97953476},
    {-2.72385401, 6.31984376, -2.99424058, -2.74235645, 0.97203917},
    {-2.54540988, 5.78586779, -2.99020621, -2.56964442, 0.96331858},
    {-2.38871835, 5.31774642, -2.98442571, -2.41944456, 0.95342726},
    {-2.24488609, 4.88903814, -2.97623741, -2.28310211, 0.94200956},
    {-2.11252276, 4.49578575, -2.96508677, -2.15924321, 0.9290586},
    {-1.98841814, 4.12867789, -2.95017507, -2.04482747, 0.91434989},
    {-1.87005263, 3.78058313, -2.93049897, -1.93756323, 0.89759655},
    {-1.75496261, 3.44472517, -2.90470932, -1.83533555, 0.87837254},
    {-1.63970461, 3.11181032, -2.87063845, -1.73536019, 0.85586838},
    {-1.51803217, 2.76525434, -2.82392072, -1.6328625, 0.82826655},
    {-1.39023213, 2.40820272, -2.7613347, -1.52909776, 0.79483249},
    {-1.27461978, 2.09284157, -2.69218514, -1.43914239, 0.76073294},
    {-1.16721453, 1.8076004, -2.61776782, -1.3592733, 0.7260717},
    {-1.06528245, 1.54470494, -2.53935786, -1.28703619, 0.69097415},
    {-0.96785766, 1.30118607, -2.45904221, -1.22141441, 0.65596327},
    {-0.87146971, 1.06813169, -2.37634493, -1.15989212, 0.62050795},
    {-0.77566868, 0.8444695, -2.29291336, -1.10214513, 0.58507002},
    {-0.67951329, 0.62800295, -2.20975492, -1.04758424, 0.54988932},
    {-0.58208851, 0.4167396, -2.12767789, -0.99571186, 0.51517794},
    {-0.48255002, 0.20898476, -2.04736872, -0.9461392, 0.48114621},
    {-0.38003003, 0.00313137, -1.96935328, -0.89852992, 0.44797661},
    {-0.27375188, -0.20211745, -1.8941181, -0.85264746, 0.41586468},
    {-0.16284095, -0.4081356, -1.82199439, -0.80826224, 0.38495971},
    {-0.04646313, -0.61610893, -1.75328058, -0.7652093, 0.35540826},
    {0.07635369, -0.82736659, -1.68814907, -0.72331636, 0.3273072},
    {0.20661735, -1.04318922, -1.62673247, -0.68244537, 0.30073577},
    {0.34542731, -1.26490838, -1.56910542, -0.64247224, 0.27574464},
    {0.4940561, -1.49402798, -1.51527037, -0.60326756, 0.25234815},
    {0.6521013, -1.72949726, -1.4657217, -0.56513174, 0.2307697},
    {0.81621598, -1.96631546, -1.42139639, -0.52888568, 0.21142329},
    {0.98777318, -2.20666334, -1.38157212, -0.49414658, 0.19399725},
    {1.16804146, -2.45239933, -1.3456906, -0.4606304, 0.17824815},
    {1.35828904, -2.70525152, -1.3132967, -0.4281114, 0.16397571},
    {1.55975529, -2.96680888, -1.28401967, -0.39641492, 0.15101564},
    {1.77368828, -3.23859502, -1.25754724, -0.36540113, 0.13922899},
    {2.00148149, -3.52225353, -1.23359894, -0.33494061, 0.12849081},
    {2.24458777, -3.81944261, -1.21193271, -0.30492576, 0.11869346},
    {2.50434694, -4.13163839, -1.19234897, -0.27528626, 0.10974886},
  }};


  /// A point of a curve.
  struct Knot
  {
    double x, y, slope;
  };

  /// Cubic Hermite interpolation.
  double interpolate(const double x, const Knot &low, const Knot &high)
  {
    const double h = high.x - low.x, t = (x - low.x) / h, s = 1. - t;
    return s * s * ((1. + 2. * t) * low.y + t * h * low.slope) +
           t * t * ((1. + 2. * s) * high.y - s * h * high.slope);
  }


  /// Row at or below the scaled radius exp(@p x).
  const Row *row_below(const double x)
  {
    constexpr double round_off = 1e-9;
    if (!(x >= table.front().x - round_off && x <= table.back().x + round_off))
    {
      std::ostringstream message;
      message << "The point-source table covers scaled radii from "
              << std::exp(table.front().x) << " to " << std::exp(table.back().x)
              << " (E/p)^(1/3), but " << std::exp(x) << " was asked for";
      throw InputError(message.str());
    }
    const auto above = std::upper_bound(
      std::next(table.begin()),
      std::prev(table.end()),
      x,
      [](const double value, const Row &row) { return value < row.x; });
    return &*std::prev(above);
  }
} // namespace


PointSourceSolution::PointSourceSolution(const double energy,
                                         const double pressure,
                                         const double density)
  : scaling_length_(std::cbrt(energy / pressure))
  , pressure_(pressure)
  , sound_speed_(std::sqrt(gamma * pressure / density))
{
  if (!(energy > 0.) || !(pressure > 0.) || !(density > 0.))
    throw InputError("A point source needs energy, ambient pressure and "
                     "ambient density above 0");
}


double PointSourceSolution::scaling_length() const
{
  return scaling_length_;
}


double PointSourceSolution::smallest_radius() const
{
  return std::exp(table.front().x) * scaling_length_;
}


double PointSourceSolution::largest_radius() const
{
  return std::exp(table.back().x) * scaling_length_;
}


double PointSourceSolution::overpressure(const double radius) const
{
  const double x = std::log(radius / scaling_length_);
  const Row *low = row_below(x), *high = std::next(low);
  return pressure_ * std::exp(interpolate(x,
                                          {low->x, low->y, low->dy},
                                          {high->x, high->y, high->dy}));
}


double PointSourceSolution::arrival_time(const double radius) const
{
  const double x = std::log(radius / scaling_length_);
  const Row *low = row_below(x), *high = std::next(low);
  const double lead = std::exp(
    interpolate(x, {low->x, low->z, low->dz}, {high->x, high->z, high->dz}));
  return (radius - lead * scaling_length_) / sound_speed_;
}
} // namespace contrecoup
