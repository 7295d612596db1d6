// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/scene/scene_bursts.h>
#include <contrecoup/gas/scene/scene_places.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <cmath>

namespace contrecoup::gas
{
template <int dim>
std::vector<NamedCharge<dim>> read_charges(ParameterHandler &prm,
                                           const GasMaterial &material,
                                           const CoarseMesh<dim> &mesh)
{
  std::vector<NamedCharge<dim>> charges;
  if (!(material.reference_density() > 0.))
    return charges;
  for (const std::string &name : item_names(prm, "Charges/Charge"))
  {
    const Section section(prm, "Charges");
    const Section charge(prm, "Charge " + name);
    const std::string where = "Charges/Charge " + name;
    charges.push_back(
      {where,
       read_double(prm, "Mass"),
       Charge<dim>(prm, mesh.geometry(), material.reference_density(), where)});
  }
  return charges;
}


namespace
{
  /// Bursts of the initial state: balls and a point source.
  template <int dim>
  void add_initial_bursts(ParameterHandler &prm,
                          std::vector<Burst<dim>> &bursts)
  {
    const auto names = item_names(prm, "Initial state/Region");
    const Section section(prm, "Initial state");
    const std::string kind = prm.get("Kind");
    const auto add = [&](const std::string &name, const bool is_explosion) {
      const Section item(prm, name);
      const std::string where = "Initial state/" + name;
      const dealii::Point<dim> center(read_vector<dim>(prm, "Center", where));
      bursts.push_back(
        {where, center, 2. * read_double(prm, "Radius"), 0., is_explosion, {}});
    };
    if (kind == "sedov")
      add("Sedov", true);
    if (kind == "regions")
      for (const std::string &name : names)
        if (prm.get({"Region " + name}, "Shape") == "sphere")
          add("Region " + name,
              prm.get_bool({"Region " + name}, "Burned explosive"));
  }


  std::string name_of_side(const unsigned int side)
  {
    return std::string(1, "xyz"[side / 2]) + (side % 2 == 0 ? " low" : " high");
  }


  template <int dim>
  double place_of_side(const CoarseMesh<dim> &mesh, const unsigned int side)
  {
    return (side % 2 == 0 ? mesh.lower_corner()
                          : mesh.upper_corner())[side / 2];
  }


  /// Number of explosions with their images, and their explosive [kg].
  template <int dim>
  std::pair<unsigned int, double>
  count_all(const std::vector<Burst<dim>> &bursts)
  {
    std::pair<unsigned int, double> all{0, 0.};
    for (const Burst<dim> &burst : bursts)
    {
      const unsigned int images = 1U << burst.mirrors.size();
      all.first += burst.is_explosion ? images : 0;
      all.second += images * burst.mass;
    }
    return all;
  }


  template <int dim>
  void warn_of_images(const std::vector<Burst<dim>> &bursts,
                      const CoarseMesh<dim> &mesh,
                      std::vector<std::string> &lines)
  {
    const auto [number, mass] = count_all(bursts);
    const bool has_mass =
      mass > 0. && dim + radial_exponent(mesh.geometry()) == 3;
    const std::string all =
      ", " + std::to_string(number) +
      (has_mass ? " charges of " + brief(mass) + " kg" : " explosions") +
      " in all";
    for (const Burst<dim> &burst : bursts)
      for (const unsigned int side : burst.mirrors)
      {
        const double place = place_of_side(mesh, side);
        const std::string entry = "Boundaries/" + name_of_side(side);
        lines.push_back(
          "WARNING: " + burst.where + " is " +
          brief(std::abs(burst.center[side / 2] - place)) +
          " m away from the plane of symmetry " +
          std::string(1, "xyz"[side / 2]) + " = " + brief(place) +
          " m: its mirror image is computed as well" +
          (burst.is_explosion ? all : "") +
          "; to leave it out, let the domain reach beyond that plane; if the "
          "plane is a rigid wall or the ground, set " +
          entry + " = wall");
      }
  }


  /// Warns of air around explosives that is colder or hotter than any on
  /// Earth, as of a pressure in another unit, and of other air than the
  /// tables'.
  void warn_of_air(ParameterHandler &prm,
                   const bool has_tables,
                   std::vector<std::string> &lines)
  {
    constexpr double gas_constant = 287.05;          // of air [J/(kg K)]
    constexpr double coldest = 150., hottest = 600.; // [K]
    constexpr double of_tables = 101325.;            // [Pa]
    constexpr double tolerance = 0.1;
    const Section section(prm, "Initial state");
    const Section background(prm, "Background");
    const double pressure = read_double(prm, "Pressure"),
                 density = read_double(prm, "Density");
    const double temperature = pressure / (density * gas_constant);
    const std::string where =
      "WARNING: Initial state/Background: " + brief(pressure, 6) + " Pa";
    if (temperature < coldest || temperature > hottest)
      lines.push_back(where + " and " + brief(density) +
                      " kg/m^3 are those of air of " + brief(temperature, 3) +
                      " K");
    else if (has_tables &&
             std::abs(pressure - of_tables) > tolerance * of_tables)
      lines.push_back(where +
                      ", but the tables of Kingery and Bulmash are for " +
                      brief(of_tables, 6) + " Pa");
  }


