// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/leaf_carrier.h>

#include <cstring>

namespace contrecoup::gas
{
namespace
{
  template <typename Cell>
  auto box_of(const Cell &cell)
  {
    constexpr int dim = Cell::AccessorType::dimension;
    LeafBox<dim> box;
    box.origin = cell->vertex(0);
    box.extents = cell->vertex((1U << dim) - 1) - cell->vertex(0);
    return box;
  }
} // namespace


template <int dim>
LeafCarrier<dim>::LeafCarrier(const LeafMesh<dim> &mesh,
                              const LeafPoints<dim> &points,
                              const GasMaterial &material,
                              GasField &field,
                              BlastMaps<dim> &maps)
  : mesh_(mesh)
  , transfer_(points, field.layout(), material)
  , map_transfer_(points)
  , field_(field)
  , maps_(maps)
{}


template <int dim>
void LeafCarrier<dim>::carry_over(const std::vector<LeafOrigin> &origins) const
{
  using Change = LeafOrigin::Change;
  field_.begin_change(mesh_.n_stored_batches());
  if (!maps_.empty())
    maps_.begin_change(mesh_.n_owned());
  copy_former_leaves(origins);
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const LeafOrigin &origin = origins[leaf];
    if (origin.change == Change::merged)
      merge(leaf, origin.former);
    else if (origin.change == Change::refined && origin.child == 0)
      refine(leaf, origin.former);
  }
  field_.end_change();
  maps_.end_change();
}


// Changed leaves are overwritten afterwards.
template <int dim>
void LeafCarrier<dim>::copy_former_leaves(
  const std::vector<LeafOrigin> &origins) const
{
  const unsigned int width = mesh_.width();
  std::vector<unsigned int> former(width);
  for (unsigned int batch = 0; batch < mesh_.n_batches(); ++batch)
  {
    for (unsigned int lane = 0; lane < width; ++lane)
      former[lane] =
        origins[std::min(batch * width + lane, mesh_.n_owned() - 1)].former;
    field_.copy_former_leaves(batch, former);
  }
  for (unsigned int leaf = 0; !maps_.empty() && leaf < mesh_.n_owned(); ++leaf)
    maps_.set_leaf(leaf, maps_.former_leaf(origins[leaf].former));
}


template <int dim>
void LeafCarrier<dim>::refine(const unsigned int leaf,
                              const unsigned int former) const
{
  const auto gas = transfer_.to_children(field_.former_leaf(former),
                                         box_of(mesh_.cell(leaf)->parent()));
  for (unsigned int child = 0; child < gas.size(); ++child)
    field_.set_leaf(leaf + child, gas[child]);
  if (maps_.empty())
    return;
  const auto maps = map_transfer_.to_children(maps_.former_leaf(former));
  for (unsigned int child = 0; child < maps.size(); ++child)
    maps_.set_leaf(leaf + child, maps[child]);
}


template <int dim>
void LeafCarrier<dim>::merge(const unsigned int leaf,
                             const unsigned int former) const
{
  std::vector<std::vector<double>> gas;
  std::vector<std::vector<float>> maps;
  for (unsigned int child = 0; child < (1U << dim); ++child)
  {
    gas.push_back(field_.former_leaf(former + child));
    if (!maps_.empty())
      maps.push_back(maps_.former_leaf(former + child));
  }
  field_.set_leaf(leaf, transfer_.from_children(gas, box_of(mesh_.cell(leaf))));
  if (!maps_.empty())
    maps_.set_leaf(leaf, map_transfer_.from_children(maps));
}


template <int dim>
std::vector<char> LeafCarrier<dim>::pack(const Cell &cell) const
{
  const unsigned int leaf = mesh_.leaf_of(cell);
  const std::vector<double> gas = field_.leaf(leaf);
  const std::vector<float> maps =
    maps_.empty() ? std::vector<float>() : maps_.leaf(leaf);
  const std::size_t n_gas = gas.size() * sizeof(double);
  const std::size_t n_maps = maps.size() * sizeof(float);
  std::vector<char> bytes(n_gas + n_maps);
  std::memcpy(bytes.data(), gas.data(), n_gas);
  if (n_maps > 0)
    std::memcpy(bytes.data() + n_gas, maps.data(), n_maps);
  return bytes;
}


template <int dim>
void LeafCarrier<dim>::unpack(const Cell &cell, const char *const bytes) const
{
  const unsigned int leaf = mesh_.leaf_of(cell);
  const LeafLayout &layout = field_.layout();
  std::vector<double> gas(std::size_t(layout.n_components) * layout.n_points);
  const std::size_t n_gas = gas.size() * sizeof(double);
  std::memcpy(gas.data(), bytes, n_gas);
  field_.set_leaf(leaf, gas);
  if (maps_.empty())
    return;
  std::vector<float> maps(maps_.n_leaf_values());
  std::memcpy(maps.data(), bytes + n_gas, maps.size() * sizeof(float));
  maps_.set_leaf(leaf, maps);
}


template class LeafCarrier<1>;
template class LeafCarrier<2>;
template class LeafCarrier<3>;
} // namespace contrecoup::gas
