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
typename LeafCarrier<dim>::Data LeafCarrier<dim>::read(const Cell &cell) const
{
  const unsigned int leaf = mesh_.leaf_of(cell);
  Data data;
  data.gas = field_.leaf(leaf);
  if (!maps_.empty())
    data.maps = maps_.leaf(leaf);
  return data;
}


template <int dim>
typename LeafCarrier<dim>::Data
LeafCarrier<dim>::read_children(const Cell &cell) const
{
  std::vector<std::vector<double>> gas;
  std::vector<std::vector<float>> maps;
  for (unsigned int c = 0; c < cell->n_children(); ++c)
  {
    Data child = read(cell->child(c));
    gas.push_back(std::move(child.gas));
    maps.push_back(std::move(child.maps));
  }
  Data data;
  data.gas = transfer_.from_children(gas, box_of(cell));
  if (!maps_.empty())
    data.maps = map_transfer_.from_children(maps);
  return data;
}


template <int dim>
std::vector<char> LeafCarrier<dim>::pack(const Cell &cell,
                                         const bool merged) const
{
  const Data data = merged ? read_children(cell) : read(cell);
  const std::size_t n_gas = data.gas.size() * sizeof(double);
  const std::size_t n_maps = data.maps.size() * sizeof(float);
  std::vector<char> bytes(n_gas + n_maps);
  std::memcpy(bytes.data(), data.gas.data(), n_gas);
  if (n_maps > 0)
    std::memcpy(bytes.data() + n_gas, data.maps.data(), n_maps);
  return bytes;
}


template <int dim>
void LeafCarrier<dim>::write(const Cell &cell, const Data &data) const
{
  const unsigned int leaf = mesh_.leaf_of(cell);
  field_.set_leaf(leaf, data.gas);
  if (!maps_.empty())
    maps_.set_leaf(leaf, data.maps);
}


template <int dim>
void LeafCarrier<dim>::unpack(const Cell &cell,
                              const bool is_refined,
                              const char *const bytes) const
{
  const LeafLayout &layout = field_.layout();
  Data data;
  data.gas.resize(std::size_t(layout.n_components) * layout.n_points);
  const std::size_t n_gas = data.gas.size() * sizeof(double);
  std::memcpy(data.gas.data(), bytes, n_gas);
  if (!maps_.empty())
  {
    data.maps.resize(maps_.n_leaf_values());
    std::memcpy(
      data.maps.data(), bytes + n_gas, data.maps.size() * sizeof(float));
  }
  if (!is_refined)
  {
    write(cell, data);
    return;
  }
  auto gas = transfer_.to_children(data.gas, box_of(cell));
  std::vector<std::vector<float>> maps(gas.size());
  if (!maps_.empty())
    maps = map_transfer_.to_children(data.maps);
  for (unsigned int c = 0; c < gas.size(); ++c)
    write(cell->child(c), {std::move(gas[c]), std::move(maps[c])});
}


template class LeafCarrier<1>;
template class LeafCarrier<2>;
template class LeafCarrier<3>;
} // namespace contrecoup::gas
