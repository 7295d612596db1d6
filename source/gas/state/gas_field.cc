// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/memory.h>
#include <contrecoup/gas/state/gas_field.h>

namespace contrecoup::gas
{
void GasField::reinit(const LeafLayout &layout, const unsigned int n_batches)
{
  layout_ = layout;
  burn_ = nullptr;
  visit([&](auto &copies) {
    for (auto &state : copies.states)
    {
      reserve_in_large_pages(state, n_batches * layout.batch_size());
      state.resize(n_batches * layout.batch_size());
    }
    for (auto &sensor : copies.sensors)
    {
      sensor.clear();
      sensor.resize(std::size_t(n_batches) * layout.width);
    }
  });
}


void GasField::begin_change(const unsigned int n_batches)
{
  const std::size_t size = n_batches * layout_.batch_size();
  visit([&](auto &copies) {
    reserve_in_large_pages(copies.states[1], size);
    copies.states[1].resize_fast(size);
    copies.states[0].swap(copies.states[1]);
  });
}


void GasField::end_change()
{
  burn_ = nullptr;
  visit([&](auto &copies) {
    const std::size_t size = copies.states[0].size();
    for (unsigned int copy = 1; copy < 3; ++copy)
    {
      reserve_in_large_pages(copies.states[copy], size);
      copies.states[copy].resize(size);
    }
    for (auto &sensor : copies.sensors)
    {
      sensor.clear();
      sensor.resize(size / layout_.batch_size() * layout_.width);
    }
  });
}


void GasField::copy_former_leaves(const unsigned int batch,
                                  const std::vector<unsigned int> &former)
{
  visit([&](auto &copies) {
    auto *to = copies.states[0].data() + batch * layout_.batch_size();
    for (unsigned int lane = 0; lane < layout_.width; ++lane)
    {
      const auto *from = copies.states[1].data() + layout_.offset(former[lane]);
      for (std::size_t i = 0; i < layout_.batch_size(); i += layout_.width)
        to[i + lane] = from[i];
    }
  });
}


void GasField::accept_stage(const unsigned int i)
{
  visit([&](auto &copies) {
    copies.states[0].swap(copies.states[1 + i]);
    copies.sensors[0].swap(copies.sensors[1 + i]);
  });
}


double GasField::sensor_of(const unsigned int leaf) const
{
  return visit(
    [&](const auto &copies) -> double { return copies.sensors[0][leaf]; });
}


std::vector<double> GasField::leaf(const unsigned int leaf) const
{
  return leaf_of_copy(0, leaf);
}


std::vector<double> GasField::former_leaf(const unsigned int leaf) const
{
  return leaf_of_copy(1, leaf);
}


std::vector<double> GasField::leaf_of_copy(const unsigned int copy,
                                           const unsigned int leaf) const
{
  std::vector<double> values(std::size_t(layout_.n_components) *
                             layout_.n_points);
  visit([&](const auto &copies) {
    const auto *from = copies.states[copy].data() + layout_.offset(leaf);
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = from[i * layout_.width];
  });
  return values;
}


void GasField::set_leaf(const unsigned int leaf,
                        const std::vector<double> &values)
{
  visit([&](auto &copies) {
    auto *to = copies.states[0].data() + layout_.offset(leaf);
    for (std::size_t i = 0; i < values.size(); ++i)
      to[i * layout_.width] = values[i];
  });
}


void GasField::fill_padding(const unsigned int n_owned)
{
  if (n_owned == 0)
    return;
  const std::vector<double> first = leaf(0);
  visit([&](auto &copies) {
    const unsigned int n_stored = copies.sensors[0].size();
    for (unsigned int i = n_owned; i < n_stored; ++i)
      // Ghosts and padding of the stages are read before they are first
      // written.
      for (auto &state : copies.states)
        for (std::size_t k = 0; k < first.size(); ++k)
          state[layout_.offset(i) + k * layout_.width] = first[k];
  });
}


void GasField::copy_to_stages(const unsigned int batch)
{
  const auto copy_batch = [&](auto &values, const std::size_t size) {
    for (unsigned int copy = 1; copy < 3; ++copy)
      std::copy_n(values[0].begin() + batch * size,
                  size,
                  values[copy].begin() + batch * size);
  };
  visit([&](auto &copies) {
    copy_batch(copies.states, layout_.batch_size());
    copy_batch(copies.sensors, layout_.width);
  });
}


std::size_t GasField::memory() const
{
  return visit([&](const auto &copies) {
    std::size_t bytes = 0;
    for (const auto &state : copies.states)
      bytes += state.memory_consumption();
    for (const auto &sensor : copies.sensors)
      bytes += sensor.memory_consumption();
    return bytes;
  });
}
} // namespace contrecoup::gas
