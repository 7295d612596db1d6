// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/solid/motion/node_motion.h>

#include <algorithm>
#include <array>

namespace contrecoup::solid
{
namespace
{
  /// Number of a node's four values in one vector register.
  template <typename Real>
  constexpr std::size_t width = n_lanes<Real> < 4 ? n_lanes<Real> : 4;
  template <typename Real>
  using Part = dealii::VectorizedArray<Real, width<Real>>;

  template <typename Real>
  Part<Real> load(const Real *values)
  {
    Part<Real> result;
    result.load(values);
    return result;
  }

  /// Whether all forces on the nodes first to last - 1 are zero.
  template <typename Real>
  bool free_of_forces(const NodeFields<Real> &nodes,
                      const std::size_t first,
                      const std::size_t last)
  {
    bool free = true;
    for (const Real *f = nodes.force_of(first); f != nodes.force_of(last); ++f)
      free = free && *f == Real();
    return free;
  }
} // namespace


template <typename Real>
double move_nodes(NodeFields<Real> &nodes,
                  const std::vector<unsigned char> &counted,
                  const double before,
                  const double next)
{
  constexpr std::size_t n_parts = 4 / width<Real>;
  constexpr std::size_t block = NodeFields<Real>::block;
  const Part<Real> zero = Real(0.);
  const Real half = Real(0.5 * (before + next));
  const Real work_before = Real(0.5 * before), work_next = Real(0.5 * next);
  const Part<Real> step = Real(next);
  constexpr std::size_t last_lane = width<Real> - 1;
  double work = 0.;
  for (std::size_t first = 0; first < counted.size(); first += block)
  {
    const std::size_t last = std::min(first + block, counted.size());
    unsigned char &is_active = nodes.active[first / block];
    if (is_active == 0 && free_of_forces(nodes, first, last))
      continue;
    is_active = 1;
    std::array<Part<Real>, n_parts> sum;
    sum.fill(zero);
    for (std::size_t i = first; i < last; ++i)
      for (std::size_t k = 0; k < n_parts; ++k)
      {
        const std::size_t at = k * width<Real>;
        Part<Real> force = load(nodes.force_of(i) + at);
        const Real share = force[last_lane];
        // Next to the velocity is the inverse mass, which does not change.
        if (k + 1 == n_parts)
          force[last_lane] = Real();
        const Part<Real> old = load(nodes.velocity_of(i) + at);
        const Part<Real> velocity =
          old + (half * nodes.inverse_mass_of(i)) * force;
        Part<Real> displacement =
          load(nodes.displacement_of(i) + at) + step * velocity;
        if (k + 1 == n_parts)
          displacement[last_lane] = share * nodes.inverse_weight_of(i);
        velocity.store(nodes.velocity_of(i) + at);
        displacement.store(nodes.displacement_of(i) + at);
        zero.store(nodes.force_of(i) + at);
        sum[k] +=
          Real(counted[i]) * force * (work_before * old + work_next * velocity);
      }
    for (const Part<Real> &part : sum)
      for (std::size_t lane = 0; lane < width<Real>; ++lane)
        work += double(part[lane]);
  }
  return work;
}


template <typename Real>
double work_until_now(const NodeFields<Real> &nodes,
                      const std::vector<unsigned char> &counted,
                      const double before)
{
  double work = 0.;
  for (std::size_t i = 0; i < counted.size(); ++i)
    if (counted[i] != 0)
      for (unsigned int d = 0; d < 3; ++d)
        work += 0.5 * before * double(nodes.force_of(i)[d]) *
                double(nodes.velocity_of(i)[d]);
  return work;
}


template double move_nodes(NodeFields<double> &,
                           const std::vector<unsigned char> &,
                           const double,
                           const double);
template double move_nodes(NodeFields<float> &,
                           const std::vector<unsigned char> &,
                           const double,
                           const double);
template double work_until_now(const NodeFields<double> &,
                               const std::vector<unsigned char> &,
                               const double);
template double work_until_now(const NodeFields<float> &,
                               const std::vector<unsigned char> &,
                               const double);
} // namespace contrecoup::solid
