// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <algorithm>
#include <cmath>

/**
 * @file
 * Lane operations beyond deal.II's arithmetic: selection by comparison, tests
 * of all lanes of a group, and extrema over lanes. Each function also accepts
 * a plain double or float, so that kernels work on both.
 */

namespace contrecoup
{
/// A group of SIMD lanes of any width.
template <typename Scalar, std::size_t width>
using LaneGroup = dealii::VectorizedArray<Scalar, width>;

/// Lane by lane a < b ? if_true : if_false; a NaN counts as not less.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number select_less(const Number &a,
                                                const Number &b,
                                                const Number &if_true,
                                                const Number &if_false)
{
  return dealii::compare_and_apply_mask<dealii::SIMDComparison::less_than>(
    a, b, if_true, if_false);
}

/// Whether a < b, for lanes in at least one. A NaN is never less.
inline DEAL_II_ALWAYS_INLINE bool any_less(const double a, const double b)
{
  return a < b;
}

inline DEAL_II_ALWAYS_INLINE bool any_less(const float a, const float b)
{
  return a < b;
}

template <typename Scalar, std::size_t width>
inline DEAL_II_ALWAYS_INLINE bool any_less(const LaneGroup<Scalar, width> &a,
                                           const LaneGroup<Scalar, width> &b)
{
  bool result = false;
  for (unsigned int lane = 0; lane < width; ++lane)
    result = result || (a[lane] < b[lane]);
  return result;
}

#ifdef __AVX512F__
inline DEAL_II_ALWAYS_INLINE bool any_less(const LaneGroup<double, 8> &a,
                                           const LaneGroup<double, 8> &b)
{
  return _mm512_cmp_pd_mask(a.data, b.data, _CMP_LT_OQ) != 0;
}

inline DEAL_II_ALWAYS_INLINE bool any_less(const LaneGroup<float, 16> &a,
                                           const LaneGroup<float, 16> &b)
{
  return _mm512_cmp_ps_mask(a.data, b.data, _CMP_LT_OQ) != 0;
}
#elif defined(__AVX__)
inline DEAL_II_ALWAYS_INLINE bool any_less(const LaneGroup<double, 4> &a,
                                           const LaneGroup<double, 4> &b)
{
  return _mm256_movemask_pd(_mm256_cmp_pd(a.data, b.data, _CMP_LT_OQ)) != 0;
}

inline DEAL_II_ALWAYS_INLINE bool any_less(const LaneGroup<float, 8> &a,
                                           const LaneGroup<float, 8> &b)
{
  return _mm256_movemask_ps(_mm256_cmp_ps(a.data, b.data, _CMP_LT_OQ)) != 0;
}
#endif

/// Whether a > b in every lane; false if any lane holds a NaN.
inline DEAL_II_ALWAYS_INLINE bool all_greater(const double a, const double b)
{
  return a > b;
}

inline DEAL_II_ALWAYS_INLINE bool all_greater(const float a, const float b)
{
  return a > b;
}

template <typename Scalar, std::size_t width>
inline DEAL_II_ALWAYS_INLINE bool all_greater(const LaneGroup<Scalar, width> &a,
                                              const LaneGroup<Scalar, width> &b)
{
  using Group = LaneGroup<Scalar, width>;
  return !any_less(select_less(b, a, Group(0.), Group(1.)) * Scalar(-1.),
                   Group(0.));
}

/// Smallest value over the lanes.
inline DEAL_II_ALWAYS_INLINE double smallest_lane(const double a)
{
  return a;
}

inline DEAL_II_ALWAYS_INLINE float smallest_lane(const float a)
{
  return a;
}

template <typename Scalar, std::size_t width>
inline DEAL_II_ALWAYS_INLINE Scalar
smallest_lane(const LaneGroup<Scalar, width> &a)
{
  Scalar result = a[0];
  for (unsigned int lane = 1; lane < width; ++lane)
    result = std::min(result, a[lane]);
  return result;
}

/// Largest value over the lanes.
inline DEAL_II_ALWAYS_INLINE double largest_lane(const double a)
{
  return a;
}

inline DEAL_II_ALWAYS_INLINE float largest_lane(const float a)
{
  return a;
}

template <typename Scalar, std::size_t width>
inline DEAL_II_ALWAYS_INLINE Scalar
largest_lane(const LaneGroup<Scalar, width> &a)
{
  return -smallest_lane(-a);
}
} // namespace contrecoup
