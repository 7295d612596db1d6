// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <contrecoup/numerics/element/hex8_one_point.h>
#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::solid
{
/// History variables of the elements, one entry per batch. Viscoelastic
/// batches store 6 components of relaxed strain for each integration point,
/// damped batches store 12 hourglass damping forces.
template <typename Lane>
struct HexMemory
{
  dealii::AlignedVector<Lane> dilatation;
  dealii::AlignedVector<Lane> viscous_pressure;
  /// empty without smoothing
  dealii::AlignedVector<Lane> smoothing_pressure, smooth_dilatation;
  dealii::AlignedVector<Lane> relaxed;
  dealii::AlignedVector<Lane> damping;
};

/**
 * The elements of this rank in batches of n elements of the same tissue, one
 * element per SIMD lane. Unused lanes of the last batch of a tissue hold a
 * padding cube, whose nodes follow those of the mesh and never move.
 */
template <typename Real>
class HexBatches : public HexMemory<Lanes<Real>>
{
public:
  using Lane = Lanes<Real>;
  using HexMemory<Lane>::dilatation;
  using HexMemory<Lane>::viscous_pressure;
  using HexMemory<Lane>::smoothing_pressure;
  using HexMemory<Lane>::smooth_dilatation;
  using HexMemory<Lane>::relaxed;
  using HexMemory<Lane>::damping;
  static constexpr unsigned int n = n_lanes<Real>;

  /// The batches of one tissue.
  struct Range
  {
    unsigned int tissue;
    unsigned int begin;
    unsigned int end;
    bool viscoelastic;
    unsigned int first_relaxed; ///< index of the first batch's relaxed strain
    bool damped;
    unsigned int first_damping; ///< index of the first batch's damping forces
    bool smoothed;              ///< whether pressures are smoothed
  };

  /// @param viscoelastic whether a tissue stores relaxed strains, by tissue
  /// @param damped whether a tissue has hourglass damping, by tissue
  /// @param smoothed whether pressures are smoothed, by tissue
  /// @param n_points number of integration points that store relaxed strains
  void reinit(const SolidMesh &mesh,
              const std::vector<bool> &viscoelastic,
              const std::vector<bool> &damped,
              const std::vector<bool> &smoothed,
              const unsigned int n_points);

  /// Sets the coordinates of the mesh nodes and of the padding cube's nodes.
  static void reinit_nodes(const SolidMesh &mesh, NodeFields<Real> &nodes);

  const std::vector<Range> &ranges() const
  {
    return ranges_;
  }

  unsigned int n_batches() const
  {
    return static_cast<unsigned int>(dilatation.size());
  }

  /// NodeFields::width times the node number of @p corner, for each lane.
  const unsigned int *offsets(const unsigned int batch,
                              const unsigned int corner) const
  {
    return &offsets_[(8 * batch + corner) * n];
  }

  /// The mesh cell in a lane, or `spare` for an unused lane.
  std::uint32_t cell(const unsigned int batch, const unsigned int lane) const
  {
    return cells_[batch * n + lane];
  }
  static constexpr std::uint32_t spare = -1;

  /// Position of a mesh cell: batch * n + lane.
  std::uint32_t slot(const std::uint32_t cell) const
  {
    return slots_[cell];
  }

  /// Memory of the elements without their nodes [bytes].
  double memory() const;

  /// Whether a batch must be computed, because one of its nodes was ever
  /// displaced. An active batch stays active.
  bool is_active(const unsigned int batch, const NodeFields<Real> &nodes)
  {
    if (active_[batch] == 0)
      activate(batch, nodes);
    return active_[batch] != 0;
  }

  /// The result of the last call of is_active().
  bool was_active(const unsigned int batch) const
  {
    return active_[batch] != 0;
  }

  /// Number of active batches.
  unsigned int n_active() const
  {
    return n_active_;
  }

  /// Marks all batches as active.
  void activate_all();

  /// The relaxed strains of a viscoelastic batch.
  Lane *relaxed_of(const Range &range, const unsigned int batch)
  {
    return &relaxed[range.first_relaxed +
                    6 * n_points_ * (batch - range.begin)];
  }
  const Lane *relaxed_of(const Range &range, const unsigned int batch) const
  {
    return &relaxed[range.first_relaxed +
                    6 * n_points_ * (batch - range.begin)];
  }

  /// Number of relaxed strain components of one element.
  unsigned int n_relaxed() const
  {
    return 6 * n_points_;
  }

  template <bool viscoelastic>
  DEAL_II_ALWAYS_INLINE void load_state(const Range &range,
                                        const unsigned int batch,
                                        HexState<Lane> &state) const
  {
    state.dilatation = dilatation[batch];
    state.viscous_pressure = viscous_pressure[batch];
    if (range.smoothed)
    {
      state.smoothing_pressure = smoothing_pressure[batch];
      state.smooth_dilatation = smooth_dilatation[batch];
    }
    if constexpr (viscoelastic)
      for (unsigned int k = 0; k < 6; ++k)
        state.relaxed[k] = relaxed_of(range, batch)[k];
    if (range.damped)
      for (unsigned int k = 0; k < 12; ++k)
        state.damping[k] =
          damping[range.first_damping + 12 * (batch - range.begin) + k];
  }

  template <bool viscoelastic>
  DEAL_II_ALWAYS_INLINE void store_state(const Range &range,
                                         const unsigned int batch,
                                         const HexState<Lane> &state)
  {
    dilatation[batch] = state.dilatation;
    viscous_pressure[batch] = state.viscous_pressure;
    if (range.smoothed)
    {
      smoothing_pressure[batch] = state.smoothing_pressure;
      smooth_dilatation[batch] = state.smooth_dilatation;
    }
    if constexpr (viscoelastic)
      for (unsigned int k = 0; k < 6; ++k)
        relaxed_of(range, batch)[k] = state.relaxed[k];
    if (range.damped)
      for (unsigned int k = 0; k < 12; ++k)
        damping[range.first_damping + 12 * (batch - range.begin) + k] =
          state.damping[k];
  }

  /// Resets the history variables to those of elements at rest.
  void reset_state();

private:
  void activate(const unsigned int batch, const NodeFields<Real> &nodes);

  unsigned int n_points_ = 1;
  unsigned int n_active_ = 0;
  std::vector<unsigned char> active_; ///< by batch
  std::vector<Range> ranges_;
  dealii::AlignedVector<unsigned int> offsets_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::uint32_t> slots_;
};
} // namespace contrecoup::solid