  template <int dim>
  void check_reference(ParameterHandler &prm,
                       const Burst<dim> &charge,
                       std::vector<std::string> &lines)
  {
    constexpr double tolerance = 0.01;
    const Section section(prm, "Reference");
    const Section tables(prm, "Kingery Bulmash");
    const auto tell = [&](const std::string &entry, const std::string &known) {
      lines.push_back("WARNING: Reference/Kingery Bulmash/" + entry + " = " +
                      prm.get(entry) + ", but " + charge.where + " has " +
                      known + ": the reference is that of another charge");
    };
    // With its image, a charge on the ground is one of twice its mass.
    const double share = prm.get("Burst") == "spherical" ? 1. : 0.5;
    const double mass = read_double(prm, "Mass");
    if (std::abs(mass - charge.mass) > tolerance * charge.mass &&
        std::abs(mass - share * charge.mass) > tolerance * charge.mass)
      tell("Mass", brief(charge.mass) + " kg");
    const auto numbers = read_list(prm, "Center");
    dealii::Point<dim> place;
    for (unsigned int d = 0; d < std::min<std::size_t>(dim, numbers.size());
         ++d)
      place[d] = numbers[d];
    if (place.distance(charge.center) > tolerance * charge.size)
      tell("Center", "its centre at " + coordinates(charge.center) + " m");
  }
} // namespace


template <int dim>
std::vector<Burst<dim>> read_bursts(ParameterHandler &prm,
                                    const GasMaterial &material,
                                    const CoarseMesh<dim> &mesh)
{
  std::vector<Burst<dim>> bursts;
  if (!mesh.is_axis_aligned())
    return bursts;
  for (const NamedCharge<dim> &one : read_charges(prm, material, mesh))
  {
    const auto [lower, upper] = one.charge.bounds();
    bursts.push_back({one.where,
                      lower + 0.5 * (upper - lower),
                      one.charge.smallest_size(),
                      one.charge.volume() * material.reference_density(),
                      true,
                      {}});
  }
  add_initial_bursts(prm, bursts);
  const auto planes = planes_of_symmetry(prm, mesh);
  const Section section(prm, "Boundaries");
  for (Burst<dim> &burst : bursts)
    for (unsigned int side = 0; side < 2 * dim; ++side)
    {
      const double distance =
        std::abs(burst.center[side / 2] - place_of_side(mesh, side));
      if (planes[side / 2] && prm.get(name_of_side(side)) == "symmetry" &&
          distance > 1e-9 * burst.size)
        burst.mirrors.push_back(side);
    }
  return bursts;
}


template <int dim>
bool has_several_explosions(const std::vector<Burst<dim>> &bursts)
{
  return count_all(bursts).first > 1;
}


template <int dim>
std::vector<std::string> remarks_on_bursts(ParameterHandler &prm,
                                           const GasMaterial &material,
                                           const CoarseMesh<dim> &mesh)
{
  const auto bursts = read_bursts(prm, material, mesh);
  std::vector<std::string> lines;
  warn_of_images(bursts, mesh, lines);
  const bool has_tables = prm.get({"Reference"}, "Kind") == "kingery bulmash";
  if (count_all(bursts).second > 0.)
    warn_of_air(prm, has_tables, lines);
  if (!has_tables)
    return lines;
  if (has_several_explosions(bursts))
    lines.push_back("WARNING: Reference/Kind = kingery bulmash describes one "
                    "charge, but there are " +
                    std::to_string(count_all(bursts).first) +
                    " with all mirror images: nothing is compared with it");
  // Charges that are infinite to the waves have no mass.
  else if (!bursts.empty() && bursts[0].mass > 0. &&
           dim + radial_exponent(mesh.geometry()) == 3)
    check_reference(prm, bursts[0], lines);
  return lines;
}


#define CONTRECOUP_INSTANTIATE(dim)                                      \
  template std::vector<NamedCharge<dim>> read_charges(                   \
    ParameterHandler &, const GasMaterial &, const CoarseMesh<dim> &);   \
  template std::vector<Burst<dim>> read_bursts(                          \
    ParameterHandler &, const GasMaterial &, const CoarseMesh<dim> &);   \
  template bool has_several_explosions(const std::vector<Burst<dim>> &); \
  template std::vector<std::string> remarks_on_bursts(                   \
    ParameterHandler &, const GasMaterial &, const CoarseMesh<dim> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
