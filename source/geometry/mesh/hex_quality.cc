// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/hex_quality.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Neighbours of each corner along its three edges, right-handed.
  constexpr std::array<std::array<unsigned int, 3>, 8> corner_edges{
    {{{1, 3, 4}},
     {{2, 0, 5}},
     {{3, 1, 6}},
     {{0, 2, 7}},
     {{7, 5, 0}},
     {{4, 6, 1}},
     {{5, 7, 2}},
     {{6, 4, 3}}}};

  constexpr std::array<std::array<unsigned int, 4>, 6> faces{{{{0, 4, 7, 3}},
                                                              {{1, 2, 6, 5}},
                                                              {{0, 1, 5, 4}},
                                                              {{3, 7, 6, 2}},
                                                              {{0, 3, 2, 1}},
                                                              {{4, 5, 6, 7}}}};

  double determinant(const Tensor<1, 3> &a,
                     const Tensor<1, 3> &b,
                     const Tensor<1, 3> &c)
  {
    return a * cross_product_3d(b, c);
  }
} // namespace

double scaled_jacobian(const HexCorners &corners)
{
  double least = 1.;
  for (unsigned int c = 0; c < 8; ++c)
  {
    const auto &ends = corner_edges[c];
    const Tensor<1, 3> a = corners[ends[0]] - corners[c];
    const Tensor<1, 3> b = corners[ends[1]] - corners[c];
    const Tensor<1, 3> d = corners[ends[2]] - corners[c];
    const double lengths =
      std::sqrt(a.norm_square() * b.norm_square() * d.norm_square());
    least = std::min(least, lengths > 0. ? determinant(a, b, d) / lengths : 0.);
  }
  return least;
}

double volume(const HexCorners &x)
{
  // Divergence theorem: a third of the flux of the position through the faces
  // x(u, v) = a + b u + c v + d u v, integrated exactly.
  double flux = 0.;
  for (const auto &face : faces)
  {
    const Tensor<1, 3> &a = x[face[0]];
    const Tensor<1, 3> b = x[face[1]] - x[face[0]];
    const Tensor<1, 3> c = x[face[3]] - x[face[0]];
    const Tensor<1, 3> d = (x[face[2]] - x[face[3]]) - b;
    flux += determinant(a, b, c) +
            0.5 * (determinant(a, b, d) + determinant(a, d, c)) -
            0.25 * determinant(d, b, c);
  }
  return flux / 3.;
}

double characteristic_length(const HexCorners &corners)
{
  double largest = 0.;
  for (const auto &face : faces)
  {
    const Tensor<1, 3> area =
      0.5 * cross_product_3d(corners[face[2]] - corners[face[0]],
                             corners[face[3]] - corners[face[1]]);
    largest = std::max(largest, area.norm());
  }
  return largest > 0. ? volume(corners) / largest : 0.;
}

std::vector<HexQuality> measure_quality(const HexMesh &mesh)
{
  std::vector<HexQuality> parts(mesh.parts.size());
  HexCorners corners;
  for (std::size_t i = 0; i < mesh.cells.size(); ++i)
  {
    Point<3> center;
    for (unsigned int c = 0; c < 8; ++c)
    {
      corners[c] = mesh.nodes[mesh.cells[i][c]];
      center += Tensor<1, 3>(corners[c]) / 8.;
    }
    HexQuality one;
    one.n_cells = 1;
    one.volume = volume(corners);
    one.first_moment = Point<3>(one.volume * center);
    one.smallest_scaled_jacobian = one.mean_scaled_jacobian =
      scaled_jacobian(corners);
    one.shortest_length = characteristic_length(corners);
    one.shortest_edge = std::numeric_limits<double>::max();
    for (const auto &edge : hex_edges)
    {
      const double length = corners[edge[0]].distance(corners[edge[1]]);
      one.shortest_edge = std::min(one.shortest_edge, length);
      one.longest_edge = std::max(one.longest_edge, length);
    }
    HexQuality &sum = parts[mesh.part[i]];
    sum = sum + one;
  }
  return parts;
}

HexQuality operator+(const HexQuality &a, const HexQuality &b)
{
  if (a.n_cells == 0)
    return b;
  if (b.n_cells == 0)
    return a;
  HexQuality sum;
  sum.n_cells = a.n_cells + b.n_cells;
  sum.volume = a.volume + b.volume;
  sum.first_moment = a.first_moment + Tensor<1, 3>(b.first_moment);
  sum.smallest_scaled_jacobian =
    std::min(a.smallest_scaled_jacobian, b.smallest_scaled_jacobian);
  const double share = static_cast<double>(b.n_cells) / sum.n_cells;
  sum.mean_scaled_jacobian =
    a.mean_scaled_jacobian +
    share * (b.mean_scaled_jacobian - a.mean_scaled_jacobian);
  sum.shortest_edge = std::min(a.shortest_edge, b.shortest_edge);
  sum.longest_edge = std::max(a.longest_edge, b.longest_edge);
  sum.shortest_length = std::min(a.shortest_length, b.shortest_length);
  return sum;
}
} // namespace contrecoup
