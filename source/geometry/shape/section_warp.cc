// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/section_warp.h>

#include <deal.II/base/symmetric_tensor.h>

namespace contrecoup
{
using dealii::BoundingBox;
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Index of the interval for a station; the first or last one beyond them.
  template <double SectionPair::*station>
  std::size_t find_interval(const std::vector<SectionPair> &pairs,
                            const double value)
  {
    const auto above =
      std::upper_bound(pairs.begin() + 1,
                       pairs.end() - 1,
                       value,
                       [](const double v, const SectionPair &pair) {
                         return v < pair.*station;
                       });
    return above - pairs.begin() - 1;
  }

  std::array<double, 2> turned(const std::array<double, 2> &across,
                               const double angle)
  {
    const double c = std::cos(angle), s = std::sin(angle);
    return {{c * across[0] - s * across[1], s * across[0] + c * across[1]}};
  }
} // namespace


std::array<double, 3> SectionFrame::coordinates(const Point<3> &point) const
{
  const Tensor<1, 3> offset = point - origin;
  return {{offset * along, offset * first, offset * second}};
}


Point<3> SectionFrame::point(const std::array<double, 3> &coordinates) const
{
  return origin + coordinates[0] * along + coordinates[1] * first +
         coordinates[2] * second;
}


SectionWarp::SectionWarp(const SectionFrame &frame,
                         const SectionFrame &new_frame,
                         const std::vector<SectionPair> &pairs)
  : frame_(frame)
  , new_frame_(new_frame)
  , pairs_(pairs)
{
  AssertThrow(pairs_.size() >= 2, dealii::ExcInternalError());
  for (std::size_t i = 0; i < pairs_.size(); ++i)
  {
    AssertThrow(pairs_[i].ratio[0] > 0. && pairs_[i].ratio[1] > 0.,
                dealii::ExcInternalError());
    AssertThrow(i == 0 || (pairs_[i].station > pairs_[i - 1].station &&
                           pairs_[i].new_station > pairs_[i - 1].new_station),
                dealii::ExcInternalError());
  }
}


SectionPair SectionWarp::interpolate(const std::size_t interval,
                                     const double weight) const
{
  const SectionPair &a = pairs_[interval], &b = pairs_[interval + 1];
  // Stations continue beyond the ends, all else keeps its value there.
  const double inner = std::clamp(weight, 0., 1.);
  const auto between = [](const double x, const double y, const double w) {
    return x + w * (y - x);
  };
  SectionPair result;
  result.station = between(a.station, b.station, weight);
  result.new_station = between(a.new_station, b.new_station, weight);
  for (unsigned int d = 0; d < 2; ++d)
  {
    result.center[d] = between(a.center[d], b.center[d], inner);
    result.new_center[d] = between(a.new_center[d], b.new_center[d], inner);
    result.ratio[d] = between(a.ratio[d], b.ratio[d], inner);
  }
  result.turn = between(a.turn, b.turn, inner);
  result.new_turn = between(a.new_turn, b.new_turn, inner);
  return result;
}


SectionPair SectionWarp::at(const double station) const
{
  const std::size_t i = find_interval<&SectionPair::station>(pairs_, station);
  return interpolate(i,
                     (station - pairs_[i].station) /
                       (pairs_[i + 1].station - pairs_[i].station));
}


Point<3> SectionWarp::apply(const Point<3> &point) const
{
  const auto x = frame_.coordinates(point);
  const SectionPair pair = at(x[0]);
  auto across =
    turned({{x[1] - pair.center[0], x[2] - pair.center[1]}}, -pair.turn);
  across = turned({{pair.ratio[0] * across[0], pair.ratio[1] * across[1]}},
                  pair.new_turn);
  return new_frame_.point({{pair.new_station,
                            pair.new_center[0] + across[0],
                            pair.new_center[1] + across[1]}});
}


Point<3> SectionWarp::pull_back(const Point<3> &point) const
{
  const auto x = new_frame_.coordinates(point);
  const std::size_t i = find_interval<&SectionPair::new_station>(pairs_, x[0]);
  const SectionPair pair =
    interpolate(i,
                (x[0] - pairs_[i].new_station) /
                  (pairs_[i + 1].new_station - pairs_[i].new_station));
  auto across = turned({{x[1] - pair.new_center[0], x[2] - pair.new_center[1]}},
                       -pair.new_turn);
  across =
    turned({{across[0] / pair.ratio[0], across[1] / pair.ratio[1]}}, pair.turn);
  return frame_.point(
    {{pair.station, pair.center[0] + across[0], pair.center[1] + across[1]}});
}


