// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/gas_field.h>

namespace contrecoup::gas
{
void GasField::reinit(const LeafLayout &layout, const unsigned int n_batches)
{
  layout_ = layout;
  burn_ = nullptr;
  for (auto &copy : copies_)
  {
    copy.clear();
    copy.resize(n_batches * layout.batch_size());
  }
  for (auto &sensor : sensors_)
  {
    sensor.clear();
    sensor.resize(std::size_t(n_batches) * W);
  }
}


std::vector<double> GasField::leaf(const unsigned int leaf) const
{
  std::vector<double> values(std::size_t(layout_.n_components) *
                             layout_.n_points);
  const double *from = state() + layout_.offset(leaf);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = from[i * W];
  return values;
}


void GasField::set_leaf(const unsigned int leaf,
                        const std::vector<double> &values)
{
  double *to = state() + layout_.offset(leaf);
  for (std::size_t i = 0; i < values.size(); ++i)
    to[i * W] = values[i];
}


void GasField::fill_padding(const unsigned int n_owned)
{
  const unsigned int n_stored =
    static_cast<unsigned int>(copies_[0].size() / layout_.batch_size()) * W;
  if (n_owned == 0)
    return;
  const std::vector<double> first = leaf(0);
  for (unsigned int i = n_owned; i < n_stored; ++i)
    set_leaf(i, first);
  // The stages' ghosts and padding are read before they are first written.
  for (unsigned int i = n_owned; i < n_stored; ++i)
    for (unsigned int copy = 1; copy < 3; ++copy)
      for (std::size_t k = 0; k < first.size(); ++k)
        copies_[copy][layout_.offset(i) + k * W] = first[k];
}


std::size_t GasField::memory() const
{
  std::size_t bytes = 0;
  for (const auto &copy : copies_)
    bytes += copy.memory_consumption();
  for (const auto &sensor : sensors_)
    bytes += sensor.memory_consumption();
  return bytes;
}
} // namespace contrecoup::gas
