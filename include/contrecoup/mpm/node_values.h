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
/// Values at the nodes of the grid, with one array per component.
class NodeValues
{
public:
  explicit NodeValues(const unsigned int n_components = 0)
    : values_(n_components)
  {}

  /// Resizes to the current nodes of the grid and sets all values to zero.
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

  /// Adds the values of ghost nodes to those of their owners. Collective.
  void compress_add(const TileGrid &grid);

  /// Sets the values of the owners to the maximum over their ghost copies.
  /// Collective.
  void compress_max(const TileGrid &grid);

  /// Copies the values of owned nodes to the ghost nodes of other ranks.
  /// Collective.
  void update_ghost_values(const TileGrid &grid);

private:
  void compress(const TileGrid &grid,
                const dealii::VectorOperation::values operation);

  std::vector<dealii::AlignedVector<double>> values_;
};

/// Distance between the components of a window. It is larger than the number of
/// nodes, because loads and stores at equal offsets within pages of 4 KiB cause
/// false dependencies in the processor.
constexpr unsigned int window_stride = TileGrid::window_size + 8;

/// Values at the nodes of a tile's window, by component; the index along x runs
/// fastest.
using Window = dealii::AlignedVector<double>;

/// Mirror images in which a component changes its sign, as a mask for the bits
/// of TileGrid::Source::mirrored; 0 for scalars.
using Parity = std::uint8_t;

/// Components of a gradient change their sign in mirror images along their own
/// direction.
inline const std::vector<Parity> gradient_parity{1, 2, 4};

/// Components of a velocity or force change their sign in mirror images along
/// their own direction, and in those at no-slip sides along other directions.
constexpr Parity vector_x = 1 + 16 + 32, vector_y = 2 + 8 + 32,
                 vector_z = 4 + 8 + 16;

/**
 * Copies components of nodal values to a window.
 * @param first first component; their number is that of @p parities
 */
void read_window(const TileGrid::Source &source,
                 const NodeValues &values,
                 const unsigned int first,
                 const std::vector<Parity> &parities,
                 double *window);

/// Adds components of a window to nodal values.
void add_window(const TileGrid::Source &source,
                const double *window,
                const unsigned int first,
                const std::vector<Parity> &parities,
                NodeValues &values);

/// Sets a nodal scalar to the maximum of itself and of the window.
void raise_nodes(const TileGrid::Source &source,
                 const double *window,
                 dealii::AlignedVector<double> &values);
} // namespace contrecoup::mpm
