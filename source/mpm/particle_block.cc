// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/particle_block.h>

#include <algorithm>

namespace contrecoup::mpm
{
void ParticleBlock::grow()
{
  // An odd multiple: columns at a distance of a power of two would compete for
  // the same cache sets.
  const std::size_t capacity = std::max<std::size_t>(
    5 * padding,
    (capacity_ + capacity_ / 2) / (2 * padding) * 2 * padding + padding);
  dealii::AlignedVector<double> values(column::n_columns * capacity);
  values.fill(0.);
  for (unsigned int c = 0; c < column::n_columns; ++c)
    std::copy_n((*this)[c], size_, values.data() + c * capacity);
  values_ = std::move(values);
  capacity_ = capacity;
}


std::size_t ParticleBlock::append()
{
  if (size_ + padding > capacity_)
    grow();
  for (unsigned int c = 0; c < column::n_columns; ++c)
    (*this)[c][size_] = 0.;
  return size_++;
}


void ParticleBlock::append(const ParticleBlock &other,
                           const std::size_t particle)
{
  const std::size_t i = append();
  for (unsigned int c = 0; c < column::n_columns; ++c)
    (*this)[c][i] = other[c][particle];
}


void ParticleBlock::append(const double *const state)
{
  const std::size_t i = append();
  for (unsigned int c = 0; c < column::n_state_columns; ++c)
    (*this)[c][i] = state[c];
}


void ParticleBlock::copy_state(const std::size_t particle,
                               double *const state) const
{
  for (unsigned int c = 0; c < column::n_state_columns; ++c)
    state[c] = (*this)[c][particle];
}


void ParticleBlock::remove(const std::size_t particle)
{
  --size_;
  for (unsigned int c = 0; c < column::n_columns; ++c)
    (*this)[c][particle] = (*this)[c][size_];
}
} // namespace contrecoup::mpm
