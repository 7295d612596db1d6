// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/rezone/elastic_smoothing.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <map>

namespace contrecoup::ale
{
/// Boundaries with slip that have a face which is normal to no coordinate axis;
/// nodes slide only where such a boundary is flat.
class InclinedWalls
{
public:
  static constexpr unsigned int none = -1;

  /**
   * Computes the normals of the walls at nodes. Collective.
   * @param position of the nodes, node_width numbers each [m]
   * @param boundaries candidate boundary ids, the same on all ranks
   * @param is_inclined whether a face of the boundary is normal to no axis
   */
  InclinedWalls(const HexSpace &space,
                const dealii::AlignedVector<double> &position,
                const std::vector<dealii::types::boundary_id> &boundaries,
                const std::function<bool(const HexSpace::Face &)> &is_inclined);

  unsigned int size() const
  {
    return static_cast<unsigned int>(normals_.size());
  }

  /// Number of the inclined wall of a face; `none` if the face is on no
  /// inclined wall, or the wall is not flat at this corner.
  unsigned int wall_around(const HexSpace::Face &face,
                           const unsigned int corner) const;

  /**
   * Constrains a node to slide along some of the walls.
   * @param is_along by wall: positive if the node slides along it
   * @param is_prescribed components of the node; set where the walls leave no
   * freedom
   */
  void add_node(const std::uint32_t node,
                const double *is_along,
                std::array<bool, 3> &is_prescribed,
                std::vector<InclinedNode> &inclined) const;

private:
  const dealii::AlignedVector<double> &position_;
  std::map<dealii::types::boundary_id, unsigned int> numbers_;
  /// Unit normals at nodes by wall; zero off the wall.
  std::vector<std::vector<dealii::Tensor<1, 3>>> normals_;
};
} // namespace contrecoup::ale
