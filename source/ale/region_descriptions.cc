// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/region_descriptions.h>
#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameter_tree.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/numerics/hex8_moments.h>

namespace contrecoup::ale
{
namespace
{
  constexpr unsigned int width = AleState::width;

  const std::vector<std::string> materials{"ideal gas",
                                           "tait",
                                           "jwl",
                                           "jwl in air"};

  void declare_material(ParameterHandler &prm)
  {
    declare_selection(prm,
                      "Material",
                      "ideal gas",
                      materials,
                      "Equation of state; jwl are the products of an "
                      "explosive, jwl in air their mixture with air.");
    declare_double(prm,
                   "Gamma",
                   "1.4",
                   1.0001,
                   100.,
                   "-",
                   "Ratio of specific heats of the ideal gas, or the air.");
    declare_selection(prm,
                      "Explosive",
                      "tnt",
                      explosive_names(),
                      "Whose products jwl and jwl in air are.");
    declare_double(prm,
                   "Bulk modulus",
                   "2.2e9",
                   1.,
                   1e15,
                   "Pa",
                   "K_0 of Tait's liquid at rest.");
    declare_double(
      prm, "Exponent", "7.15", 1.0001, 100., "-", "n of Tait's liquid.");
    declare_string(prm,
                   "Least pressure",
                   "none",
                   "At which Tait's liquid cavitates [Pa], at most 0; none: it "
                   "bears any tension.");
  }

  void declare_state(ParameterHandler &prm)
  {
    declare_string(prm,
                   "Where",
                   "1",
                   "muParser expression of x, y, z that is true at the "
                   "centres of the region's cells; later regions win.");
    declare_string(prm,
                   "Density",
                   "1.2",
                   "At the start [kg/m^3], a muParser expression of x, y, z; "
                   "of Tait's liquid that without pressure, a number.");
    declare_string(prm,
                   "Pressure",
                   "0",
                   "At the start [Pa], a muParser expression of x, y, z.");
    declare_string(prm,
                   "Products",
                   "0",
                   "Mass fraction of explosive products at the start [-], a "
                   "muParser expression of x, y, z.");
    for (const char *const name : {"Velocity x", "Velocity y", "Velocity z"})
      declare_string(prm,
                     name,
                     "0",
                     "At the start [m/s], a muParser expression of x, y, z.");
  }

  void declare_viscosity(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Linear viscosity",
                   "0.5",
                   0.,
                   10.,
                   "-",
                   "Artificial, in compression: times density, cell length "
                   "and sound speed. 0.5 for shocks in gases; 0.06 leaves "
                   "sound in liquids undamped.");
    declare_double(prm,
                   "Quadratic viscosity",
                   "2",
                   0.,
                   10.,
                   "-",
                   "Artificial, in compression: times density, square of the "
                   "cell length and rate of compression.");
    declare_double(prm,
                   "Hourglass coefficient",
                   "0.1",
                   0.,
                   1.,
                   "-",
                   "Of the damper on velocities that one integration point "
                   "does not see.");
  }

  FluidLaw parse_law(ParameterHandler &prm, const std::string &entry)
  {
    const std::string kind = prm.get("Material");
    const double gamma = read_double(prm, "Gamma");
    if (kind == "ideal gas")
      return IdealGas(gamma);
    const auto &jwl = find_explosive(prm.get("Explosive")).jwl;
    if (kind == "jwl")
      return MieGrueneisen::jwl(jwl);
    if (kind == "jwl in air")
      return MieGrueneisen::jwl_in_air(jwl, gamma);
    const std::string least = prm.get("Least pressure");
    const Expression density(entry + "/Density", prm.get("Density"));
    if (density.depends_on_place())
      throw InputError(entry + "/Density: that of Tait's liquid without "
                               "pressure must be a number");
    return Tait(density.value({}),
                read_double(prm, "Bulk modulus"),
                read_double(prm, "Exponent"),
                least == "none"
                  ? -std::numeric_limits<double>::infinity()
                  : Expression(entry + "/Least pressure", least).value({}));
  }
} // namespace


void RegionDescriptions::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Region *");
  declare_state(prm);
  declare_material(prm);
  declare_viscosity(prm);
}


Region RegionDescriptions::parse_region(ParameterHandler &prm,
                                        const std::string &name)
{
  Region region;
  region.name = name;
  region.law = parse_law(prm, "Region " + name);
  region.viscosity = {read_double(prm, "Linear viscosity"),
                      read_double(prm, "Quadratic viscosity"),
                      read_double(prm, "Hourglass coefficient")};
  return region;
}


