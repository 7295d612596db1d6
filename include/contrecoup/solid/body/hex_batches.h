// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <contrecoup/numerics/hex8_one_point.h>
#include <contrecoup/solid/body/node_fields.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::solid
{
/// What elements remember, by batch: of viscoelastic ones 6 relaxed strains for
/// each point in a row, of damped ones 12 forces.
template <typename Lane>
struct HexMemory
{
  dealii::AlignedVector<Lane> dilatation;
  dealii::AlignedVector<Lane> viscous_pressure;
  dealii::AlignedVector<Lane> relaxed;
  dealii::AlignedVector<Lane> damping;
};

/**
 * The elements of a rank, as many side by side as the processor has lanes, all
 * of one tissue. Lanes that are left over belong to a cube of nodes of their
 * own, behind those of the mesh, which never moves.
 */
template <typename Real>
class HexBatches : public HexMemory<Lanes<Real>>
{
public:
  using Lane = Lanes<Real>;
  using HexMemory<Lane>::dilatation;
  using HexMemory<Lane>::viscous_pressure;
  using HexMemory<Lane>::relaxed;
  using HexMemory<Lane>::damping;
  static constexpr unsigned int n = n_lanes<Real>;

  /// Batches of one tissue.
  struct Range
  {
    unsigned int tissue;
    unsigned int begin;
    unsigned int end;
    bool viscoelastic;
    unsigned int first_relaxed; ///< place of the first one's relaxed strain
    bool damped;
    unsigned int first_damping; ///< place of the first one's damping forces
  };

  /// @param viscoelastic whether each tissue needs memory of strains
  /// @param damped whether each tissue has dampers of hourglass modes
  /// @param n_points of integration, each with a memory of its own
  void reinit(const SolidMesh &mesh,
              const std::vector<bool> &viscoelastic,
              const std::vector<bool> &damped,
              const unsigned int n_points);

  /// Sets coordinates of the mesh and of the nodes for spare lanes.
  static void reinit_nodes(const SolidMesh &mesh, NodeFields<Real> &nodes);

  const std::vector<Range> &ranges() const
  {
    return ranges_;
  }

  unsigned int n_batches() const
  {
    return static_cast<unsigned int>(dilatation.size());
  }

  /// NodeFields::width times the nodes, of a corner in all lanes.
  const unsigned int *offsets(const unsigned int batch,
                              const unsigned int corner) const
  {
    return &offsets_[(8 * batch + corner) * n];
  }

  /// The cell of the mesh in a lane; lanes to spare have none.
  std::uint32_t cell(const unsigned int batch, const unsigned int lane) const
  {
    return cells_[batch * n + lane];
  }
  static constexpr std::uint32_t spare = -1;

  /// The place of each cell of the mesh: batch times n, plus lane.
  std::uint32_t slot(const std::uint32_t cell) const
  {
    return slots_[cell];
  }

  /// Bytes that elements need, without nodes.
  double memory() const;

  /// Whether a batch must be computed: whether one of its nodes was ever
  /// displaced. It is awake from then on.
  bool is_awake(const unsigned int batch, const NodeFields<Real> &nodes)
  {
    if (awake_[batch] == 0)
      wake(batch, nodes);
    return awake_[batch] != 0;
  }

  /// Whether it is, as when it was last asked for.
  bool was_awake(const unsigned int batch) const
  {
    return awake_[batch] != 0;
  }

  /// How many batches are awake.
  unsigned int n_awake() const
  {
    return n_awake_;
  }

  /// From now on all are.
  void wake_all();

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

  /// How many of them an element has.
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
    if constexpr (viscoelastic)
      for (unsigned int k = 0; k < 6; ++k)
        relaxed_of(range, batch)[k] = state.relaxed[k];
    if (range.damped)
      for (unsigned int k = 0; k < 12; ++k)
        damping[range.first_damping + 12 * (batch - range.begin) + k] =
          state.damping[k];
  }

  /// The state of elements at rest.
  void reset_state();

private:
  void wake(const unsigned int batch, const NodeFields<Real> &nodes);

  unsigned int n_points_ = 1;
  unsigned int n_awake_ = 0;
  std::vector<unsigned char> awake_; ///< by batch
  std::vector<Range> ranges_;
  dealii::AlignedVector<unsigned int> offsets_;
  std::vector<std::uint32_t> cells_;
  std::vector<std::uint32_t> slots_;
};


/// Numbers of corners of a batch: @p place of positions and displacements.
template <typename Real>
inline DEAL_II_ALWAYS_INLINE void load_corners(const Real *place,
                                               const unsigned int *offsets,
                                               HexVectors<Lanes<Real>> &x,
                                               HexVectors<Lanes<Real>> &u)
{
  constexpr unsigned int n = n_lanes<Real>;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    unsigned int doubled[n];
    for (unsigned int lane = 0; lane < n; ++lane)
      doubled[lane] = 2 * offsets[n * corner + lane];
    Lanes<Real> values[NodeFields<Real>::place_width];
    dealii::vectorized_load_and_transpose(
      NodeFields<Real>::place_width, place, doubled, values);
    for (unsigned int d = 0; d < 3; ++d)
    {
      x[corner][d] = values[d];
      u[corner][d] = values[3 + d];
    }
  }
}

/// Four numbers of each corner, from forces or velocities.
template <typename Real>
inline DEAL_II_ALWAYS_INLINE void
load_vectors(const Real *values,
             const unsigned int *offsets,
             std::array<std::array<Lanes<Real>, 4>, 8> &result)
{
  constexpr unsigned int n = n_lanes<Real>;
  for (unsigned int corner = 0; corner < 8; ++corner)
    dealii::vectorized_load_and_transpose(
      4, values, offsets + n * corner, result[corner].data());
}

/// Takes internal forces of a batch off those of its nodes.
template <typename Real>
inline DEAL_II_ALWAYS_INLINE void
subtract_forces(Real *force,
                const unsigned int *offsets,
                const HexVectors<Lanes<Real>> &internal)
{
  constexpr unsigned int n = n_lanes<Real>;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    Lanes<Real> values[4];
    for (unsigned int d = 0; d < 3; ++d)
      values[d] = -internal[corner][d];
    values[3] = Real();
    // One lane after the other: lanes may share a node.
    dealii::vectorized_transpose_and_store(
      true, 4, values, offsets + n * corner, force);
  }
}
} // namespace contrecoup::solid
