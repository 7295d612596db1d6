// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Face areas and subcell volumes along the radius for n equal subcells, per
 * unit angle (and length): A = r^m and V = (r_+^(m+1) - r_-^(m+1)) / (m+1), m
 * the radial exponent of the geometry. Both are exact, so that constant
 * pressure at rest stays constant when the pressure force is p (A_+ - A_-).
 */
class RadialWeights
{
public:
  using Number = Lanes<double>;

  RadialWeights(const unsigned int exponent, const unsigned int n)
    : exponent_(exponent)
    , area_(n + 1)
    , inverse_volume_(n)
  {}

  bool is_plane() const
  {
    return exponent_ == 0;
  }

  /// Computes the weights of leaves with inner radius @p inner [m] and radial
  /// edge length @p extent [m].
  void reinit(const Number &inner, const Number &extent)
  {
    const unsigned int n = inverse_volume_.size();
    for (unsigned int i = 0; i <= n; ++i)
    {
      const Number r = inner + extent * (double(i) / n);
      area_[i] = exponent_ == 2 ? r * r : r;
    }
    for (unsigned int i = 0; i < n; ++i)
    {
      const Number a = inner + extent * (double(i) / n);
      const Number b = inner + extent * (double(i + 1) / n);
      // b^(m+1) - a^(m+1) factored, free of cancellation.
      const Number mean =
        exponent_ == 2 ? (a * a + a * b + b * b) * (1. / 3.) : (a + b) * .5;
      inverse_volume_[i] = Number(1.) / (mean * (b - a));
    }
  }

  const Number &area(const unsigned int face) const
  {
    return area_[face];
  }
  const Number &inverse_volume(const unsigned int cell) const
  {
    return inverse_volume_[cell];
  }

private:
  unsigned int exponent_;
  dealii::AlignedVector<Number> area_;
  dealii::AlignedVector<Number> inverse_volume_;
};
} // namespace contrecoup::gas
