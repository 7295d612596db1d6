// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/two_scale.h>

#include <algorithm>

namespace contrecoup::mpm
{
namespace
{
  constexpr int edge = TileGrid::window_edge;

  /// Nodes of level 1 of a window along an edge, the first of which is in the
  /// middle of two of level 0, and the last node of level 0 that they need.
  constexpr int n_fine = 7, n_coarse = 5;

  /// Of nodes of level 0 from the first that a node of level 1 needs.
  struct Weights
  {
    int n;
    double weight[3];
  };

  /// Of nodes in the middle of two of level 0, and of those at one.
  const Weights &weights(const unsigned int degree, const int node)
  {
    static constexpr Weights middle{2, {0.5, 0.5, 0.}}, linear{3, {0., 1., 0.}},
      cubic{3, {0.125, 0.75, 0.125}};
    return node % 2 == 0 ? middle : degree == 1 ? linear : cubic;
  }

  /// Calls @p work(first value, first value, weights) for each node of level 1
  /// along lines: their nodes are @p stride apart.
  template <typename Work>
  void for_each_term(const unsigned int degree,
                     const int stride,
                     const int n_a,
                     const int stride_a,
                     const int n_b,
                     const int stride_b,
                     const Work &work)
  {
    for (int b = 0; b < n_b; ++b)
      for (int a = 0; a < n_a; ++a)
        for (int i = 0; i < n_fine; ++i)
        {
          const int line = a * stride_a + b * stride_b;
          const Weights &w = weights(degree, i);
          for (int k = 0; k < w.n; ++k)
            work(line + i * stride, line + (i / 2 + k) * stride, w.weight[k]);
        }
  }

  /// Calls @p work(node of the finer side, node of the coarser side, weight)
  /// for the pass along a direction: directions below it are coarse on both
  /// sides, those above it fine.
  template <typename Work>
  void for_each_in_pass(const unsigned int degree,
                        const int direction,
                        const Work &work)
  {
    constexpr int strides[] = {1, edge, edge * edge};
    const int a = direction == 0 ? 1 : 0, b = direction == 2 ? 1 : 2;
    const auto n = [&](const int d) {
      return d < direction ? n_coarse : n_fine;
    };
    for_each_term(
      degree, strides[direction], n(a), strides[a], n(b), strides[b], work);
  }
} // namespace


void refine_window(const unsigned int degree,
                   const double *const coarse,
                   double *const fine)
{
  static thread_local Window passes(3 * TileGrid::window_size);
  passes.fill(0.);
  const double *from = coarse;
  for (int direction = 2; direction >= 0; --direction)
  {
    double *const to = passes.data() + TileGrid::window_size * direction;
    for_each_in_pass(
      degree,
      direction,
      [&](const int at, const int coarse_at, const double weight) {
        to[at] += weight * from[coarse_at];
      });
    from = to;
  }
  std::copy_n(passes.data(), TileGrid::window_size, fine);
}


void add_coarsened_window(const unsigned int degree,
                          const double *const fine,
                          double *const coarse)
{
  static thread_local Window passes(2 * TileGrid::window_size);
  passes.fill(0.);
  const double *from = fine;
  for (int direction = 0; direction < 3; ++direction)
  {
    double *const to = direction == 2
                         ? coarse
                         : passes.data() + TileGrid::window_size * direction;
    for_each_in_pass(
      degree,
      direction,
      [&](const int at, const int coarse_at, const double weight) {
        to[coarse_at] += weight * from[at];
      });
    from = to;
  }
}
} // namespace contrecoup::mpm
