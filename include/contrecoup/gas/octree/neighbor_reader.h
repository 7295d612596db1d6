// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/gas/octree/leaf_layout.h>

#include <array>
#include <cstdint>
#include <type_traits>

#if CONTRECOUP_LANE_BITS == 512
#  include <immintrin.h>
#endif

namespace contrecoup::gas
{
/**
 * Reads the values of the neighbours of a batch, one leaf per lane. In Morton
 * order the neighbours lie in two or three batches; loading these whole and
 * permuting lanes (AVX-512) is several times faster than a gather per value.
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
      lane_[lane] = leaves[lane] % width;
      const std::size_t source = offset_[lane] - lane_[lane];
      unsigned int s = 0;
      while (s < n_sources_ && source_[s] != source)
        ++s;
      if (s == n_sources_)
      {
        source_[n_sources_++] = source;
        mask_[s] = 0;
      }
      mask_[s] |= 1U << lane;
    }
  }

  /// Values of all lanes for the component and point whose value of leaf 0 is
  /// at address @p at.
  Lanes<Real> read(const Real *at) const
  {
    Lanes<Real> result;
#if CONTRECOUP_LANE_BITS == 512
    const __m512i lanes = _mm512_load_si512(lane_.data());
    if constexpr (sizeof(Real) == 4)
    {
      result.data = _mm512_setzero_ps();
      for (unsigned int s = 0; s < n_sources_; ++s)
        result.data =
          _mm512_mask_permutexvar_ps(result.data,
                                     static_cast<__mmask16>(mask_[s]),
                                     lanes,
                                     _mm512_loadu_ps(at + source_[s]));
    }
    else
    {
      result.data = _mm512_setzero_pd();
      for (unsigned int s = 0; s < n_sources_; ++s)
        result.data =
          _mm512_mask_permutexvar_pd(result.data,
                                     static_cast<__mmask8>(mask_[s]),
                                     lanes,
                                     _mm512_loadu_pd(at + source_[s]));
    }
#else
    for (unsigned int lane = 0; lane < width; ++lane)
      result[lane] = at[offset_[lane]];
#endif
    return result;
  }

private:
  /// Unsigned integer of the size of Real.
  using Index =
    std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;

  /// Lane of each leaf in its batch
  alignas(64) std::array<Index, width> lane_{};
  std::array<std::size_t, width> offset_{}; ///< offset of each leaf
  unsigned int n_sources_ = 0;
  std::array<std::size_t, width> source_{}; ///< offsets of distinct batches
  std::array<unsigned int, width> mask_{};  ///< lanes filled by each batch
};
} // namespace contrecoup::gas
