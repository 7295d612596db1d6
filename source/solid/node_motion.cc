// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/node_motion.h>

#include <algorithm>

namespace contrecoup::solid
{
namespace
{
  /// The numbers of a node side by side.
  template <typename Real>
  using Four = dealii::VectorizedArray<Real, 4>;

  /// Nodes whose work is added up before it goes into a double.
  constexpr std::size_t nodes_at_once = 512;

  template <typename Real>
  Four<Real> load(const Real *values)
  {
    Four<Real> result;
    result.load(values);
    return result;
  }

  template <typename Real>
  double sum_of(const Four<Real> &values)
  {
    return double(values[0]) + double(values[1]) + double(values[2]) +
           double(values[3]);
  }
} // namespace


template <typename Real>
double move_nodes(NodeFields<Real> &nodes,
                  const std::vector<unsigned char> &counted,
                  const double before,
                  const double next)
{
  const Four<Real> zero = Real(0.);
  const Real half = Real(0.5 * (before + next));
  const Real work_before = Real(0.5 * before), work_next = Real(0.5 * next);
  Four<Real> step = Real(next);
  step[3] = Real(0.);
  double work = 0.;
  for (std::size_t first = 0; first < counted.size(); first += nodes_at_once)
  {
    Four<Real> sum = zero;
    const std::size_t last = std::min(first + nodes_at_once, counted.size());
    for (std::size_t i = first; i < last; ++i)
    {
      const Four<Real> force = load(nodes.force_of(i));
      const Four<Real> old = load(nodes.velocity_of(i));
      // The fourth of a force is zero, so masses stay.
      const Four<Real> velocity =
        old + (half * nodes.inverse_mass_of(i)) * force;
      const Four<Real> displacement =
        load(nodes.displacement_of(i)) + step * velocity;
      velocity.store(nodes.velocity_of(i));
      displacement.store(nodes.displacement_of(i));
      zero.store(nodes.force_of(i));
      sum +=
        Real(counted[i]) * force * (work_before * old + work_next * velocity);
    }
    work += sum_of(sum);
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
