// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/gather.h>
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


  /// The pressure of the Riemann problem between the gas beside a facet and
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
      speed += inside[C::momentum + d] * facet.area[d] / facet.area.norm();
      inside[C::momentum + d] = 0.;
    }
    auto image = inside;
    inside[C::momentum] = speed;
    image[C::momentum] = -speed;
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
  return number_facets(found, gas.mesh.communicator());
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
