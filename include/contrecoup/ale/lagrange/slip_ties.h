// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/slip_walls.h>

namespace contrecoup::ale
{
/**
 * Ties between a sliding region and its neighbours: equal and opposite
 * impulses give the two coincident nodes at each interface vertex the same
 * normal velocity. Tangential velocities remain independent (no friction), and
 * the interface does not open.
 */
class SlipTies
{
public:
  void reinit(const HexSpace &space);

  bool empty() const
  {
    return is_empty_;
  }

  /**
   * Computes interface normals as area-weighted means of face normals; at
   * walls, normals are projected onto the wall. Collective.
   * @param position of the nodes, node_width numbers each [m]
   */
  void find_normals(const dealii::AlignedVector<double> &position,
                    const SlipWalls &walls);

  /// Applies the impulses. @param velocity with inverse masses, including
  /// ghost copies
  void apply(dealii::AlignedVector<double> &velocity);

  /**
   * Work of the impulses of the last apply() on nodes of this rank [J];
   * nonzero where the normal turns during a step.
   * @param mean velocity of the step [m/s]
   */
  double work(const dealii::AlignedVector<double> &mean) const;

  /// Largest velocity difference of two tied nodes [m/s]. Collective.
  double
  largest_slip_speed(const dealii::AlignedVector<double> &velocity) const;

private:
  /// A face of the interface, with the nodes of the non-sliding side.
  struct Face
  {
    std::array<std::uint32_t, 4> nodes;
    double sign; ///< -1 if corners are clockwise seen from the sliding region
  };

  const HexSpace *space_ = nullptr;
  bool is_empty_ = true;
  FieldExchange exchange_;
  std::vector<Face> faces_;                    ///< each on one rank only
  dealii::AlignedVector<double> areas_;        ///< per node [m^2]
  std::vector<dealii::Tensor<1, 3>> normals_;  ///< per pair; 0: not tied
  std::vector<dealii::Tensor<1, 3>> impulses_; ///< on the sliding nodes [N s]
};
} // namespace contrecoup::ale