WarpedShape::WarpedShape(ShapePointer shape, const SectionWarp &warp)
  : shape_(std::move(shape))
  , warp_(warp)
  , box_(warped(shape_->bounding_box()))
  , stretch_(largest_stretch(box_))
{}


BoundingBox<3> WarpedShape::warped(const BoundingBox<3> &box) const
{
  // Within an interval the map is linear along lines across the limb, so that
  // the corners of prisms around the box bound all of it but for turns.
  double low = std::numeric_limits<double>::max(), high = -low;
  double reach = 0.;
  std::array<double, 2> lower{{low, low}}, upper{{high, high}};
  for (unsigned int v = 0; v < 8; ++v)
  {
    const auto x = warp_.frame().coordinates(box.vertex(v));
    low = std::min(low, x[0]);
    high = std::max(high, x[0]);
    for (unsigned int d = 0; d < 2; ++d)
    {
      lower[d] = std::min(lower[d], x[d + 1]);
      upper[d] = std::max(upper[d], x[d + 1]);
    }
  }
  std::vector<double> stations{low, high};
  for (const SectionPair &pair : warp_.pairs())
    if (pair.station > low && pair.station < high)
      stations.push_back(pair.station);
  std::vector<Point<3>> corners;
  for (const double station : stations)
    for (unsigned int v = 0; v < 4; ++v)
      corners.push_back(
        warp_.apply(warp_.frame().point({{station,
                                          v & 1 ? upper[0] : lower[0],
                                          v & 2 ? upper[1] : lower[1]}})));
  BoundingBox<3> result(corners);
  for (std::size_t i = 1; i < warp_.pairs().size(); ++i)
    reach = std::max(
      reach,
      std::abs(warp_.pairs()[i].new_turn - warp_.pairs()[i - 1].new_turn));
  // A turn by an angle between two sections bulges by less than its square.
  result.extend(reach * reach * (upper[0] - lower[0] + upper[1] - lower[1]));
  return result;
}


double WarpedShape::largest_stretch(const BoundingBox<3> &box) const
{
  double low = std::numeric_limits<double>::max(), high = -low;
  for (unsigned int v = 0; v < 8; ++v)
  {
    const double x = warp_.new_frame().coordinates(box.vertex(v))[0];
    low = std::min(low, x);
    high = std::max(high, x);
  }
  std::vector<double> stations{low, high};
  for (const SectionPair &pair : warp_.pairs())
    if (pair.new_station > low && pair.new_station < high)
      stations.push_back(pair.new_station);
  std::sort(stations.begin(), stations.end());
  double largest = 0.;
  for (std::size_t i = 1; i < stations.size(); ++i)
    for (const double weight : {0.02, 0.5, 0.98})
      for (unsigned int v = 0; v < 8; ++v)
      {
        // The corner of the box moved along the limb to this station.
        auto x = warp_.new_frame().coordinates(box.vertex(v));
        x[0] = stations[i - 1] + weight * (stations[i] - stations[i - 1]);
        const double step = 0.005 * (stations[i] - stations[i - 1]);
        Tensor<2, 3> jacobian;
        for (unsigned int d = 0; d < 3; ++d)
        {
          auto ahead = x, behind = x;
          ahead[d] += step;
          behind[d] -= step;
          const Tensor<1, 3> change =
            (warp_.pull_back(warp_.new_frame().point(ahead)) -
             warp_.pull_back(warp_.new_frame().point(behind))) /
            (2. * step);
          for (unsigned int c = 0; c < 3; ++c)
            jacobian[c][d] = change[c];
        }
        const auto squares = dealii::eigenvalues(
          dealii::symmetrize(transpose(jacobian) * jacobian));
        largest = std::max(largest, std::sqrt(squares[0]));
      }
  // Between the places looked at, the stretch is little larger.
  return 1.05 * largest;
}


double WarpedShape::value(const Point<3> &point) const
{
  const double outside = distance_to_box(box_, point);
  if (outside > 0.)
    return outside;
  return shape_->value(warp_.pull_back(point)) / stretch_;
}


BoundingBox<3> WarpedShape::bounding_box() const
{
  return box_;
}
} // namespace contrecoup
