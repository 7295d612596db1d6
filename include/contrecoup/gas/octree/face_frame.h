// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

#include <deal.II/base/tensor.h>

#include <array>

namespace contrecoup::gas
{
/// Orthonormal basis of a face: its normal, then the tangents.
template <int dim, typename Number>
struct FaceFrame
{
  std::array<dealii::Tensor<1, dim, Number>, dim> axes;
  Number area; ///< [m^(dim-1)]

  /// Computes the basis from a non-zero area vector, without branches. The
  /// tangents change with the normal's sign (Duff et al. 2017, J. Comput.
  /// Graph. Techn. 6, 1).
  explicit FaceFrame(const dealii::Tensor<1, dim, Number> &area_vector)
    : area(std::sqrt(area_vector * area_vector))
  {
    const auto &n = axes[0] = area_vector * (Number(1.) / area);
    if constexpr (dim == 2)
    {
      axes[1][0] = -n[1];
      axes[1][1] = n[0];
    }
    else
    {
      const Number one(1.), zero(0.);
      const Number sign = select_less(n[2], zero, Number(-1.), one);
      const Number a = -one / (sign + n[2]);
      const Number b = n[0] * n[1] * a;
      axes[1][0] = one + sign * n[0] * n[0] * a;
      axes[1][1] = sign * b;
      axes[1][2] = -sign * n[0];
      axes[2][0] = b;
      axes[2][1] = sign + n[1] * n[1] * a;
      axes[2][2] = -n[1];
    }
  }
};
} // namespace contrecoup::gas
