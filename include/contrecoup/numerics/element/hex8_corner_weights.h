// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/hex8_geometry.h>

namespace contrecoup
{
/// Integrals of the corners' trilinear shape functions over a hexahedron,
/// divided by its volume: 1/8 in a brick, less at the narrow side of a wedge
/// [-].
inline std::array<double, 8>
hex_corner_weights(const HexVectors<double> &corners)
{
  constexpr double gauss = 0.577350269189625764509;
  constexpr std::array<std::array<double, 3>, 8> sign{{{{-1., -1., -1.}},
                                                       {{1., -1., -1.}},
                                                       {{1., 1., -1.}},
                                                       {{-1., 1., -1.}},
                                                       {{-1., -1., 1.}},
                                                       {{1., -1., 1.}},
                                                       {{1., 1., 1.}},
                                                       {{-1., 1., 1.}}}};
  const HexVectors<double> modes = to_modes(corners);
  std::array<double, 8> weights{};
  double volume = 0.;
  // Exact: the integrand has at most degree three in each direction.
  for (const auto &node : sign)
  {
    const Vector3<double> p{
      {gauss * node[0], gauss * node[1], gauss * node[2]}};
    const double weight = jacobian(modes, p);
    volume += weight;
    for (unsigned int i = 0; i < 8; ++i)
      weights[i] += 0.125 * weight * (1. + sign[i][0] * p[0]) *
                    (1. + sign[i][1] * p[1]) * (1. + sign[i][2] * p[2]);
  }
  for (double &corner_weight : weights)
    corner_weight /= volume;
  return weights;
}
} // namespace contrecoup
