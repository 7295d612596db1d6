// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_geometry.h>

#include <random>

namespace contrecoup
{
using Corners = HexVectors<double>;

/// Vectors at the corners, each component up to an amplitude.
inline Corners random_field(const unsigned int seed, const double amplitude)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-amplitude, amplitude);
  Corners u;
  for (auto &corner : u)
    for (double &component : corner)
      component = value(generator);
  return u;
}

/// A unit cube whose corners moved at random.
inline Corners random_hexahedron(const unsigned int seed,
                                 const double amplitude = 0.2)
{
  Corners x = random_field(seed, amplitude);
  for (unsigned int c = 0; c < 8; ++c)
  {
    x[c][0] += (c + 1) / 2 % 2;
    x[c][1] += c / 2 % 2;
    x[c][2] += c / 4;
  }
  return x;
}

inline Corners unit_cube()
{
  return random_hexahedron(0, 0.);
}
} // namespace contrecoup
