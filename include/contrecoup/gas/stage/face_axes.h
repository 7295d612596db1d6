// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/face_frame.h>
#include <contrecoup/gas/state/primitive.h>

namespace contrecoup::gas
{
/// Orthonormal axes of a face of any kind of mesh, its normal first, and how
/// vectors among primitive values and fluxes are turned to them and back.
template <int dim, typename Number>
class FaceAxes
{
public:
  using Vector = dealii::Tensor<1, dim, Number>;
  using C = Component<dim>;

  FaceAxes() = default;

  /// A face across coordinate direction @p direction.
  FaceAxes(const unsigned int direction, const Number &area)
    : area(area)
    , direction_(direction)
  {}

  /// A face with this area vector, which must not be zero.
  explicit FaceAxes(const Vector &area_vector)
    : direction_(dim)
  {
    if constexpr (dim > 1)
    {
      const FaceFrame<dim, Number> frame(area_vector);
      axes_ = frame.axes;
      area = frame.area;
    }
  }

  /// Turns the velocity of primitive values, or the momentum of a flux, from
  /// the coordinate axes to those of the face.
  template <typename Values>
  DEAL_II_ALWAYS_INLINE Values to(const Values &values) const
  {
    Values result = values;
    for (unsigned int d = 0; d < dim; ++d)
      if (direction_ < dim)
        result[C::momentum + d] = values[C::momentum + (direction_ + d) % dim];
      else
      {
        result[C::momentum + d] = values[C::momentum] * axes_[d][0];
        for (unsigned int e = 1; e < dim; ++e)
          result[C::momentum + d] += values[C::momentum + e] * axes_[d][e];
      }
    return result;
  }

  /// Turns them from the axes of the face to the coordinate axes.
  template <typename Values>
  DEAL_II_ALWAYS_INLINE Values from(const Values &values) const
  {
    Values result = values;
    for (unsigned int d = 0; d < dim; ++d)
      if (direction_ < dim)
        result[C::momentum + (direction_ + d) % dim] = values[C::momentum + d];
      else
      {
        result[C::momentum + d] = values[C::momentum] * axes_[0][d];
        for (unsigned int e = 1; e < dim; ++e)
          result[C::momentum + d] += values[C::momentum + e] * axes_[e][d];
      }
    return result;
  }

  Number area; ///< [m^(dim-1)]

private:
  unsigned int direction_ = 0; ///< dim: none
  std::array<Vector, dim> axes_;
};
} // namespace contrecoup::gas
