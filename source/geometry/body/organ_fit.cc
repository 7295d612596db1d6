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

  /// Change that brings the points around a section to the wanted depth.
  struct Change
  {
    double factor = 1.; ///< of widths
    Tensor<1, 3> move;  ///< sum over points that are not deep enough [m]
    double n = 0.;      ///< number of these
  };


  /// By section; empty where all points are deep enough.
  std::vector<Change> find_changes(const SectionWarp &warp,
                                   const Shape &surface,
                                   const OrganSurface &organ,
                                   const double depth)
  {
    const std::vector<SectionPair> &pairs = warp.pairs();
    std::vector<Change> changes(pairs.size());
    bool all_fit = true;
    const std::vector<double> depths = organ.depths(surface, warp);
    for (std::size_t n = 0; n < depths.size(); ++n)
    {
      const double missing = depth - depths[n];
      if (missing <= 0.)
        continue;
      all_fit = false;
      const Point<3> &point = organ.points()[n];
      const Point<3> place = warp.apply(point);
      const double station = warp.frame().coordinates(point)[0];
      const SectionPair section = warp.at(station);
      const auto x = warp.new_frame().coordinates(place);
      const double radius =
        std::hypot(x[1] - section.new_center[0], x[2] - section.new_center[1]);
      const double factor = std::clamp(
        1. - (missing + excess * depth) / std::max(radius, missing), 0.7, 1.);
      const Tensor<1, 3> move = -missing * surface.normal(place);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if ((i == 0 || pairs[i - 1].station < station) &&
            (i + 1 == pairs.size() || pairs[i + 1].station > station))
        {
          changes[i].factor = std::min(changes[i].factor, factor);
          changes[i].move += move;
          changes[i].n += 1.;
        }
    }
    return all_fit ? std::vector<Change>() : changes;
  }


  SectionWarp with_narrower_sections(const SectionWarp &warp,
                                     const std::vector<Change> &changes)
  {
    std::vector<SectionPair> pairs = warp.pairs();
    std::vector<double> factors;
    for (const Change &change : changes)
      factors.push_back(change.factor);
    factors = spread_out(factors);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      for (double &ratio : pairs[i].ratio)
        ratio *= factors[i];
    return SectionWarp(warp.frame(), warp.new_frame(), pairs);
  }


  /// Moves sections across the limb, but the first and the last one.
  SectionWarp with_moved_sections(const SectionWarp &warp,
                                  const std::vector<Change> &changes)
  {
    const SectionFrame &frame = warp.new_frame();
    std::vector<SectionPair> pairs = warp.pairs();
    for (std::size_t i = 1; i + 1 < pairs.size(); ++i)
      if (changes[i].n > 0.)
      {
        const Tensor<1, 3> move = changes[i].move / changes[i].n;
        pairs[i].new_center[0] += move * frame.first;
        pairs[i].new_center[1] += move * frame.second;
      }
    return SectionWarp(warp.frame(), frame, pairs);
  }
} // namespace


OrganSurface::OrganSurface(const Shape &organ,
                           const double spacing,
                           const double patch)
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
  const double radius = patch > 0. ? std::max(patch, 1.5 * spacing) : spacing;
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
    const std::vector<Change> changes =
      find_changes(result, surface, organ, depth);
    if (changes.empty())
      break;
    result = with_narrower_sections(result, changes);
  }
  return result;
}


SectionWarp with_limb_inside(const SectionWarp &warp,
                             const Shape &surface,
                             const OrganSurface &organ,
                             const double depth)
{
  // Parts next to the limb only move at first.
  constexpr unsigned int n_moves = 8, most_steps = 32;
  SectionWarp result = warp;
  for (unsigned int step = 0; step < most_steps; ++step)
  {
    const std::vector<Change> changes =
      find_changes(result, surface, organ, depth);
    if (changes.empty())
      break;
    result = step < n_moves || step % 2 == 0
               ? with_moved_sections(result, changes)
               : with_narrower_sections(result, changes);
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
