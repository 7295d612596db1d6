// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/particle_block.h>
#include <contrecoup/mpm/row.h>
#include <contrecoup/mpm/transfer_kernels.h>
#include <contrecoup/numerics/element/spline_weights.h>

#include <algorithm>

/**
 * @file
 * Functions that the transfer kernels share: the splines of particles in
 * the window of their tile.
 */

namespace contrecoup::mpm
{
/// Spline weights of a batch of consecutive particles, one particle in each
/// lane.
template <unsigned int degree>
class SplineSupports
{
public:
  /// Number of nodes along an edge of a support.
  static constexpr unsigned int n = degree + 1;
  /// Number of particles in a batch; at most the padding of blocks.
  static constexpr std::size_t batch = 8;
  static_assert(batch <= ParticleBlock::padding);
  /// Lower bound of linear weights: negligible in sums, and its third power is
  /// negligible against the smallest nodal mass that counts.
  static constexpr double least_linear_weight = 1e-18;

  /// Computes the weights of the particles @p begin to @p begin + batch - 1 of
  /// a block.
  DEAL_II_ALWAYS_INLINE void reinit(const ParticleBlock &particles,
                                    const std::size_t begin,
                                    const WindowGeometry &geometry)
  {
    using Lane = Lanes<double>;
    const double per_cell = 1. / geometry.cell_size;
    for (std::size_t p = 0; p < batch; p += n_lanes<double>)
    {
      Lane offset(0.);
      for (int d = 2; d >= 0; --d)
      {
        Lane coordinate;
        coordinate.load(particles[column::position + d] + begin + p);
        coordinate = (coordinate - geometry.lower[d]) * per_cell;
        // Round down, but stay within the tile: round-off may put particles on
        // its sides outside.
        constexpr int last = TileGrid::tile_edge - (degree == 2 ? 0 : 1);
        Lane node(0.);
        for (int i = 1; i <= last; ++i)
          node += select_less(
            coordinate, Lane(i - spline_shift(degree)), Lane(0.), Lane(1.));
        set_weights(d, p, coordinate - node, per_cell);
        offset =
          offset * double(TileGrid::window_edge) +
          (node - double(first_node_offset(degree) + TileGrid::window_start));
      }
      for (unsigned int lane = 0; lane < n_lanes<double>; ++lane)
        first_[p + lane] = static_cast<std::size_t>(offset[lane]);
    }
  }

  /// Index of the first node of row j, k of the support of particle @p p of the
  /// batch.
  DEAL_II_ALWAYS_INLINE std::size_t
  at(const std::size_t p, const unsigned int j, const unsigned int k) const
  {
    return first_[p] + TileGrid::window_edge * (j + TileGrid::window_edge * k);
  }

  /// Weights of the four nodes along x.
  DEAL_II_ALWAYS_INLINE Row x(const std::size_t p) const
  {
    return Row::load(row_[p]);
  }
  DEAL_II_ALWAYS_INLINE Row slope_x(const std::size_t p) const
  {
    return Row::load(slope_row_[p]);
  }

  DEAL_II_ALWAYS_INLINE double value(const unsigned int direction,
                                     const unsigned int i,
                                     const std::size_t p) const
  {
    return value_[direction][i][p];
  }
  DEAL_II_ALWAYS_INLINE double slope(const unsigned int direction,
                                     const unsigned int i,
                                     const std::size_t p) const
  {
    return slope_[direction][i][p];
  }

private:
  DEAL_II_ALWAYS_INLINE void set_weights(const unsigned int d,
                                         const std::size_t p,
                                         const Lanes<double> &fraction,
                                         const double per_cell)
  {
    auto w = spline_weights_at<degree>(fraction);
    // A particle on a side belongs to the cell above it. Its slopes are not
    // zero at nodes that may have no other mass; a tiny weight makes these
    // nodes move along.
    if constexpr (degree == 1)
      for (unsigned int i = 0; i < n; ++i)
        w.value[i] = std::max(w.value[i], Lanes<double>(least_linear_weight));
    for (auto &slope : w.slope)
      slope *= per_cell;
    for (unsigned int i = 0; i < 4; ++i)
    {
      w.value[i].store(value_[d][i] + p);
      w.slope[i].store(slope_[d][i] + p);
    }
    if (d > 0)
      return;
    std::array<unsigned int, n_lanes<double>> rows;
    for (unsigned int lane = 0; lane < rows.size(); ++lane)
      rows[lane] = 4 * (p + lane);
    dealii::vectorized_transpose_and_store(
      false, 4, w.value.data(), rows.data(), &row_[0][0]);
    dealii::vectorized_transpose_and_store(
      false, 4, w.slope.data(), rows.data(), &slope_row_[0][0]);
  }

  std::size_t first_[batch];
  double value_[3][4][batch], slope_[3][4][batch];
  double row_[batch][4], slope_row_[batch][4];
};

/**
 * Calls @p work(supports, index in the batch, index of the particle) for all
 * particles.
 * @param supports work memory
 */
template <unsigned int degree, typename Work>
inline DEAL_II_ALWAYS_INLINE void
for_each_support(const ParticleBlock &particles,
                 const WindowGeometry &geometry,
                 SplineSupports<degree> &supports,
                 const Work &work)
{
  constexpr std::size_t batch = SplineSupports<degree>::batch;
  for (std::size_t begin = 0; begin < particles.size(); begin += batch)
  {
    supports.reinit(particles, begin, geometry);
    const std::size_t n = std::min(batch, particles.size() - begin);
    for (std::size_t p = 0; p < n; ++p)
      work(supports, p, begin + p);
  }
}

/// Calls @p work(node of the window, linear weight of the node) for the eight
/// corners of the cell that contains a particle.
template <typename Work>
inline DEAL_II_ALWAYS_INLINE void
for_each_corner(const SplineSupports<1> &support,
                const std::size_t in_batch,
                const Work &work)
{
  for (unsigned int k = 0; k < 2; ++k)
    for (unsigned int j = 0; j < 2; ++j)
      for (unsigned int i = 0; i < 2; ++i)
        work(support.at(in_batch, j, k) + i,
             support.value(0, i, in_batch) * support.value(1, j, in_batch) *
               support.value(2, k, in_batch));
}

/**
 * Calls @p function with work memory for the degree. The memory is not on the
 * stack, because gcc 12 then removes calls as having no effect: it derives the
 * addresses of local arrays and of the window from one another.
 */
template <typename Function>
void with_supports(const unsigned int degree, const Function &function)
{
  static thread_local SplineSupports<1> linear;
  static thread_local SplineSupports<2> quadratic;
  static thread_local SplineSupports<3> cubic;
  if (degree == 1)
    function(linear);
  else if (degree == 2)
    function(quadratic);
  else
    function(cubic);
}
} // namespace contrecoup::mpm
