// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/partitioner.h>

#include <memory>

namespace contrecoup::ale
{
/**
 * Exchanges fields that have a few numbers at each of what ranks own and have
 * copies of: nodes, or cells. A field is an array of the own ones, and of the
 * copies behind them.
 */
class FieldExchange
{
public:
  /// @param single who owns what, with one number at each
  /// @param width numbers at each
  void reinit(const dealii::Utilities::MPI::Partitioner &single,
              const unsigned int width);

  unsigned int width() const
  {
    return width_;
  }

  /// Numbers in a field, copies included.
  std::size_t size() const
  {
    return partitioner_->locally_owned_size() + partitioner_->n_ghost_indices();
  }

  /// Sets copies to what their owners have. Collective.
  void update_copies(dealii::AlignedVector<double> &field) const;

  /// Adds copies to what their owners have, in the order of the ranks, and sets
  /// them to zero. Collective.
  void add_copies(dealii::AlignedVector<double> &field) const;

private:
  unsigned int width_ = 1;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
};
} // namespace contrecoup::ale
