// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/tile_grid.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/lac/vector_operation.h>

#include <array>
#include <vector>

namespace contrecoup::mpm
{
/// A few numbers at each node of the grid, each component in an array of its
/// own.
class NodeValues
{
public:
  explicit NodeValues(const unsigned int n_components = 0)
    : values_(n_components)
  {}

  /// Sets everything to zero, for the nodes that the grid has now.
  void clear(const TileGrid &grid);

  unsigned int n_components() const
  {
    return values_.size();
  }
  dealii::AlignedVector<double> &operator[](const unsigned int component)
  {
    return values_[component];
  }
  const dealii::AlignedVector<double> &
  operator[](const unsigned int component) const
  {
    return values_[component];
  }

  /// Adds what ranks have in their copies to the owners' values. Collective.
  void compress_add(const TileGrid &grid);

  /// Raises the owners' values to those of copies that are larger. Collective.
  void compress_max(const TileGrid &grid);

  /// Gives the owners' values to the copies. Collective.
  void update_ghost_values(const TileGrid &grid);

private:
  void compress(const TileGrid &grid,
                const dealii::VectorOperation::values operation);

  std::vector<dealii::AlignedVector<double>> values_;
};

/// From one component of a window to the next: more than it has nodes, since
/// processors confuse stores and loads at equal places in pages of 4 KiB.
constexpr unsigned int window_stride = TileGrid::window_size + 8;

/// Numbers at the nodes of a tile's window: component by component, x fastest.
using Window = dealii::AlignedVector<double>;

/// In which mirrors a component changes its sign: with the bits of
/// TileGrid::Source::mirrored. Scalars have none.
using Parity = std::uint8_t;

/// Components of a gradient: mirrors along them.
inline const std::vector<Parity> gradient_parity{1, 2, 4};

/// Components of a velocity or force: mirrors along them, and those along
/// other directions that hold matter.
constexpr Parity vector_x = 1 + 16 + 32, vector_y = 2 + 8 + 32,
                 vector_z = 4 + 8 + 16;

/**
 * Reads components from nodes into a window.
 * @param first of the components, as many as there are @p parities
 */
void read_window(const TileGrid::Source &source,
                 const NodeValues &values,
                 const unsigned int first,
                 const std::vector<Parity> &parities,
                 double *window);

/// Adds components of a window to nodes.
void add_window(const TileGrid::Source &source,
                const double *window,
                const unsigned int first,
                const std::vector<Parity> &parities,
                NodeValues &values);

/// Raises one scalar of nodes to that of a window where it is larger.
void raise_nodes(const TileGrid::Source &source,
                 const double *window,
                 dealii::AlignedVector<double> &values);
} // namespace contrecoup::mpm
