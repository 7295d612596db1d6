// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/ale/mesh/region_descriptions.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  using boost::algorithm::iequals;

  void declare_state(ParameterHandler &prm)
  {
    declare_string(
      prm,
      "Where",
      "1",
      selecting("muParser expression of x, y, z that is true at the "
                "centres of the region's cells; later regions win."));
    declare_string(
      prm,
      "Layer",
      "any",
      selecting("Layer of the region: brain, csf, skull or scalp of a "
                "layered head; number or name of a material of a file, "
                "which is the tissue in files of `anatomy`; any is the "
                "whole mesh."));
    declare_string(
      prm,
      "Density",
      "1.2",
      used_with("Material not tissue",
                "Initial density [kg/m^3], a muParser expression of x, "
                "y, z; for a Tait liquid its density at zero pressure, a "
                "number."));
    declare_string(prm,
                   "Pressure",
                   "0",
                   "Initial pressure [Pa], a muParser expression of x, y, z.");
    declare_string(prm,
                   "Products",
                   "0",
                   "Initial mass fraction of explosive products [-], a "
                   "muParser expression of x, y, z.");
    for (const char *const name : {"Velocity x", "Velocity y", "Velocity z"})
      declare_string(
        prm,
        name,
        "0",
        "Initial velocity [m/s], a muParser expression of x, y, z.");
  }
} // namespace


void RegionDescriptions::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Region *");
  declare_state(prm);
  declare_region_material(prm);
}


void RegionDescriptions::parse_parameters(ParameterHandler &prm)
{
  for (const std::string &name : item_names(prm, "Region"))
  {
    const Section section(prm, "Region " + name);
    const auto expression = [&](const std::string &entry) {
      return Expression("Region " + name + "/" + entry, prm.get(entry));
    };
    Region region = parse_region_material(prm, name);
    region.layer = trim(prm.get("Layer"));
    descriptions_.push_back({std::move(region),
                             expression("Where"),
                             expression("Density"),
                             expression("Pressure"),
                             expression("Products"),
                             {{expression("Velocity x"),
                               expression("Velocity y"),
                               expression("Velocity z")}}});
  }
  if (descriptions_.empty())
    throw InputError("there is no region; add \"subsection Region NAME\" with "
                     "a material and a state");
}


void RegionDescriptions::refuse_metals() const
{
  for (const Description &description : descriptions_)
    if (description.region.plasticity)
      throw InputError("Region " + description.region.name +
                       "/Material = johnson-cook needs Method = mpm");
}


std::vector<Region> RegionDescriptions::regions() const
{
  std::vector<Region> result;
  for (const Description &description : descriptions_)
    result.push_back(description.region);
  return result;
}


bool MeshLayer::is_called(const std::string &word) const
{
  return iequals(word, name) || (!number.empty() && word == number);
}


void RegionDescriptions::check_layers(const MeshLayers &layers) const
{
  std::vector<std::string> known;
  for (const MeshLayer &layer : layers)
    known.push_back(layer.label());
  for (const Description &description : descriptions_)
    if (!iequals(description.region.layer, "any") &&
        std::none_of(layers.begin(), layers.end(), [&](const MeshLayer &layer) {
          return layer.is_called(description.region.layer);
        }))
      throw InputError("Region " + description.region.name +
                       "/Layer: the mesh has no \"" + description.region.layer +
                       "\", " +
                       (layers.empty() ? "because it is no layered head or "
                                         "file"
                                       : "but " + join(known, ", ")));
}


int RegionDescriptions::find_region(const dealii::Point<3> &place,
                                    const MeshLayer &layer) const
{
  for (std::size_t i = descriptions_.size(); i-- > 0;)
    if ((iequals(descriptions_[i].region.layer, "any") ||
         layer.is_called(descriptions_[i].region.layer)) &&
        descriptions_[i].where.value(place) != 0.)
      return static_cast<int>(i);
  return -1;
}


