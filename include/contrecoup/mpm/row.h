// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <array>

namespace contrecoup::mpm
{
/// Values at four neighbouring nodes along x, the support of a cubic spline, in
/// SIMD vectors of at most four lanes.
class Row
{
public:
  static constexpr unsigned int width =
    n_lanes<double> < 4 ? n_lanes<double> : 4;
  static constexpr unsigned int n_vectors = 4 / width;
  using Vector = dealii::VectorizedArray<double, width>;

  Row() = default;

  explicit DEAL_II_ALWAYS_INLINE Row(const double value)
  {
    for (unsigned int i = 0; i < n_vectors; ++i)
      vectors_[i] = value;
  }

  /// Loads four values of any alignment.
  static DEAL_II_ALWAYS_INLINE Row load(const double *const values)
  {
    Row row;
    for (unsigned int i = 0; i < n_vectors; ++i)
      row.vectors_[i].load(values + width * i);
    return row;
  }

  DEAL_II_ALWAYS_INLINE void store(double *const values) const
  {
    for (unsigned int i = 0; i < n_vectors; ++i)
      vectors_[i].store(values + width * i);
  }

  friend DEAL_II_ALWAYS_INLINE Row operator*(const Row &a, const Row &b)
  {
    Row row;
    for (unsigned int i = 0; i < n_vectors; ++i)
      row.vectors_[i] = a.vectors_[i] * b.vectors_[i];
    return row;
  }
  friend DEAL_II_ALWAYS_INLINE Row operator*(const Row &a, const double factor)
  {
    return a * Row(factor);
  }

  /// Adds factor * other.
  DEAL_II_ALWAYS_INLINE void add(const Row &other, const double factor)
  {
    for (unsigned int i = 0; i < n_vectors; ++i)
      vectors_[i] += other.vectors_[i] * Vector(factor);
  }

  /// Dot product with another row.
  DEAL_II_ALWAYS_INLINE double dot(const Row &other) const
  {
    Vector sum = vectors_[0] * other.vectors_[0];
    for (unsigned int i = 1; i < n_vectors; ++i)
      sum += vectors_[i] * other.vectors_[i];
    double result = 0.;
    for (unsigned int lane = 0; lane < width; ++lane)
      result += sum[lane];
    return result;
  }

private:
  std::array<Vector, n_vectors> vectors_;
};

/// Adds factor * row to four neighbouring nodes.
inline DEAL_II_ALWAYS_INLINE void
add_to(double *const node, const Row &row, const double factor)
{
  Row sum = Row::load(node);
  sum.add(row, factor);
  sum.store(node);
}

/// Adds two rows with their factors to four neighbouring nodes.
inline DEAL_II_ALWAYS_INLINE void add_to(double *const node,
                                         const Row &row,
                                         const double factor,
                                         const Row &other,
                                         const double other_factor)
{
  Row sum = Row::load(node);
  sum.add(row, factor);
  sum.add(other, other_factor);
  sum.store(node);
}
} // namespace contrecoup::mpm
