// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace contrecoup
{
namespace internal
{
  /// Constants of exponential() for a floating point type. q is the polynomial
  /// in exp(r) = 1 + r + r^2 q(r), interpolated at the Chebyshev points of |r|
  /// <= ln(2)/2.
  template <typename Scalar>
  struct ExponentialConstants;

  template <>
  struct ExponentialConstants<double>
  {
    using Bits = std::uint64_t;
    static constexpr unsigned int mantissa = 52;
    static constexpr Bits bias = 1023;
    static constexpr double shifter = 6755399441055744.;
    static constexpr double ln2_high = 0.69314718055989033019;
    static constexpr double ln2_low = 5.4979230187083711475e-14;
    static constexpr double lowest = -708.;
    static constexpr double highest = 709.78;
    static constexpr std::array<double, 10> q{{0.50000000000000010211,
                                               0.16666666666666667452,
                                               0.041666666666624161562,
                                               0.0083333333333300644233,
                                               0.0013888888917196889013,
                                               1.9841269863040675954e-4,
                                               2.4801521322104589362e-5,
                                               2.7557268480106926117e-6,
                                               2.7620076005631384148e-7,
                                               2.5100375929185923816e-8}};
  };

  template <>
  struct ExponentialConstants<float>
  {
    using Bits = std::uint32_t;
    static constexpr unsigned int mantissa = 23;
    static constexpr Bits bias = 127;
    static constexpr float shifter = 12582912.f;
    static constexpr float ln2_high = 0.693145751953125f;
    static constexpr float ln2_low = 1.4286068203094172e-6f;
    static constexpr float lowest = -87.f;
    static constexpr float highest = 88.72f;
    static constexpr std::array<float, 6> q{{0.500000001346f,
                                             0.166666666816f,
                                             0.0416664650520f,
                                             0.00833331093436f,
                                             0.00139336411216f,
                                             1.98909809693e-4f}};
  };
} // namespace internal

/// exp(x) of a scalar.
inline double exponential(const double x)
{
  return std::exp(x);
}

inline float exponential(const float x)
{
  return std::exp(x);
}

/**
 * exp(x) in every lane, to about one unit in the last place: x = n ln(2) + r
 * (Cody and Waite 1980), a polynomial in r, and n added to the exponent bits.
 * Results below 3e-308 (float: 2e-38) are flushed to 0; the overflow result is
 * infinity.
 */
template <typename Scalar, std::size_t width>
inline DEAL_II_ALWAYS_INLINE LaneGroup<Scalar, width>
exponential(const LaneGroup<Scalar, width> &x)
{
  using Constants = internal::ExponentialConstants<Scalar>;
  using Bits = typename Constants::Bits;
  using Group = LaneGroup<Scalar, width>;

  const Group lowest(Constants::lowest), highest(Constants::highest);
  const Group bounded = std::min(std::max(x, lowest), highest);
  const Group shifted =
    bounded * Scalar(1.4426950408889634074) + Constants::shifter;
  const Group n = shifted - Constants::shifter;
  const Group r = (bounded - n * Constants::ln2_high) - n * Constants::ln2_low;

  Group sum(Constants::q.back());
  for (std::size_t i = Constants::q.size() - 1; i > 0; --i)
    sum = sum * r + Constants::q[i - 1];
  const Group mantissa = (sum * (r * r) + r) + Scalar(1.);

  // The last bits of the shifted value hold n; this builds 2^(n-1).
  std::array<Bits, width> bits;
  static_assert(sizeof(bits) == sizeof(shifted.data), "lanes are packed");
  std::memcpy(&bits, &shifted.data, sizeof(bits));
  for (Bits &value : bits)
    value = (value + (Constants::bias - 1)) << Constants::mantissa;
  Group power;
  std::memcpy(&power.data, &bits, sizeof(bits));

  const Group result = (mantissa + mantissa) * power;
  return select_less(
    x,
    lowest,
    Group(0.),
    select_less(
      highest, x, Group(std::numeric_limits<Scalar>::infinity()), result));
}
} // namespace contrecoup
