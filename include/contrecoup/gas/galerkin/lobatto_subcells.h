// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/scheme/limiters.h>

#include <deal.II/base/quadrature_lib.h>

#include <vector>

namespace contrecoup::gas
{
/// The subcells of a line of Gauss-Lobatto nodes, on which finite volumes work
/// in troubled leaves: one around each node, as wide as its quadrature weight.
/// Lengths are relative to the leaf's edge.
struct LobattoSubcells
{
  explicit LobattoSubcells(const unsigned int n)
    : n(n)
    , weight(dealii::QGaussLobatto<1>(n).get_weights())
    , face(1, 0.)
  {
    for (unsigned int i = 0; i < n; ++i)
    {
      face.push_back(face[i] + weight[i]);
      center.push_back(0.5 * (face[i] + face[i + 1]));
    }
    for (unsigned int i = 0; i <= n; ++i)
      inverse_distance.push_back(
        1. / (i % n == 0 ? 2. * center[0] : center[i] - center[i - 1]));
    for (unsigned int i = 0; i < n; ++i)
      slope_weights.emplace_back(1. / inverse_distance[i],
                                 1. / inverse_distance[i + 1],
                                 0.5 * weight[i],
                                 0.5 * weight[i]);
  }

  unsigned int n;
  std::vector<double> weight;
  std::vector<double> face;   ///< ends of the subcells
  std::vector<double> center; ///< of each subcell, where its value stands
  /// From the centre before to that of subcell i, likewise behind the last.
  std::vector<double> inverse_distance;
  std::vector<SlopeWeights> slope_weights;
};
} // namespace contrecoup::gas
