// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/numerics/element/hex8_wedge.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <map>
#include <vector>

namespace contrecoup::ale
{
/**
 * Frictionless slip walls: the normal velocity of a node on a wall is that of
 * the wall. Nodes on two walls slide along the common edge, nodes on three
 * walls are fixed to them.
 */
class SlipWalls
{
public:
  /// Outward normal velocity of a wall as a function of time [m/s].
  using Motion = std::function<double(double)>;

  /**
   * @param walls by boundary id; other boundaries are free
   * @param position of the nodes; the normal of a curved wall at a node is the
   * mean of its face normals
   */
  void reinit(const HexSpace &space,
              const dealii::AlignedVector<double> &position,
              const std::map<dealii::types::boundary_id, Motion> &walls);

  /// From now on makes fields on the two sides of a wedge mirror images.
  /// Otherwise round-off would grow, since steps exceed the CFL limit of waves
  /// between the sides.
  void mirror(const HexSpace &space, const HexWedge &wedge);

  /// Makes nodal vectors (node_width numbers each) on the two sides of
  /// the wedge mirror images.
  void make_mirrored(dealii::AlignedVector<double> &field) const;

  /// Imposes the wall velocities at @p time [s] on the nodes.
  void apply(dealii::AlignedVector<double> &velocity, const double time) const;

  /// Removes the components normal to walls from nodal vectors
  /// (node_width numbers each).
  void remove_normal_parts(dealii::AlignedVector<double> &field) const;

private:
  struct WallNode
  {
    std::uint32_t node;
    dealii::Tensor<1, 3> normal;
    unsigned int wall;
  };

  /// @param speed of each wall [m/s]
  void set_normal_parts(dealii::AlignedVector<double> &velocity,
                        const std::vector<double> &speed) const;
  void add_wall(const HexSpace &space,
                const dealii::AlignedVector<double> &position,
                const dealii::types::boundary_id boundary,
                const unsigned int wall,
                std::map<std::uint32_t, std::vector<WallNode>> &of_node) const;

  HexWedge wedge_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>>
    twins_; ///< on the two sides of a wedge
  std::vector<Motion> motions_;
  /// Entries of the same node are consecutive.
  std::vector<WallNode> wall_nodes_;
};
} // namespace contrecoup::ale
