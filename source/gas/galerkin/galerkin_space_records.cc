// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/galerkin/galerkin_space.h>

#include <algorithm>

namespace contrecoup::gas
{
// The records in use at a time are few and stay in the cache: a record is taken
// again after the last batch of cells that reads it. On mapped meshes the areas
// keep theirs.
template <int dim, typename Real>
void GalerkinSpace<dim, Real>::reserve_records()
{
  n_records_ = 0;
  std::vector<std::vector<unsigned int>> first_read(cells_.size()),
    last_read(cells_.size());
  for (unsigned int b = 0; b < faces_.size(); ++b)
  {
    const auto [first, last] = first_and_last_reader(faces_[b]);
    first_read[first].push_back(b);
    last_read[last].push_back(b);
  }
  std::vector<unsigned int> released;
  const auto take = [&]() {
    if (released.empty())
    {
      released.push_back(n_records_);
      n_records_ += width;
    }
    const unsigned int record = released.back();
    released.pop_back();
    return record;
  };
  for (unsigned int cell_batch = 0; cell_batch < cells_.size(); ++cell_batch)
  {
    for (const unsigned int b : first_read[cell_batch])
    {
      FaceBatch &batch = faces_[b];
      batch.record[0] = take();
      batch.record[1] = has_one_record(batch) ? batch.record[0] : take();
    }
    if (is_collocated_)
      for (const unsigned int b : last_read[cell_batch])
      {
        released.push_back(faces_[b].record[0]);
        if (!has_one_record(faces_[b]))
          released.push_back(faces_[b].record[1]);
      }
  }
}


template <int dim, typename Real>
std::pair<unsigned int, unsigned int>
GalerkinSpace<dim, Real>::first_and_last_reader(const FaceBatch &batch) const
{
  unsigned int first = cells_.size(), last = 0;
  for (unsigned int side = 0; side < 2; ++side)
    for (unsigned int lane = 0; lane < batch.n_filled; ++lane)
    {
      const unsigned int leaf = batch.leaf[side][lane];
      if (!batch.has(side) || leaf >= mesh_.n_owned())
        continue;
      const unsigned int reader = place_of_leaf_[leaf] / width;
      first = std::min(first, reader);
      last = std::max(last, reader);
    }
  return {first, last};
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::attach_records()
{
  for (unsigned int b = 0; b < faces_.size(); ++b)
    for (unsigned int side = 0; side < 2; ++side)
      if (faces_[b].has(side))
        for (unsigned int lane = 0; lane < faces_[b].n_filled; ++lane)
          attach_record(
            faces_[b].leaf[side][lane], side, b, faces_[b].record[side] + lane);
  for (CellBatch &batch : cells_)
  {
    sort_finer_neighbors(batch);
    for (LaneIndices &record : batch.record)
    {
      Assert(std::count(
               record.begin(), record.begin() + batch.n_filled, no_leaf) == 0,
             dealii::ExcInternalError());
      std::fill(record.begin() + batch.n_filled, record.end(), record[0]);
    }
    std::sort(batch.faces.begin(), batch.faces.end());
    batch.faces.erase(std::unique(batch.faces.begin(), batch.faces.end()),
                      batch.faces.end());
  }
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::attach_record(const unsigned int leaf,
                                             const unsigned int side,
                                             const unsigned int face_batch,
                                             const unsigned int record)
{
  if (leaf >= mesh_.n_owned())
    return;
  const FaceBatch &from = faces_[face_batch];
  CellBatch &batch = cells_[place_of_leaf_[leaf] / width];
  const unsigned int lane = place_of_leaf_[leaf] % width;
  batch.faces.push_back(face_batch);
  if (from.kind == FaceBatch::Kind::hanging && side != from.interior)
    batch.finer_neighbors.push_back(
      {lane, from.face[side], record, from.quarter});
  else
    batch.record[from.face[side]][lane] = record;
}


template <int dim, typename Real>
void GalerkinSpace<dim, Real>::sort_finer_neighbors(CellBatch &batch)
{
  auto &neighbors = batch.finer_neighbors;
  std::sort(neighbors.begin(),
            neighbors.end(),
            [](const FinerNeighbor &a, const FinerNeighbor &b) {
              return a.quarter < b.quarter;
            });
  const auto first_end =
    std::find_if(neighbors.begin(),
                 neighbors.end(),
                 [](const FinerNeighbor &n) { return n.quarter > 0; });
  for (auto first = neighbors.begin(); first != first_end; ++first)
    batch.record[first->face][first->lane] = first->record;
  neighbors.erase(neighbors.begin(), first_end);
}


#define CONTRECOUP_INSTANTIATE(dim, Real)                    \
  template void GalerkinSpace<dim, Real>::reserve_records(); \
  template void GalerkinSpace<dim, Real>::attach_records()

CONTRECOUP_INSTANTIATE(1, double);
CONTRECOUP_INSTANTIATE(2, double);
CONTRECOUP_INSTANTIATE(3, double);
CONTRECOUP_INSTANTIATE(3, float);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
