// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/numerics/hex8_wedge.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <map>
#include <vector>

namespace contrecoup::ale
{
/**
 * Walls along which nodes slide without friction: the velocity normal to a
 * wall is that of the wall. Nodes on two walls slide along their edge, and on
 * three they go with them.
 */
class SlipWalls
{
public:
  /// Normal velocity of a wall, outwards, over time [m/s].
  using Motion = std::function<double(double)>;

  /**
   * @param walls by boundary id; boundaries that are not among them are free
   * @param position of the nodes, by which the normals of curved walls are the
   *   means of those of the faces
   */
  void reinit(const HexSpace &space,
              const dealii::AlignedVector<double> &position,
              const std::map<dealii::types::boundary_id, Motion> &walls);

  /// Lets what is at the sides of a wedge be mirror images from now on:
  /// round-off would grow, as steps are too long for waves from side to side.
  void mirror(const HexSpace &space, const HexWedge &wedge);

  /// Makes vectors at the nodes, AleState::width numbers each, mirror images.
  void make_mirrored(dealii::AlignedVector<double> &field) const;

  /// Sets the normal velocities of the nodes on walls at @p time [s].
  void apply(dealii::AlignedVector<double> &velocity, const double time) const;

  /// Makes vectors at the nodes on walls, AleState::width numbers each, lie
  /// along them.
  void remove_normal_parts(dealii::AlignedVector<double> &field) const;

private:
  struct WallNode
  {
    std::uint32_t node;
    dealii::Tensor<1, 3> normal;
    unsigned int wall;
  };

  /// @param speed of the walls
  void set_normal_parts(dealii::AlignedVector<double> &velocity,
                        const std::vector<double> &speed) const;
  void add_wall(const HexSpace &space,
                const dealii::AlignedVector<double> &position,
                const dealii::types::boundary_id boundary,
                const unsigned int wall,
                std::map<std::uint32_t, std::vector<WallNode>> &of_node) const;

  HexWedge wedge_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
    twins_; ///< of both sides
  std::vector<Motion> motions_;
  /// Those of a node follow each other.
  std::vector<WallNode> wall_nodes_;
};
} // namespace contrecoup::ale