void RegionDescriptions::parse_parameters(ParameterHandler &prm)
{
  for (const std::string &name : item_names(prm, "Region"))
  {
    const Section section(prm, "Region " + name);
    const auto expression = [&](const std::string &entry) {
      return Expression("Region " + name + "/" + entry, prm.get(entry));
    };
    descriptions_.push_back({parse_region(prm, name),
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


std::vector<Region> RegionDescriptions::regions() const
{
  std::vector<Region> result;
  for (const Description &description : descriptions_)
    result.push_back(description.region);
  return result;
}


void RegionDescriptions::set_regions(dealii::Triangulation<3> &mesh) const
{
  std::vector<std::size_t> count(descriptions_.size(), 0);
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const auto centre = cell->center();
    std::size_t region = descriptions_.size();
    for (std::size_t i = 0; i < descriptions_.size(); ++i)
      if (descriptions_[i].where.value(centre) != 0.)
        region = i;
    if (region == descriptions_.size())
      throw InputError("Region: the cell at (" + std::to_string(centre[0]) +
                       ", " + std::to_string(centre[1]) + ", " +
                       std::to_string(centre[2]) + ") m is in none");
    cell->set_material_id(static_cast<dealii::types::material_id>(region));
    ++count[region];
  }
  for (std::size_t i = 0; i < count.size(); ++i)
    if (count[i] == 0)
      throw InputError("Region " + descriptions_[i].region.name +
                       ": no cell has its centre there");
}


void RegionDescriptions::check_state(const Description &description,
                                     const dealii::Point<3> &centre,
                                     const double density,
                                     const double pressure,
                                     const double products) const
{
  const auto require = [&](const bool holds, const std::string &what) {
    if (!holds)
      throw InputError("Region " + description.region.name + "/" + what +
                       " in the cell at (" + brief(centre[0]) + ", " +
                       brief(centre[1]) + ", " + brief(centre[2]) + ") m");
  };
  require(density > 0.,
          "Density must be above 0, and is " + brief(density) + " kg/m^3");
  require(products >= 0. && products <= 1.,
          "Products must be from 0 to 1, and is " + brief(products));
  double square = 1.;
  if (const auto *const liquid = std::get_if<Tait>(&description.region.law))
    square = liquid->density_at(pressure) > 0. ? 1. : 0.;
  else if (const auto *const gas =
             std::get_if<IdealGas>(&description.region.law))
    square = gas->sound_speed_squared(density, pressure, products);
  else if (const auto *const other =
             std::get_if<MieGrueneisen>(&description.region.law))
    square = other->sound_speed_squared(density, pressure, products);
  require(square > 0.,
          "Pressure must leave the sound speed real and above 0, and is " +
            brief(pressure) + " Pa");
}


void RegionDescriptions::fill_cell(const HexSpace &space,
                                   const std::size_t cell,
                                   AleState &state) const
{
  const Description &description = at(space, cell);
  HexVectors<double> corners;
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      corners[i][d] = state.position[width * space.cell(cell)[i] + d];
  const auto moments = hex_moments(corners);
  const dealii::Point<3> centre(moments.first[0] / moments.volume,
                                moments.first[1] / moments.volume,
                                moments.first[2] / moments.volume);
  const double pressure = description.pressure.value(centre);
  const double products = description.products.value(centre);
  double density = description.density.value(centre);
  check_state(description, centre, density, pressure, products);
  double energy = 0.; // per volume
  if (const auto *const liquid = std::get_if<Tait>(&description.region.law))
  {
    density = liquid->density_at(pressure);
    energy = density * liquid->stored_energy(density);
  }
  else if (const auto *const gas =
             std::get_if<IdealGas>(&description.region.law))
    energy = gas->internal_energy_density(density, pressure, products);
  else
    energy = std::get<MieGrueneisen>(description.region.law)
               .internal_energy_density(density, pressure, products);
  state.mass[cell] = density * moments.volume;
  state.energy[cell] = energy * moments.volume;
  state.products[cell] = products;
}


void RegionDescriptions::fill(const HexSpace &space, AleState &state) const
{
  state.velocity.resize(width * space.n_nodes());
  state.mass.resize(space.n_cells());
  state.energy.resize(space.n_cells());
  state.products.resize(space.n_cells());
  for (std::size_t c = 0; c < space.n_cells(); ++c)
    fill_cell(space, c, state);
  for (std::size_t n = 0; n < space.n_nodes(); ++n)
  {
    const double *x = &state.position[width * n];
    const dealii::Point<3> place(x[0], x[1], x[2]);
    // Where regions meet, the mean of their velocities by mass.
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
      state.velocity[width * n + d] = momentum[d] / mass;
  }
}


double
RegionDescriptions::largest_speed(const dealii::Triangulation<3> &mesh) const
{
  double largest = 0.;
  for (const auto &cell : mesh.active_cell_iterators())
  {
    const Description &description = descriptions_[cell->material_id()];
    const auto centre = cell->center();
    const double pressure = description.pressure.value(centre);
    const double products = description.products.value(centre);
    check_state(description,
                centre,
                description.density.value(centre),
                pressure,
                products);
    double square = 0.;
    std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        double p = 0.;
        if constexpr (std::is_same_v<Law, Tait>)
          law.pressure_and_sound_speed(
            law.density_at(pressure), 0., 0., p, square);
        else
          square = law.sound_speed_squared(
            description.density.value(centre), pressure, products);
      },
      description.region.law);
    double speed = 0.;
    for (const Expression &velocity : description.velocity)
      speed += std::pow(velocity.value(centre), 2);
    largest =
      std::max(largest, std::sqrt(std::max(square, 0.)) + std::sqrt(speed));
  }
  return largest;
}
} // namespace contrecoup::ale
