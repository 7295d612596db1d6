// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/gas/octree/leaf_layout.h>

#include <array>
#include <cstdint>
#include <type_traits>

#ifdef __AVX2__
#  include <immintrin.h>
#endif

namespace contrecoup::gas
{
/**
 * Reads the values of the neighbours of a batch, one leaf per lane. In Morton
 * order the neighbours lie in two or three batches; loading these whole and
 * permuting lanes (AVX-512, AVX2) is several times faster than a gather per
 * value.
 */
template <typename Real>
class NeighborReader
{
public:
  static constexpr unsigned int width = n_lanes<Real>;

  /// @param leaves width leaf numbers, one per lane
  void reinit(const unsigned int *leaves, const LeafLayout &layout)
  {
    n_sources_ = 0;
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      offset_[lane] = layout.offset(leaves[lane]);
      const unsigned int from = leaves[lane] % width;
      const std::size_t source = offset_[lane] - from;
      unsigned int s = 0;
      while (s < n_sources_ && source_[s] != source)
        ++s;
      if (s == n_sources_)
        add_source(source);
      take(s, lane, from);
    }
  }

  /// Values of all lanes for the component and point whose value of leaf 0 is
  /// at address @p at.
  Lanes<Real> read(const Real *at) const
  {
    std::array<Lanes<Real>, 1> result;
    read(at, 0, result);
    return result[0];
  }

  /// Values of consecutive components, @p stride numbers apart in memory.
  template <std::size_t n>
  DEAL_II_ALWAYS_INLINE void read(const Real *at,
                                  const std::size_t stride,
                                  std::array<Lanes<Real>, n> &result) const
  {
#ifdef __AVX2__
    for (std::size_t c = 0; c < n; ++c)
      result[c] = Lanes<Real>(0.);
    for (unsigned int s = 0; s < n_sources_; ++s)
      for (std::size_t c = 0; c < n; ++c)
        put(s, at + source_[s] + c * stride, result[c]);
#else
    for (std::size_t c = 0; c < n; ++c)
      for (unsigned int lane = 0; lane < width; ++lane)
        result[c][lane] = at[offset_[lane] + c * stride];
#endif
  }

  /// Prefetches into the cache what read() will read: @p n numbers from the
  /// address @p at of leaf 0 on, in all batches but that at offset @p own.
  DEAL_II_ALWAYS_INLINE void
  prefetch(const Real *at, const unsigned int n, const std::size_t own) const
  {
    constexpr unsigned int n_in_line = 64 / sizeof(Real);
    for (unsigned int s = 0; s < n_sources_; ++s)
      if (source_[s] != own)
        for (unsigned int i = 0; i < n; i += n_in_line)
          __builtin_prefetch(at + source_[s] + i);
  }

  /// Number of distinct batches that hold the leaves.
  unsigned int n_sources() const
  {
    return n_sources_;
  }
  /// Offset of one of these batches in the field.
  std::size_t source(const unsigned int s) const
  {
    return source_[s];
  }

private:
#if CONTRECOUP_LANE_BITS >= 512
  /// Unsigned integer of the size of Real.
  using Index =
    std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  using Mask = std::uint16_t;

  void add_source(const std::size_t source)
  {
    mask_[n_sources_] = 0;
    source_[n_sources_++] = source;
  }
  void
  take(const unsigned int s, const unsigned int lane, const unsigned int from)
  {
    lane_[lane] = from;
    mask_[s] |= Mask(1U << lane);
  }
  DEAL_II_ALWAYS_INLINE void
  put(const unsigned int s, const Real *values, Lanes<Real> &result) const
  {
    const __m512i lanes = _mm512_load_si512(lane_.data());
    if constexpr (sizeof(Real) == 4)
      result.data = _mm512_mask_permutexvar_ps(
        result.data, mask_[s], lanes, _mm512_loadu_ps(values));
    else
      result.data = _mm512_mask_permutexvar_pd(
        result.data, __mmask8(mask_[s]), lanes, _mm512_loadu_pd(values));
  }

  alignas(
    64) std::array<Index, width> lane_{}; ///< lane of each leaf in its batch
  std::array<Mask, width> mask_{};        ///< lanes filled by each batch
#elif defined(__AVX2__)
  /// Words of 32 bits, of which a number takes one or two.
  using Words = std::array<std::uint32_t, 8>;

  void add_source(const std::size_t source)
  {
    mask_[n_sources_] = Words{};
    source_[n_sources_++] = source;
  }
  void
  take(const unsigned int s, const unsigned int lane, const unsigned int from)
  {
    constexpr unsigned int n_words = sizeof(Real) / 4;
    for (unsigned int w = 0; w < n_words; ++w)
    {
      word_[n_words * lane + w] = n_words * from + w;
      mask_[s][n_words * lane + w] = 0xffffffffU;
    }
  }
  DEAL_II_ALWAYS_INLINE void
  put(const unsigned int s, const Real *values, Lanes<Real> &result) const
  {
    const __m256i words =
      _mm256_load_si256(reinterpret_cast<const __m256i *>(word_.data()));
    const __m256 mask =
      _mm256_load_ps(reinterpret_cast<const float *>(mask_[s].data()));
    if constexpr (sizeof(Real) == 4)
      result.data = _mm256_blendv_ps(
        result.data,
        _mm256_permutevar8x32_ps(_mm256_loadu_ps(values), words),
        mask);
    else
      result.data = _mm256_castps_pd(
        _mm256_blendv_ps(_mm256_castpd_ps(result.data),
                         _mm256_permutevar8x32_ps(
                           _mm256_castpd_ps(_mm256_loadu_pd(values)), words),
                         mask));
  }
  alignas(32) Words word_{}; ///< word that each lane's word is read from
  alignas(32) std::array<Words, width> mask_; ///< lanes filled by each batch
#else
  void add_source(const std::size_t source)
  {
    source_[n_sources_++] = source;
  }
  void take(const unsigned int, const unsigned int, const unsigned int)
  {}
#endif

  std::array<std::size_t, width> offset_{}; ///< offset of each leaf
  unsigned int n_sources_ = 0;
  std::array<std::size_t, width> source_{}; ///< offsets of distinct batches
};
} // namespace contrecoup::gas
