// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/rezone/elastic_smoothing.h>

#include <deal.II/base/tensor.h>

#include <functional>
#include <map>

namespace contrecoup::ale
{
/// Walls that are normal to no axis, along which nodes may slide where they are
/// flat.
class InclinedWalls
{
public:
  static constexpr unsigned int none = -1;

  /**
   * Collective.
   * @param position of the nodes, AleState::width numbers each [m]
   * @param boundaries that may be such walls, the same on all ranks
   * @param is_inclined whether a face of them is normal to no axis
   */
  InclinedWalls(const HexSpace &space,
                const dealii::AlignedVector<double> &position,
                const std::vector<dealii::types::boundary_id> &boundaries,
                const std::function<bool(const HexSpace::Face &)> &is_inclined);

  unsigned int size() const
  {
    return static_cast<unsigned int>(normals_.size());
  }

  /// The wall of a face, if it is flat around this corner of it.
  unsigned int wall_around(const HexSpace::Face &face,
                           const unsigned int corner) const;

  /**
   * Lets a node slide along some of the walls.
   * @param is_along above 0 for these, by wall
   * @param is_prescribed of the node's components; others are added where walls
   *   leave none of them free
   */
  void add_node(const std::uint32_t node,
                const double *is_along,
                std::array<bool, 3> &is_prescribed,
                std::vector<InclinedNode> &inclined) const;

private:
  const dealii::AlignedVector<double> &position_;
  std::map<dealii::types::boundary_id, unsigned int> numbers_;
  /// Unit normals at the nodes, zero off the wall, by wall.
  std::vector<std::vector<dealii::Tensor<1, 3>>> normals_;
};
} // namespace contrecoup::ale
