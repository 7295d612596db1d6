// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/partitioner.h>

#include <memory>

namespace contrecoup::ale
{
/// Ghost exchange of nodal or cell fields with a fixed number of components. A
/// field is an array of the owned entries followed by the ghost copies.
class FieldExchange
{
public:
  /// @param single partitioning for one component
  /// @param width number of components
  void reinit(const dealii::Utilities::MPI::Partitioner &single,
              const unsigned int width);

  unsigned int width() const
  {
    return width_;
  }

  /// Length of a field including ghost copies.
  std::size_t size() const
  {
    return partitioner_->locally_owned_size() + partitioner_->n_ghost_indices();
  }

  /// Copies owned values to the ghost copies of other ranks. Collective.
  void update_ghost_values(dealii::AlignedVector<double> &field) const;

  /// Adds ghost copies to the owned values, in the order of ranks, and sets
  /// the ghost copies to zero. Collective.
  void compress_add(dealii::AlignedVector<double> &field) const;

private:
  unsigned int width_ = 1;
  std::shared_ptr<const dealii::Utilities::MPI::Partitioner> partitioner_;
};
} // namespace contrecoup::ale
