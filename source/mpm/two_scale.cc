// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/two_scale.h>

#include <algorithm>

namespace contrecoup::mpm
{
namespace
{
  constexpr int edge = TileGrid::window_edge, plane = edge * edge;

  /// Number of nodes of level 1 of a window along an edge; the first one lies
  /// in the middle between two nodes of level 0.
  constexpr int n_fine = 7, n_coarse = two_scale_nodes;

  /// Weights of a node of level 0 for the node of level 1 at its position, and
  /// for those at a distance of one cell.
  struct Weights
  {
    double at, beside;
  };

  Weights weights(const unsigned int degree)
  {
    return degree == 1 ? Weights{1., 0.} : Weights{0.75, 0.125};
  }

  /// Sets node @p i of level 1 of consecutive lines from their nodes of level
  /// 0, which are @p stride apart.
  inline void refine(const Weights &w,
                     const int i,
                     const int stride,
                     const int n_lines,
                     const double *const coarse,
                     double *const fine)
  {
    const double *const from = coarse + i / 2 * stride;
    double *const to = fine + i * stride;
    if (i % 2 == 0)
      for (int e = 0; e < n_lines; ++e)
        to[e] = 0.5 * (from[e] + from[stride + e]);
    else
      for (int e = 0; e < n_lines; ++e)
        to[e] =
          w.at * from[stride + e] + w.beside * (from[e] + from[2 * stride + e]);
  }

  /// Transposed operation: sets node @p i of level 0 of such lines.
  inline void coarsen(const Weights &w,
                      const int i,
                      const int stride,
                      const int n_lines,
                      const double *const fine,
                      double *const coarse)
  {
    double *const to = coarse + i * stride;
    for (int e = 0; e < n_lines; ++e)
      to[e] = 0.;
    for (int j = std::max(2 * i - 3, 0); j <= std::min(2 * i + 1, n_fine - 1);
         ++j)
    {
      const double weight = j % 2 == 0 ? 0.5 : j == 2 * i - 1 ? w.at : w.beside;
      const double *const from = fine + j * stride;
      for (int e = 0; e < n_lines; ++e)
        to[e] += weight * from[e];
    }
  }

  /// The same for all nodes of a row along x.
  inline void
  coarsen_row(const Weights &w, const double *const fine, double *const coarse)
  {
    const double f0 = fine[0], f1 = fine[1], f2 = fine[2], f3 = fine[3],
                 f4 = fine[4], f5 = fine[5], f6 = fine[6];
    coarse[0] = 0.5 * f0 + w.beside * f1;
    coarse[1] = 0.5 * (f0 + f2) + w.at * f1 + w.beside * f3;
    coarse[2] = 0.5 * (f2 + f4) + w.at * f3 + w.beside * (f1 + f5);
    coarse[3] = 0.5 * (f4 + f6) + w.at * f5 + w.beside * f3;
    coarse[4] = 0.5 * f6 + w.beside * f5;
  }
} // namespace


void refine_window(const unsigned int degree,
                   const double *const coarse,
                   double *const fine)
{
  static thread_local Window along_z(TileGrid::window_size),
    along_y(TileGrid::window_size);
  const Weights w = weights(degree);
  for (int k = 0; k < n_fine; ++k)
    refine(w, k, plane, n_coarse * edge, coarse, along_z.data());
  for (int k = 0; k < n_fine; ++k)
  {
    for (int j = 0; j < n_fine; ++j)
      refine(w,
             j,
             edge,
             edge,
             along_z.data() + plane * k,
             along_y.data() + plane * k);
    for (int j = 0; j < n_fine; ++j)
      for (int i = 0; i < n_fine; ++i)
        refine(w,
               i,
               1,
               1,
               along_y.data() + plane * k + edge * j,
               fine + plane * k + edge * j);
  }
}


void coarsen_window(const unsigned int degree,
                    const double *const fine,
                    double *const coarse)
{
  static thread_local Window along_x(TileGrid::window_size),
    along_y(TileGrid::window_size);
  const Weights w = weights(degree);
  for (int k = 0; k < n_fine; ++k)
  {
    for (int j = 0; j < n_fine; ++j)
      coarsen_row(
        w, fine + plane * k + edge * j, along_x.data() + plane * k + edge * j);
    for (int j = 0; j < n_coarse; ++j)
      coarsen(w,
              j,
              edge,
              edge,
              along_x.data() + plane * k,
              along_y.data() + plane * k);
  }
  for (int k = 0; k < n_coarse; ++k)
    coarsen(w, k, plane, n_coarse * edge, along_y.data(), coarse);
}
} // namespace contrecoup::mpm