dealii::Tensor<1, 3>
RegionDescriptions::velocity_at(const dealii::Point<3> &place,
                                const unsigned int region) const
{
  dealii::Tensor<1, 3> velocity;
  for (unsigned int d = 0; d < 3; ++d)
    velocity[d] = descriptions_[region].velocity[d].value(place);
  return velocity;
}


const RegionDescriptions::Description &
RegionDescriptions::find(const dealii::Point<3> &place,
                         const MeshLayer &layer) const
{
  const int found = find_region(place, layer);
  if (found < 0)
    throw InputError(
      "Region: the cell at (" + std::to_string(place[0]) + ", " +
      std::to_string(place[1]) + ", " + std::to_string(place[2]) + ") m" +
      (layer.name.empty() ? "" : " of \"" + layer.label() + "\"") +
      " is in none");
  return descriptions_[found];
}


const Region &RegionDescriptions::region_at(const dealii::Point<3> &place,
                                            const MeshLayer &layer) const
{
  return find(place, layer).region;
}


double RegionDescriptions::density_at(const dealii::Point<3> &place,
                                      const MeshLayer &layer) const
{
  return check_state(find(place, layer), place).density;
}


void RegionDescriptions::set_regions(dealii::Triangulation<3> &mesh,
                                     const MeshLayers &layers) const
{
  check_layers(layers);
  std::vector<std::uint64_t> counts(descriptions_.size(), 0);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const auto centre = cell->center();
    const Description &found =
      find(centre, layers.empty() ? MeshLayer() : layers[cell->material_id()]);
    const auto region = static_cast<std::size_t>(&found - descriptions_.data());
    cell->set_material_id(static_cast<dealii::types::material_id>(region));
    ++counts[region];
  }
  require_some(counts, "centre of a cell");
}


void RegionDescriptions::require_some(const std::vector<std::uint64_t> &counts,
                                      const std::string &object) const
{
  Selections selections;
  for (std::size_t i = 0; i < counts.size(); ++i)
  {
    const Description &one = descriptions_[i];
    const bool is_layer = one.where.text() == "1";
    selections.add("Region " + one.region.name +
                     (is_layer ? "/Layer" : "/Where"),
                   is_layer ? one.region.layer : one.where.text(),
                   object,
                   counts[i]);
  }
  selections.require_some(MPI_COMM_SELF,
                          "where several regions are, the last one counts");
}


InitialMatter
RegionDescriptions::check_state(const Description &description,
                                const dealii::Point<3> &centre) const
{
  const double density = description.density.value(centre),
               pressure = description.pressure.value(centre),
               products = description.products.value(centre);
  const auto require = [&](const bool holds, const std::string &what) {
    if (!holds)
      throw InputError("Region " + description.region.name + "/" + what +
                       " in the cell at (" + coordinates(centre) + ") m");
  };
  require(density > 0.,
          "Density must be above 0, and is " + brief(density) + " kg/m^3");
  require(products >= 0. && products <= 1.,
          "Products must be from 0 to 1, and is " + brief(products));
  const InitialMatter matter =
    initial_matter(description.region, density, pressure, products);
  require(description.region.solid() == nullptr || pressure == 0.,
          "Pressure must be 0 in a solid, which is free of stress at the "
          "start, and is " +
            brief(pressure) + " Pa");
  require(matter.sound_speed_squared > 0.,
          "Pressure must leave the sound speed real and above 0, and is " +
            brief(pressure) + " Pa");
  return matter;
}


void RegionDescriptions::fill_cell(const HexSpace &space,
                                   const std::size_t cell,
                                   AleState &state) const
{
  const Description &description = at(space, cell);
  const auto corners = corners_of(space.cell(cell), state.position);
  const auto moments = hex_moments(corners);
  const dealii::Point<3> centre(moments.first[0] / moments.volume,
                                moments.first[1] / moments.volume,
                                moments.first[2] / moments.volume);
  const InitialMatter matter = check_state(description, centre);
  state.mass[cell] = matter.density * moments.volume;
  state.energy[cell] = matter.energy * moments.volume;
  state.products[cell] = description.products.value(centre);
}


