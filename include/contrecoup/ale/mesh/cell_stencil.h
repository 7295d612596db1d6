// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/hex_space.h>

namespace contrecoup::ale
{
/// Neighbours of each owned cell within its region. Faces towards other
/// regions and boundary faces count as walls.
class CellStencil
{
public:
  using List = dealii::ArrayView<const std::uint32_t>;

  /// Collective.
  void reinit(const HexSpace &space);

  /// Cells that share a node with @p cell.
  List neighbors(const std::size_t cell) const
  {
    return list(neighbors_, first_neighbor_, cell);
  }

  /// Faces of @p cell that are no walls, as indices in HexSpace::faces().
  List faces(const std::size_t cell) const
  {
    return list(faces_, first_face_, cell);
  }

  /// Neighbours of @p cell across the faces opposite to its walls.
  List cells_opposite_to_walls(const std::size_t cell) const
  {
    return list(opposite_, first_opposite_, cell);
  }

  /// Whether no wall touches the node.
  bool is_inside(const std::size_t node) const
  {
    return is_inside_[node] != 0;
  }

private:
  using Lists = std::vector<std::vector<std::uint32_t>>;

  static List list(const std::vector<std::uint32_t> &values,
                   const std::vector<std::uint32_t> &first,
                   const std::size_t cell)
  {
    return {values.data() + first[cell], first[cell + 1] - first[cell]};
  }

  void find_neighbors(const HexSpace &space);
  void find_inside(const HexSpace &space);
  void find_faces(const HexSpace &space);

  std::vector<std::uint32_t> first_neighbor_, neighbors_;
  std::vector<std::uint32_t> first_face_, faces_;
  std::vector<std::uint32_t> first_opposite_, opposite_;
  std::vector<unsigned char> is_inside_;
};
} // namespace contrecoup::ale
