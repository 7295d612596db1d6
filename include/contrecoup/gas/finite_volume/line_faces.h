// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/octree/radial_weights.h>

/**
 * @file
 * Geometries of a line of subcells, as policies of sweep_line(). Each computes
 * the rate of change of subcell i from the fluxes through its low and high
 * face, says whether slopes end at closed faces, and whether the pressure of
 * the subcell itself is subtracted from the fluxes: it exerts no net force on
 * the subcell, and without it a gas at rest keeps every bit where face areas
 * differ.
 */

namespace contrecoup::gas
{
/// Equal subcells between faces of equal area.
template <typename Number>
struct BoxFaces
{
  static constexpr bool closes_slopes = false;
  static constexpr bool takes_own_pressure = false;

  Number inverse_size; ///< of a subcell along the line [1/m]

  DEAL_II_ALWAYS_INLINE Number rate(const unsigned int,
                                    const Number &low,
                                    const Number &high) const
  {
    return (low - high) * inverse_size;
  }
};


/// Subcells along the radius of curvilinear geometry.
template <typename Number>
struct RadialFaces
{
  static constexpr bool closes_slopes = false;
  static constexpr bool takes_own_pressure = true;

  const RadialWeights *weights;

  /// Pressure to subtract where a subcell has the pressure @p own [Pa].
  DEAL_II_ALWAYS_INLINE Number subtracted(const Number &own) const
  {
    return own;
  }

  DEAL_II_ALWAYS_INLINE Number rate(const unsigned int i,
                                    const Number &low,
                                    const Number &high) const
  {
    return (low * weights->area(i) - high * weights->area(i + 1)) *
           weights->inverse_volume(i);
  }
};


/// Subcells in a batch with leaves that a rigid body cuts. In plane geometry
/// the other leaves get the rates of BoxFaces to the last bit: which leaves
/// share a batch depends on the ranks.
template <typename Number>
struct CutFaces
{
  static constexpr bool closes_slopes = true;
  static constexpr bool takes_own_pressure = true;

  /// Open fraction of the first face, those of the next ones @p stride further.
  const Number *opening;
  unsigned int stride;
  /// Open fraction of the faces between the two subcells beyond each end.
  std::array<const Number *, 2> beyond;
  Number inverse_size;      ///< of a subcell along the line [1/m]
  Number has_unequal_areas; ///< one in lanes where face areas differ, or zero
  const RadialWeights *weights = nullptr; ///< along the radius; else null

  DEAL_II_ALWAYS_INLINE Number subtracted(const Number &own) const
  {
    return own * has_unequal_areas;
  }

  /// One where the face between subcells i - 1 and i is open, else zero.
  DEAL_II_ALWAYS_INLINE Number is_open(const int i, const int n) const
  {
    const Number &fraction =
      i < 0 ? *beyond[0] : (i > n ? *beyond[1] : opening[i * stride]);
    return select_less(Number(0.), fraction, Number(1.), Number(0.));
  }

  DEAL_II_ALWAYS_INLINE Number rate(const unsigned int i,
                                    const Number &low,
                                    const Number &high) const
  {
    Number low_area = opening[i * stride];
    Number high_area = opening[(i + 1) * stride];
    if constexpr (std::is_same_v<Number, RadialWeights::Number>)
      if (weights != nullptr)
      {
        low_area *= weights->area(i);
        high_area *= weights->area(i + 1);
        return (low * low_area - high * high_area) * weights->inverse_volume(i);
      }
    return (low * low_area - high * high_area) * inverse_size;
  }
};
} // namespace contrecoup::gas