void RegionDescriptions::fill(const HexSpace &space, AleState &state) const
{
  state.velocity.resize(node_width * space.n_nodes());
  state.mass.resize(space.n_cells());
  state.energy.resize(space.n_cells());
  state.products.resize(space.n_cells());
  const bool relaxes = std::any_of(
    descriptions_.begin(), descriptions_.end(), [](const Description &d) {
      return d.region.is_viscoelastic();
    });
  state.relaxed.clear();
  state.relaxed.resize(relaxes ? 6 * space.n_cells() : 0);
  for (std::size_t c = 0; c < space.n_cells(); ++c)
    fill_cell(space, c, state);
  for (std::size_t n = 0; n < space.n_nodes(); ++n)
  {
    const double *x = &state.position[node_width * n];
    const dealii::Point<3> place(x[0], x[1], x[2]);
    // Interface nodes get the mass-weighted mean of the regions' velocities.
    double mass = 0.;
    dealii::Tensor<1, 3> momentum;
    for (const std::uint32_t cell : space.cells_around(n))
    {
      mass += state.mass[cell];
      for (unsigned int d = 0; d < 3; ++d)
        momentum[d] +=
          state.mass[cell] * at(space, cell).velocity[d].value(place);
    }
    for (unsigned int d = 0; d < 3; ++d)
      state.velocity[node_width * n + d] = momentum[d] / mass;
  }
}


dealii::Tensor<1, 3> RegionDescriptions::fastest_velocity() const
{
  dealii::Tensor<1, 3> fastest;
  for (const Description &description : descriptions_)
  {
    dealii::Tensor<1, 3> velocity;
    for (unsigned int d = 0; d < 3; ++d)
      velocity[d] = description.velocity[d].value({});
    if (velocity.norm() > fastest.norm())
      fastest = velocity;
  }
  return fastest;
}


dealii::Tensor<1, 3> RegionDescriptions::largest_components() const
{
  dealii::Tensor<1, 3> largest;
  for (const Description &description : descriptions_)
    for (unsigned int d = 0; d < 3; ++d)
      largest[d] =
        std::max(largest[d], std::abs(description.velocity[d].value({})));
  return largest;
}


bool RegionDescriptions::has_pressure() const
{
  return std::any_of(
    descriptions_.begin(), descriptions_.end(), [](const Description &d) {
      return !d.pressure.is_zero();
    });
}


bool RegionDescriptions::velocity_depends_on_place() const
{
  return std::any_of(
    descriptions_.begin(), descriptions_.end(), [](const Description &d) {
      return std::any_of(
        d.velocity.begin(), d.velocity.end(), [](const Expression &component) {
          return component.depends_on_place();
        });
    });
}


bool RegionDescriptions::depends_on_place() const
{
  const auto depends = [](const Expression &expression) {
    return expression.depends_on_place();
  };
  return std::any_of(
    descriptions_.begin(), descriptions_.end(), [&](const Description &d) {
      return depends(d.where) || depends(d.density) || depends(d.pressure) ||
             depends(d.products) ||
             std::any_of(d.velocity.begin(), d.velocity.end(), depends);
    });
}


double
RegionDescriptions::largest_speed(const dealii::Triangulation<3> &mesh) const
{
  double largest = 0.;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const Description &description = descriptions_[cell->material_id()];
    const auto centre = cell->center();
    const double square = check_state(description, centre).sound_speed_squared;
    double speed = 0.;
    for (const Expression &velocity : description.velocity)
      speed += std::pow(velocity.value(centre), 2);
    largest = std::max(largest, std::sqrt(square) + std::sqrt(speed));
  }
  return largest;
}
} // namespace contrecoup::ale
