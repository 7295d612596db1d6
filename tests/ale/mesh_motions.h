// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include "slab.h"

namespace contrecoup
{
/// Moves nodes that are inside by a wavy field, and others along their walls.
inline dealii::AlignedVector<double>
wavy(const Slab &slab, const double amplitude, const unsigned int mode)
{
  auto result = slab.space.positions(ale::node_width);
  double upper[3] = {0., 0., 0.};
  for (const auto &vertex : slab.mesh.get_vertices())
    for (unsigned int d = 0; d < 3; ++d)
      upper[d] = std::max(upper[d], vertex[d]);
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
  {
    double *x = &result[ale::node_width * n];
    double phase[3];
    for (unsigned int d = 0; d < 3; ++d)
      phase[d] = dealii::numbers::PI * x[d] / upper[d];
    for (unsigned int d = 0; d < 3; ++d)
      x[d] += amplitude * std::sin(mode * phase[d]) *
              std::cos(phase[(d + 1) % 3] + mode) *
              std::cos(phase[(d + 2) % 3]);
  }
  return result;
}

/// Moves nodes that are inside at random.
inline dealii::AlignedVector<double>
shaken(const Slab &slab, const double amplitude, const unsigned int seed = 0)
{
  auto result = slab.space.positions(ale::node_width);
  double upper[3] = {0., 0., 0.};
  for (const auto &vertex : slab.mesh.get_vertices())
    for (unsigned int d = 0; d < 3; ++d)
      upper[d] = std::max(upper[d], vertex[d]);
  for (std::size_t n = 0; n < slab.space.n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
    {
      double &x = result[ale::node_width * n + d];
      const double wild =
        43758.5453 *
        std::sin(12.9898 * slab.space.node_number(n) + 78.233 * d + 3.7 * seed);
      if (x > 1e-9 && x < upper[d] - 1e-9)
        x += amplitude * (2. * (wild - std::floor(wild)) - 1.);
    }
  return result;
}

/// Mean of a function over a cell, at eight Gauss points; exact if it is
/// linear.
inline double
mean_of(const Slab &slab,
        const std::size_t cell,
        const std::function<double(const dealii::Point<3> &)> &function)
{
  const auto x = to_modes(slab.corners(cell));
  const double gauss = 0.577350269189625764509;
  double sum = 0., volume = 0.;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const Vector3<double> p{
      {i & 1 ? gauss : -gauss, i & 2 ? gauss : -gauss, i & 4 ? gauss : -gauss}};
    const double weight = jacobian(x, p);
    const auto place = hex_position(x, p);
    sum += weight * function({place[0], place[1], place[2]});
    volume += weight;
  }
  return sum / volume;
}

} // namespace contrecoup
