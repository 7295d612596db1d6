// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_mesh.h>

#include <cstddef>

namespace contrecoup::gas
{
/**
 * Memory layout of the values of leaves. A leaf has n points per direction;
 * point (i, j, k) has index i + n (j + n k). A batch is stored as
 * [component][point][lane], one leaf per lane, so that arithmetic on lanes
 * needs no shuffles.
 */
struct LeafLayout
{
  LeafLayout() = default;
  LeafLayout(const unsigned int dim,
             const unsigned int n,
             const unsigned int n_components,
             const Precision precision = Precision::double_precision);

  unsigned int n = 1;             ///< points per direction
  unsigned int n_points = 1;      ///< points of a leaf, n^dim
  unsigned int n_face_points = 1; ///< points of a leaf face, n^(dim-1)
  unsigned int n_components = 1;  ///< conserved quantities
  Precision precision = Precision::double_precision; ///< of the stored values
  unsigned int width = double_width; ///< leaves per batch, a power of two
  unsigned int width_bits = floor_log2(double_width); ///< log2(width)

  /// Largest k with 2^k <= x.
  static constexpr unsigned int floor_log2(const unsigned int x)
  {
    return x < 2 ? 0 : 1 + floor_log2(x / 2);
  }

  /// Number of values of a batch, all lanes.
  std::size_t batch_size() const
  {
    return std::size_t(n_components) * n_points * width;
  }

  /// Index of component 0, point 0 of a leaf.
  std::size_t offset(const unsigned int leaf) const
  {
    return (leaf >> width_bits) * batch_size() + (leaf & (width - 1));
  }

  /// Index of a value relative to offset().
  std::size_t value(const unsigned int component,
                    const unsigned int point) const
  {
    return (std::size_t(component) * n_points + point) * width;
  }

  /// Difference of the point indices of neighbours in a direction.
  unsigned int stride(const unsigned int direction) const
  {
    return direction == 0 ? 1 : (direction == 1 ? n : n * n);
  }

  /// Index of the point at distance @p depth (in points) from face @p face,
  /// above face point @p q.
  unsigned int face_point(const unsigned int face,
                          const unsigned int q,
                          const unsigned int depth) const
  {
    const unsigned int direction = face / 2;
    const unsigned int layer = face % 2 ? n - 1 - depth : depth;
    const unsigned int s = stride(direction);
    return q % s + layer * s + (q / s) * s * n;
  }
};
} // namespace contrecoup::gas
