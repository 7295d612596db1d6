// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/node_values.h>

#include <bitset>

namespace contrecoup::mpm
{
namespace
{
  /// Buffers and requests for exchanging all components at once.
  struct Messages
  {
    Messages(const TileGrid &grid, const unsigned int n)
      : requests(n)
      , memory(n)
    {
      for (auto &one : memory)
        one.resize_fast(grid.partitioner().n_import_indices());
    }

    std::vector<std::vector<MPI_Request>> requests;
    std::vector<dealii::AlignedVector<double>> memory;
  };

  dealii::ArrayView<double> own_part(const TileGrid &grid,
                                     dealii::AlignedVector<double> &values)
  {
    return {values.data(), grid.n_locally_owned_nodes()};
  }

  dealii::ArrayView<double> copies(const TileGrid &grid,
                                   dealii::AlignedVector<double> &values)
  {
    return {values.data() + grid.n_locally_owned_nodes(),
            grid.n_nodes() - grid.n_locally_owned_nodes()};
  }

  template <typename Array>
  dealii::ArrayView<double> view(Array &array)
  {
    return {array.data(), array.size()};
  }

  double sign(const std::uint8_t mirrored, const Parity parity)
  {
    return std::bitset<8>(mirrored & parity).count() % 2 == 1 ? -1. : 1.;
  }
} // namespace


void NodeValues::clear(const TileGrid &grid)
{
  for (auto &component : values_)
  {
    component.resize_fast(grid.n_nodes());
    component.fill(0.);
  }
}


void NodeValues::compress(const TileGrid &grid,
                          const dealii::VectorOperation::values operation)
{
  const auto &partitioner = grid.partitioner();
  Messages messages(grid, n_components());
  for (unsigned int c = 0; c < n_components(); ++c)
    partitioner.import_from_ghosted_array_start(operation,
                                                c,
                                                copies(grid, values_[c]),
                                                view(messages.memory[c]),
                                                messages.requests[c]);
  for (unsigned int c = 0; c < n_components(); ++c)
    partitioner.import_from_ghosted_array_finish(
      operation,
      dealii::ArrayView<const double>(view(messages.memory[c])),
      own_part(grid, values_[c]),
      copies(grid, values_[c]),
      messages.requests[c]);
}


void NodeValues::compress_add(const TileGrid &grid)
{
  compress(grid, dealii::VectorOperation::add);
}


void NodeValues::compress_max(const TileGrid &grid)
{
  compress(grid, dealii::VectorOperation::max);
}


void NodeValues::update_ghost_values(const TileGrid &grid)
{
  const auto &partitioner = grid.partitioner();
  Messages messages(grid, n_components());
  for (unsigned int c = 0; c < n_components(); ++c)
    partitioner.export_to_ghosted_array_start(
      c,
      dealii::ArrayView<const double>(own_part(grid, values_[c])),
      view(messages.memory[c]),
      copies(grid, values_[c]),
      messages.requests[c]);
  for (unsigned int c = 0; c < n_components(); ++c)
    partitioner.export_to_ghosted_array_finish(copies(grid, values_[c]),
                                               messages.requests[c]);
}


void read_window(const TileGrid::Source &source,
                 const NodeValues &values,
                 const unsigned int first,
                 const std::vector<Parity> &parities,
                 double *const window)
{
  for (unsigned int c = 0; c < parities.size(); ++c)
  {
    const double *const from = values[first + c].data();
    double *const to = window + window_stride * c;
    for (unsigned int i = 0; i < source.nodes.size(); ++i)
      to[i] = source.nodes[i] == TileGrid::no_node ? 0. : from[source.nodes[i]];
    if (!source.mirrored.empty())
      for (unsigned int i = 0; i < source.nodes.size(); ++i)
        to[i] *= sign(source.mirrored[i], parities[c]);
  }
}


void add_window(const TileGrid::Source &source,
                const double *const window,
                const unsigned int first,
                const std::vector<Parity> &parities,
                NodeValues &values)
{
  for (unsigned int c = 0; c < parities.size(); ++c)
  {
    double *const to = values[first + c].data();
    const double *const from = window + window_stride * c;
    const bool has_mirror = !source.mirrored.empty();
    for (unsigned int i = 0; i < source.nodes.size(); ++i)
      if (source.nodes[i] != TileGrid::no_node)
        to[source.nodes[i]] +=
          has_mirror ? sign(source.mirrored[i], parities[c]) * from[i]
                     : from[i];
  }
}


void raise_nodes(const TileGrid::Source &source,
                 const double *const window,
                 dealii::AlignedVector<double> &values)
{
  for (unsigned int i = 0; i < source.nodes.size(); ++i)
    if (const std::uint32_t node = source.nodes[i]; node != TileGrid::no_node)
      values[node] = std::max(values[node], window[i]);
}
} // namespace contrecoup::mpm
