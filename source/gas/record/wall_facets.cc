// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/gather.h>
#include <contrecoup/gas/body/facet_outline.h>
#include <contrecoup/gas/octree/lattice.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/record/wall_facets.h>
#include <contrecoup/gas/state/primitive.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// Key that identifies the subcell at a position among all subcells.
  template <int dim>
  std::uint64_t key_of(const dealii::Point<dim> &place,
                       const CoarseMesh<dim> &domain)
  {
    // Centres of subcells differ by at least some millionths of the domain.
    const auto &lower = domain.lower_corner(), &upper = domain.upper_corner();
    std::uint64_t key = 0;
    for (unsigned int d = 0; d < dim; ++d)
      key = (key << 21) +
            static_cast<std::uint64_t>((place[d] - lower[d]) /
                                       (upper[d] - lower[d]) * (1U << 21));
    return key;
  }


  /// Corners of a square, in 2-D ends of a line, with this centroid and area
  /// vector.
  template <int dim>
  std::vector<float> substitute(const double *geometry)
  {
    const dealii::Point<3> centroid(geometry[0], geometry[1], geometry[2]);
    const dealii::Tensor<1, 3> area({geometry[3], geometry[4], geometry[5]});
    const double size = area.norm();
    dealii::Tensor<1, 3> other({0., 0., 1.});
    if (dim == 3 && std::abs(area[2]) > 0.5 * size)
      other = dealii::Tensor<1, 3>({1., 0., 0.});
    dealii::Tensor<1, 3> a = dealii::cross_product_3d(area, other);
    a *= 0.5 * (dim == 3 ? std::sqrt(size) : size) / a.norm();
    const dealii::Tensor<1, 3> b = dim == 3
                                     ? dealii::cross_product_3d(area, a) / size
                                     : dealii::Tensor<1, 3>();
    std::vector<float> result;
    const auto add = [&](const dealii::Tensor<1, 3> &offset) {
      for (unsigned int d = 0; d < 3; ++d)
        result.push_back(static_cast<float>(centroid[d] + offset[d]));
    };
    if (dim == 2)
    {
      add(a);
      add(-a);
      return result;
    }
    // Their order gives an area vector out of the body.
    add(a + b);
    add(a - b);
    add(-a - b);
    add(b - a);
    return result;
  }


  /// The pressure of the Riemann problem between the gas next to a facet and
  /// its mirror image [Pa].
  template <int dim, typename Gas>
  double wall_pressure(const typename WallFacets<dim>::Facet &facet,
                       const GasField &field,
                       const Gas &gas,
                       const RiemannFlux flux)
  {
    using C = Component<dim>;
    constexpr unsigned int nc = n_conserved<dim, Gas>;
    std::array<double, nc> u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = field.value(facet.leaf, c, facet.point);
    auto inside = to_primitive<dim>(gas, u);
    double speed = 0.;
    for (unsigned int d = 0; d < dim; ++d)
    {
      speed += inside[C::velocity + d] * facet.area[d] / facet.area.norm();
      inside[C::velocity + d] = 0.;
    }
    auto image = inside;
    inside[C::velocity] = speed;
    image[C::velocity] = -speed;
    const double pressure = numerical_flux(flux,
                                           to_face_state<dim>(gas, inside),
                                           to_face_state<dim>(gas, image),
                                           1.)
                              .momentum[0];
    return field.exerted_pressure(pressure,
                                  field.burned(facet.leaf, facet.point));
  }
} // namespace


template <int dim>
bool WallFacets<dim>::mesh_changed(const GasSnapshot<dim> &gas)
{
  facets_.clear();
  Found found;
  if constexpr (dim > 1)
    for (unsigned int leaf = 0; leaf < gas.mesh.n_owned(); ++leaf)
      if (gas.cut_leaves.shape(leaf) != nullptr)
        add_facets(leaf, gas, found);
  const bool are_others = number_facets(found, gas.mesh.communicator());
  if (are_others)
    find_outlines(gas);
  return are_others;
}


template <int dim>
void WallFacets<dim>::add_facets(const unsigned int leaf,
                                 const GasSnapshot<dim> &gas,
                                 Found &found)
{
  if constexpr (dim > 1)
  {
    // Fraction of a cell's face below which an area is round-off.
    const double nothing = 1e-10;
    const LeafLayout &layout = gas.scene.layout;
    const LeafBox<dim> box = leaf_box(gas.mesh, leaf);
    const dealii::Tensor<1, dim> size = box.extents / layout.n;
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      dealii::Tensor<1, dim> area = gas.cut_leaves.wall({leaf, q});
      if (area.norm() < nothing || gas.cut_leaves.fractions()(leaf, q) == 0.)
        continue;
      const double volume = gas.cut_leaves.cell_volume({leaf, q});
      const auto index = gas.scene.points.indices(q);
      dealii::Point<dim> place = box.origin;
      for (unsigned int d = 0; d < dim; ++d)
      {
        place[d] += size[d] * (index[d] + 0.5);
        area[d] *= volume / size[d];
      }
      facets_.push_back({leaf, q, 0, area});
      found.keys.push_back(key_of(place, gas.mesh.coarse_mesh()));
      // Known facets keep their geometry, since computing it is expensive.
      const std::size_t known =
        std::lower_bound(keys_.begin(), keys_.end(), found.keys.back()) -
        keys_.begin();
      if (known < keys_.size() && keys_[known] == found.keys.back())
      {
        const auto values = geometry_.begin() + n_geometry * known;
        found.geometry.insert(
          found.geometry.end(), values, values + n_geometry);
        continue;
      }
      const dealii::Point<3> centroid = gas.scene.body.project(place);
      for (unsigned int d = 0; d < 3; ++d)
        found.geometry.push_back(centroid[d]);
      for (unsigned int d = 0; d < 3; ++d)
        found.geometry.push_back(d < dim ? area[d] : 0.);
    }
  }
}


