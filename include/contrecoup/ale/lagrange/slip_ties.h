// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/slip_walls.h>

namespace contrecoup::ale
{
/**
 * Ties a region that slides along others to them: both nodes of a place of the
 * interface get the same velocity normal to it, by equal and opposite impulses.
 * Along the interface they keep theirs, as there is no friction; nor does the
 * interface open.
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
   * Finds the normals of the interface, as the means of those of its faces by
   * area; at walls, along them. Collective.
   * @param position of the nodes, AleState::width numbers at each [m]
   */
  void find_normals(const dealii::AlignedVector<double> &position,
                    const SlipWalls &walls);

  /// @param velocity also of copies, with inverse masses of the nodes
  void apply(dealii::AlignedVector<double> &velocity);

  /**
   * Work of the impulses of the last apply() on nodes of this rank [J]: not
   * zero where the normal turns in a step.
   * @param mean velocity of the step [m/s]
   */
  double work(const dealii::AlignedVector<double> &mean) const;

  /// The largest difference between the velocities of two nodes of a place
  /// [m/s]. Collective.
  double
  largest_slip_speed(const dealii::AlignedVector<double> &velocity) const;

private:
  /// A face of the interface, with the nodes that do not slide.
  struct Face
  {
    std::array<std::uint32_t, 4> nodes;
    double sign; ///< -1: its corners are clockwise seen from the sliding region
  };

  const HexSpace *space_ = nullptr;
  bool is_empty_ = true;
  FieldExchange exchange_;
  std::vector<Face> faces_;                    ///< each on one rank
  dealii::AlignedVector<double> areas_;        ///< of nodes [m^2]
  std::vector<dealii::Tensor<1, 3>> normals_;  ///< of pairs; 0: none
  std::vector<dealii::Tensor<1, 3>> impulses_; ///< on sliding nodes [N s]
};
} // namespace contrecoup::ale
