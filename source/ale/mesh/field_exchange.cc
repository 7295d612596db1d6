// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/field_exchange.h>

#include <deal.II/base/index_set.h>

#include <vector>

namespace contrecoup::ale
{
namespace
{
  /// Replaces each index by @p width consecutive indices.
  dealii::IndexSet widened(const dealii::IndexSet &set,
                           const unsigned int width)
  {
    dealii::IndexSet result(set.size() * width);
    for (auto interval = set.begin_intervals(); interval != set.end_intervals();
         ++interval)
      result.add_range(*interval->begin() * width,
                       (interval->last() + 1) * width);
    result.compress();
    return result;
  }
} // namespace


void FieldExchange::reinit(const dealii::Utilities::MPI::Partitioner &single,
                           const unsigned int width)
{
  width_ = width;
  partitioner_ = std::make_shared<const dealii::Utilities::MPI::Partitioner>(
    widened(single.locally_owned_range(), width),
    widened(single.ghost_indices(), width),
    single.get_mpi_communicator());
}


void FieldExchange::update_ghost_values(
  dealii::AlignedVector<double> &field) const
{
  const std::size_t n_own = partitioner_->locally_owned_size();
  const std::size_t n_copies = partitioner_->n_ghost_indices();
  std::vector<double> packed(partitioner_->n_import_indices());
  std::vector<MPI_Request> requests;
  const dealii::ArrayView<const double> own(field.data(), n_own);
  const dealii::ArrayView<double> copies(field.data() + n_own, n_copies);
  const dealii::ArrayView<double> buffer(packed.data(), packed.size());
  partitioner_
    ->export_to_ghosted_array_start<double, dealii::MemorySpace::Host>(
      0, own, buffer, copies, requests);
  partitioner_
    ->export_to_ghosted_array_finish<double, dealii::MemorySpace::Host>(
      copies, requests);
}


void FieldExchange::compress_add(dealii::AlignedVector<double> &field) const
{
  const std::size_t n_own = partitioner_->locally_owned_size();
  const std::size_t n_copies = partitioner_->n_ghost_indices();
  std::vector<double> packed(partitioner_->n_import_indices());
  std::vector<MPI_Request> requests;
  const dealii::ArrayView<double> own(field.data(), n_own);
  const dealii::ArrayView<double> copies(field.data() + n_own, n_copies);
  const dealii::ArrayView<double> buffer(packed.data(), packed.size());
  partitioner_
    ->import_from_ghosted_array_start<double, dealii::MemorySpace::Host>(
      dealii::VectorOperation::add, 0, copies, buffer, requests);
  partitioner_
    ->import_from_ghosted_array_finish<double, dealii::MemorySpace::Host>(
      dealii::VectorOperation::add,
      dealii::ArrayView<const double>(packed.data(), packed.size()),
      own,
      copies,
      requests);
}
} // namespace contrecoup::ale