template <int dim>
bool WallFacets<dim>::number_facets(const Found &found,
                                    const MPI_Comm communicator)
{
  std::vector<std::uint64_t> all;
  for (const auto &of_rank : gather_arrays(communicator, found.keys))
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  std::sort(all.begin(), all.end());
  const bool are_others = keys_ != all;
  keys_ = std::move(all);
  geometry_.assign(n_geometry * keys_.size(), 0.);
  for (std::size_t i = 0; i < facets_.size(); ++i)
  {
    facets_[i].number =
      std::lower_bound(keys_.begin(), keys_.end(), found.keys[i]) -
      keys_.begin();
    std::copy_n(&found.geometry[n_geometry * i],
                n_geometry,
                &geometry_[n_geometry * facets_[i].number]);
  }
  dealii::Utilities::MPI::sum(geometry_, communicator, geometry_);
  return are_others;
}


template <int dim>
void WallFacets<dim>::find_outlines(const GasSnapshot<dim> &gas)
{
  const MPI_Comm communicator = gas.mesh.communicator();
  std::vector<std::uint64_t> numbers, sizes;
  std::vector<float> places;
  for (const Facet &facet : facets_)
  {
    const std::vector<float> corners = outline(facet, gas);
    numbers.push_back(facet.number);
    sizes.push_back(corners.size());
    places.insert(places.end(), corners.begin(), corners.end());
  }
  const auto all_numbers = gather_arrays(communicator, numbers);
  const auto all_sizes = gather_arrays(communicator, sizes);
  const auto all_places = gather_arrays(communicator, places);
  if (dealii::Utilities::MPI::this_mpi_process(communicator) != 0)
    return;
  std::vector<std::vector<float>> outlines(n_global());
  for (std::size_t rank = 0; rank < all_numbers.size(); ++rank)
  {
    auto begin = all_places[rank].begin();
    for (std::size_t i = 0; i < all_numbers[rank].size(); ++i)
    {
      const auto end = begin + static_cast<std::ptrdiff_t>(all_sizes[rank][i]);
      outlines[all_numbers[rank][i]].assign(begin, end);
      begin = end;
    }
  }
  skin_ = io::make_skin_mesh(outlines, dim == 2);
}


template <int dim>
std::vector<float> WallFacets<dim>::outline(const Facet &facet,
                                            const GasSnapshot<dim> &gas) const
{
  std::vector<float> result;
  if constexpr (dim > 1)
  {
    const unsigned int n = gas.scene.layout.n;
    const LeafBox<dim> box = leaf_box(gas.mesh, facet.leaf);
    const auto index = gas.scene.points.indices(facet.point);
    const auto place = [&](const dealii::Point<dim> &part) {
      dealii::Point<dim> result = box.origin;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] += box.extents[d] * ((index[d] + part[d]) / n);
      return result;
    };
    std::vector<dealii::Point<dim>> corners;
    if (gas.cut_leaves.treatment() == RigidBody::Treatment::staircase)
    {
      std::array<bool, 2 * dim> is_closed;
      for (unsigned int face = 0; face < 2 * dim; ++face)
        is_closed[face] =
          gas.cut_leaves.opening({facet.leaf, facet.point}, face) == 0.;
      corners = closed_outline<dim>(is_closed);
    }
    else
    {
      // As in cut_shape().
      const double smallest = box.extents.norm() / n * 1e-12;
      std::array<double, (1U << dim)> distances;
      for (unsigned int v = 0; v < distances.size(); ++v)
      {
        dealii::Point<dim> corner;
        for (unsigned int d = 0; d < dim; ++d)
          corner[d] = lattice_indices<dim>(v, 2)[d];
        const double value = gas.scene.body.value(place(corner));
        distances[v] = std::abs(value) < smallest ? 0. : value;
      }
      corners = cut_outline<dim>(distances);
    }
    for (const auto &corner : corners)
    {
      const dealii::Point<dim> where = place(corner);
      for (unsigned int d = 0; d < 3; ++d)
        result.push_back(d < dim ? static_cast<float>(where[d]) : 0.F);
    }
  }
  return result.empty() ? substitute<dim>(&geometry_[n_geometry * facet.number])
                        : result;
}


template <int dim>
std::vector<double> WallFacets<dim>::overpressures(const GasSnapshot<dim> &gas,
                                                   const double ambient) const
{
  std::vector<double> result(facets_.size(), 0.);
  std::visit(
    [&](const auto &model) {
      for (std::size_t i = 0; i < facets_.size(); ++i)
        if (!gas.quiet_leaves.is_quiet(facets_[i].leaf))
          result[i] = wall_pressure<dim>(
                        facets_[i], gas.field, model, gas.scene.scheme.flux) -
                      ambient;
    },
    gas.scene.material.model());
  return result;
}


template class WallFacets<1>;
template class WallFacets<2>;
template class WallFacets<3>;
} // namespace contrecoup::gas
