// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/body/state_redistribution.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// A number that tells apart the neighbourhoods that a cell belongs to, the
  /// same on all ranks: by face, place, and where the first cell is in one of
  /// twice the size.
  template <typename Neighborhood>
  unsigned int place_in_order(const Neighborhood &neighborhood,
                              const unsigned int place,
                              const LeafLayout &layout)
  {
    const unsigned int q = neighborhood.cells.front().point, n = layout.n;
    return 64 * neighborhood.face + 8 * place + q % n % 2 + q / n % n % 2 * 2 +
           q / (n * n) % 2 * 4;
  }
} // namespace


template <int dim>
void StateRedistribution<dim>::reinit(const CutLeaves<dim> &cut_leaves,
                                      const LeafMesh<dim> &mesh,
                                      const LeafLayout &layout)
{
  stride_ = std::size_t(layout.n_points) * layout.width;
  n_components_ = layout.n_components;
  members_.clear();
  first_member_.assign(1, 0);
  receivers_.clear();
  for (const auto &neighborhood : cut_leaves.neighborhoods())
  {
    double volume = 0.;
    unsigned int place = 0;
    for (const auto &cell : neighborhood.cells)
    {
      const double fraction = 1. / cut_leaves.n_memberships(cell);
      const double share =
        cut_leaves.fractions()(cell.leaf, cell.point) * cell.size * fraction;
      const std::size_t position =
        layout.offset(cell.leaf) + layout.value(0, cell.point);
      volume += share;
      members_.push_back({position, share});
      if (cell.leaf < mesh.n_owned())
        receivers_.push_back(
          {position,
           place_in_order(neighborhood, place, layout),
           static_cast<unsigned int>(first_member_.size() - 1),
           fraction});
      ++place;
    }
    for (auto i = first_member_.back(); i < members_.size(); ++i)
      members_[i].weight /= volume;
    first_member_.push_back(members_.size());
  }
  std::sort(receivers_.begin(), receivers_.end());
}


template <int dim>
template <typename Real>
void StateRedistribution<dim>::apply(Real *state) const
{
  const std::size_t n_neighborhoods = first_member_.size() - 1;
  std::vector<double> means(n_neighborhoods * n_components_);
  for (std::size_t i = 0; i < n_neighborhoods; ++i)
  {
    // Differences from the last cell, the one farthest from the wall, so that
    // equal states keep every bit.
    const Member &last = members_[first_member_[i + 1] - 1];
    for (unsigned int c = 0; c < n_components_; ++c)
    {
      const double base = state[last.position + c * stride_];
      double mean = base;
      for (std::size_t m = first_member_[i]; m + 1 < first_member_[i + 1]; ++m)
        mean += members_[m].weight *
                (double(state[members_[m].position + c * stride_]) - base);
      means[i * n_components_ + c] = mean;
    }
  }
  for (std::size_t r = 0; r < receivers_.size();)
  {
    std::size_t end = r;
    while (end < receivers_.size() &&
           receivers_[end].position == receivers_[r].position)
      ++end;
    for (unsigned int c = 0; c < n_components_; ++c)
    {
      Real &value = state[receivers_[r].position + c * stride_];
      double change = 0.;
      for (std::size_t i = r; i < end; ++i)
        change += means[receivers_[i].neighborhood * n_components_ + c] - value;
      value += change * receivers_[r].fraction;
    }
    r = end;
  }
}


#define CONTRECOUP_INSTANTIATE(dim)                              \
  template class StateRedistribution<dim>;                       \
  template void StateRedistribution<dim>::apply(double *) const; \
  template void StateRedistribution<dim>::apply(float *) const

CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
