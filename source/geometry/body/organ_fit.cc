// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/organ_fit.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Points are brought this much deeper than needed, which ends iterations.
  constexpr double excess = 0.05;


  /// Means of neighbours, where these are smaller.
  std::vector<double> spread_out(const std::vector<double> &factors)
  {
    std::vector<double> result = factors;
    for (std::size_t i = 1; i + 1 < factors.size(); ++i)
      result[i] = std::min(factors[i],
                           (factors[i - 1] + factors[i] + factors[i + 1]) / 3.);
    return result;
  }


  /// Scales a section across z around a place and moves it.
  void move_and_scale(SectionPair &pair,
                      const Tensor<1, 3> &move,
                      const Tensor<1, 3> &middle,
                      const double factor)
  {
    pair.new_station =
      middle[2] + factor * (pair.new_station - middle[2]) + move[2];
    for (unsigned int d = 0; d < 2; ++d)
    {
      pair.new_center[d] =
        middle[d] + factor * (pair.new_center[d] - middle[d]) + move[d];
      pair.ratio[d] *= factor;
    }
  }
} // namespace


OrganSurface::OrganSurface(const Shape &organ, const double spacing)
{
  const LabelGrid grid = fill_shape(organ, spacing);
  for (unsigned int k = 1; k + 1 < grid.size[2]; ++k)
    for (unsigned int j = 1; j + 1 < grid.size[1]; ++j)
      for (unsigned int i = 1; i + 1 < grid.size[0]; ++i)
        if (grid.at(i, j, k) != LabelGrid::outside &&
            (grid.at(i - 1, j, k) == LabelGrid::outside ||
             grid.at(i + 1, j, k) == LabelGrid::outside ||
             grid.at(i, j - 1, k) == LabelGrid::outside ||
             grid.at(i, j + 1, k) == LabelGrid::outside ||
             grid.at(i, j, k - 1) == LabelGrid::outside ||
             grid.at(i, j, k + 1) == LabelGrid::outside))
          points_.push_back(organ.project(grid.center(i, j, k)));
  // Wider than the elements of which a surface may consist.
  constexpr double least_radius = 0.015;
  const double radius = std::max(least_radius, 1.5 * spacing);
  patches_.resize(points_.size());
  for (std::uint32_t i = 0; i < points_.size(); ++i)
    for (std::uint32_t j = 0; j < points_.size(); ++j)
      if (points_[i].distance_square(points_[j]) < radius * radius)
        patches_[i].push_back(j);
}


std::vector<double> OrganSurface::depths(const Shape &surface,
                                         const SectionWarp &warp) const
{
  std::vector<double> values;
  for (const Point<3> &point : points_)
    values.push_back(-surface.value(warp.apply(point)));
  std::vector<double> means;
  for (const std::vector<std::uint32_t> &patch : patches_)
  {
    double sum = 0.;
    for (const std::uint32_t point : patch)
      sum += values[point];
    means.push_back(sum / double(patch.size()));
  }
  return means;
}


double OrganSurface::least_depth(const Shape &surface,
                                 const SectionWarp &warp) const
{
  const std::vector<double> all = depths(surface, warp);
  return all.empty() ? std::numeric_limits<double>::max()
                     : *std::min_element(all.begin(), all.end());
}


SectionWarp narrowed(const SectionWarp &warp,
                     const Shape &surface,
                     const OrganSurface &organ,
                     const double depth)
{
  constexpr unsigned int most_steps = 12;
  SectionWarp result = warp;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    std::vector<SectionPair> pairs = result.pairs();
    std::vector<double> factors(pairs.size(), 1.);
    bool all_fit = true;
    const std::vector<double> depths = organ.depths(surface, result);
    for (std::size_t n = 0; n < depths.size(); ++n)
    {
      const double missing = depth - depths[n];
      if (missing <= 0.)
        continue;
      all_fit = false;
      const Point<3> &point = organ.points()[n];
      const Point<3> place = result.apply(point);
      const double station = result.frame().coordinates(point)[0];
      const SectionPair section = result.at(station);
      const auto x = result.new_frame().coordinates(place);
      const double radius =
        std::hypot(x[1] - section.new_center[0], x[2] - section.new_center[1]);
      const double factor = std::clamp(
        1. - (missing + excess * depth) / std::max(radius, missing), 0.7, 1.);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if ((i == 0 || pairs[i - 1].station < station) &&
            (i + 1 == pairs.size() || pairs[i + 1].station > station))
          factors[i] = std::min(factors[i], factor);
    }
    if (all_fit)
      break;
    factors = spread_out(factors);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (double &ratio : pairs[i].ratio)
        ratio *= factors[i];
    result = SectionWarp(warp.frame(), warp.new_frame(), pairs);
  }
  return result;
}


SectionWarp with_head_inside(const SectionWarp &warp,
                             const Shape &surface,
                             const OrganSurface &organ,
                             const double depth)
{
  constexpr unsigned int most_steps = 80;
  constexpr double least_factor = 0.985; // of one step
  SectionWarp result = warp;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    Tensor<1, 3> move, middle;
    double n = 0., factor = 1.;
    for (const Point<3> &point : organ.points())
      middle += result.apply(point) / double(organ.points().size());
    const std::vector<double> depths = organ.depths(surface, result);
    for (std::size_t i = 0; i < depths.size(); ++i)
    {
      const double missing = depth - depths[i];
      if (missing <= 0.)
        continue;
      const Point<3> place = result.apply(organ.points()[i]);
      move -= missing * surface.normal(place);
      n += 1.;
      factor = std::min(factor,
                        1. - (missing + excess * depth) /
                               (place - Point<3>(middle)).norm());
    }
    if (n == 0.)
      break;
    // Moves alternate with small steps of shrinking: what is tight on one
    // side only moves.
    const bool moves = step % 2 == 0;
    factor = moves ? 1. : std::max(factor, least_factor);
    std::vector<SectionPair> pairs = result.pairs();
    for (std::size_t i = pairs.size() - 2; i < pairs.size(); ++i)
      move_and_scale(
        pairs[i], moves ? move / n : Tensor<1, 3>(), middle, factor);
    if (pairs[pairs.size() - 2].new_station <=
        pairs[pairs.size() - 3].new_station)
      break;
    result = SectionWarp(warp.frame(), warp.new_frame(), pairs);
  }
  return result;
}
} // namespace contrecoup
