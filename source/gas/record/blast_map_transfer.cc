// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/blast_map_transfer.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  BlastRecord<float> record_of(const std::vector<float> &leaf,
                               const unsigned int point,
                               const unsigned int n_points)
  {
    return {leaf[point],
            leaf[point + n_points],
            leaf[point + 2 * n_points],
            leaf[point + 3 * n_points],
            leaf[point + 4 * n_points]};
  }

  /// Earlier of two arrivals; negated ones belong to rises that last, 0 means
  /// none.
  float earlier(const float a, const float b)
  {
    if (a == 0.F || b == 0.F)
      return a == 0.F ? b : a;
    return std::abs(b) < std::abs(a) ? b : a;
  }
} // namespace


template <int dim>
BlastMapTransfer<dim>::BlastMapTransfer(const LeafPoints<dim> &points)
  : n_points_(dealii::Utilities::pow(points.n(), dim))
  , contributions_(n_points_)
{
  // Fraction of point j of an edge that is covered by point i of half h of the
  // edge.
  const auto covered = [&](const unsigned int h,
                           const unsigned int i,
                           const unsigned int j) {
    const double begin = points.subcell_begin(j);
    const double end = points.subcell_end(j);
    const double common = std::min(end, 0.5 * (h + points.subcell_end(i))) -
                          std::max(begin, 0.5 * (h + points.subcell_begin(i)));
    return common > 1e-12 ? common / (end - begin) : 0.;
  };
  for (unsigned int child = 0; child < n_children; ++child)
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      unsigned int around = 0;
      double largest = 0.;
      for (unsigned int to = 0; to < n_points_; ++to)
      {
        double fraction = 1., own = 1.;
        for (unsigned int d = 0; d < dim; ++d)
        {
          const unsigned int i = points.indices(q)[d];
          const unsigned int j = points.indices(to)[d];
          fraction *= covered((child >> d) & 1U, i, j);
          own *= points.subcell_end(j) - points.subcell_begin(j);
        }
        if (fraction == 0.)
          continue;
        contributions_[to].push_back({child, q, fraction});
        if (fraction * own > largest)
        {
          largest = fraction * own;
          around = to;
        }
      }
      around_[child].push_back(around);
    }
}


template <int dim>
std::vector<std::vector<float>>
BlastMapTransfer<dim>::to_children(const std::vector<float> &parent) const
{
  std::vector<std::vector<float>> children(n_children,
                                           std::vector<float>(parent.size()));
  for (unsigned int child = 0; child < n_children; ++child)
    for (unsigned int v = 0; v < Record::n_values; ++v)
      for (unsigned int q = 0; q < n_points_; ++q)
        children[child][v * n_points_ + q] =
          parent[v * n_points_ + around_[child][q]];
  return children;
}


template <int dim>
BlastRecord<float>
BlastMapTransfer<dim>::merged(const std::vector<std::vector<float>> &children,
                              const unsigned int point) const
{
  Record result;
  bool is_open = false;
  double running = 0., impulse = 0.;
  for (const Contribution &item : contributions_[point])
  {
    const Record one = record_of(children[item.child], item.point, n_points_);
    if (std::isnan(one.peak))
      return one;
    result.peak = std::max(result.peak, one.peak);
    result.arrival = earlier(result.arrival, one.arrival);
    result.end = std::max(result.end, one.end);
    is_open = is_open || (one.peak > 0.F && one.end == 0.F);
    running += item.fraction * one.running;
    impulse += item.fraction * (one.end > 0.F ? one.impulse : one.running);
  }
  if (is_open)
    result.end = 0.F;
  result.running = static_cast<float>(running);
  result.impulse = static_cast<float>(is_open ? 0. : impulse);
  return result;
}


template <int dim>
std::vector<float> BlastMapTransfer<dim>::from_children(
  const std::vector<std::vector<float>> &children) const
{
  std::vector<float> parent(children[0].size());
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Record record = merged(children, q);
    const float values[] = {
      record.peak, record.arrival, record.running, record.impulse, record.end};
    for (unsigned int v = 0; v < Record::n_values; ++v)
      parent[v * n_points_ + q] = values[v];
  }
  return parent;
}


template class BlastMapTransfer<1>;
template class BlastMapTransfer<2>;
template class BlastMapTransfer<3>;
} // namespace contrecoup::gas
