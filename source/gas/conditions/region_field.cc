// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/region_field.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::gas
{
namespace
{
  constexpr double infinity = std::numeric_limits<double>::infinity();

  void declare_region(ParameterHandler &prm)
  {
    declare_selection(
      prm,
      "Shape",
      "sphere",
      {"sphere", "box", "half space"},
      selecting("Points within Radius of the Center, points between "
                "two corners, or points on the side of the plane "
                "through Center that Normal does not point to."));
    for (const auto &[name, shapes] :
         {std::pair<std::string, std::string>("Center", "sphere, half space"),
          {"Lower corner", "box"},
          {"Upper corner", "box"}})
      declare_list(prm,
                   name,
                   "0, 0, 0",
                   1,
                   3,
                   -bounds::length,
                   bounds::length,
                   "m",
                   used_with("Shape = " + shapes,
                             "Position in the coordinates of the mesh; missing "
                             "coordinates are zero."));
    declare_double(prm,
                   "Radius",
                   "0.1",
                   bounds::smallest_length,
                   bounds::length,
                   "m",
                   used_with("Shape = sphere", "Radius of a sphere."));
    declare_list(prm,
                 "Normal",
                 "1, 0, 0",
                 1,
                 3,
                 -bounds::direction,
                 bounds::direction,
                 "-",
                 used_with("Shape = half space",
                           "Outward normal of a half space, of any length."));
    declare_bool(prm,
                 "Burned explosive",
                 "false",
                 "Whether the region is the explosive of the Material, burned "
                 "at constant volume and still at rest.");
    const UsedWith used("Burned explosive = false");
    declare_state(prm);
    declare_double(prm,
                   "Energy",
                   "0",
                   0.,
                   bounds::energy,
                   "J",
                   "If above 0: internal energy of the whole region, which "
                   "determines the pressure; Pressure then has no effect. "
                   "The energy on the mesh is as exact as the volume of the "
                   "region that the subcells sample.");
  }


  /// State of the explosive of @p material burned at constant volume, at rest.
  template <int dim>
  GasState<dim> burned_explosive(const GasMaterial &material,
                                 const std::string &where)
  {
    if (!(material.reference_density() > 0.))
      throw InputError(where + ": Burned explosive = true needs a Material "
                               "with an explosive, jwl or jwl in air");
    GasState<dim> state;
    state.density = material.reference_density();
    state.products = 1.;
    state.pressure = material.pressure(
      state.density, state.density * material.reference_energy(), 1.);
    check_state(state, material, where);
    return state;
  }
} // namespace


template <int dim>
void RegionField<dim>::declare_parameters(ParameterHandler &prm)
{
  {
    const Section section(prm, "Background");
    const UsedWith used("Initial state/Kind = uniform, regions");
    declare_state(prm);
  }
  const Section section(prm, "Region *");
  const UsedWith used("Initial state/Kind = regions");
  declare_region(prm);
}


template <int dim>
RegionField<dim>::RegionField(ParameterHandler &prm,
                              const GasMaterial &material,
                              const Geometry geometry,
                              const bool with_regions)
{
  {
    const Section section(prm, "Background");
    background_ = read_state<dim>(prm, material, "Initial state/Background");
  }
  if (!with_regions)
    return;
  for (const std::string &name : item_names(prm, "Initial state/Region"))
  {
    const Section section(prm, "Region " + name);
    regions_.push_back(
      read_region(prm, material, geometry, "Initial state/Region " + name));
  }
  if (regions_.empty())
    throw InputError("Initial state: Kind = regions needs at least one "
                     "subsection \"Region <name>\"");
}


template <int dim>
typename RegionField<dim>::Region
RegionField<dim>::read_region(ParameterHandler &prm,
                              const GasMaterial &material,
                              const Geometry geometry,
                              const std::string &where)
{
  Region region;
  region.shape = prm.get("Shape");
  region.center = dealii::Point<dim>(read_vector<dim>(prm, "Center", where));
  region.lower =
    dealii::Point<dim>(read_vector<dim>(prm, "Lower corner", where));
  region.upper =
    dealii::Point<dim>(read_vector<dim>(prm, "Upper corner", where));
  region.normal = read_direction<dim>(prm, "Normal", where);
  region.radius = read_double(prm, "Radius");
  if (region.shape == "box")
    for (unsigned int d = 0; d < dim; ++d)
      if (!(region.lower[d] < region.upper[d]))
        throw InputError(
          where +
          ": each coordinate of Lower corner = " + prm.get("Lower corner") +
          " must be below that of Upper corner = " + prm.get("Upper corner"));

  const double energy = read_double(prm, "Energy");
  if (prm.get_bool("Burned explosive"))
    region.state = burned_explosive<dim>(material, where);
  else if (energy > 0.)
  {
    if (region.shape == "half space")
      throw InputError(where + ": Energy must be 0 for Shape = half space, "
                               "which has no finite volume");
    region.state =
      read_state<dim>(prm, material, where, energy / volume(region, geometry));
  }
  else
    region.state = read_state<dim>(prm, material, where);
  return region;
}


template <int dim>
double RegionField<dim>::volume(const Region &region, const Geometry geometry)
{
  using boost::math::double_constants::pi;
  const unsigned int n = dim + radial_exponent(geometry);
  if (region.shape == "sphere")
    return (n == 1 ? 2. : (n == 2 ? pi : 4. / 3. * pi)) *
           std::pow(region.radius, n);

  const double power = radial_exponent(geometry) + 1.;
  const double angle = (power == 1.) ? 1. : (power == 2. ? pi : 4. / 3. * pi);
  double volume = angle * (std::pow(region.upper[0], power) -
                           std::pow(region.lower[0], power));
  for (unsigned int d = 1; d < dim; ++d)
    volume *= region.upper[d] - region.lower[d];
  return volume;
}


template <int dim>
GasState<dim> RegionField<dim>::value(const dealii::Point<dim> &point) const
{
  for (auto region = regions_.rbegin(); region != regions_.rend(); ++region)
    if (signed_distance(*region, point) < 0.)
      return region->state;
  return background_;
}


template <int dim>
double RegionField<dim>::smallest_feature() const
{
  double smallest = infinity;
  for (const Region &region : regions_)
    if (region.shape == "sphere")
      smallest = std::min(smallest, region.radius);
    else if (region.shape == "box")
      for (unsigned int d = 0; d < dim; ++d)
        smallest = std::min(smallest, region.upper[d] - region.lower[d]);
  return smallest;
}


template <int dim>
double
RegionField<dim>::distance_to_feature(const dealii::Point<dim> &point) const
{
  double nearest = infinity;
  for (const Region &region : regions_)
    nearest = std::min(nearest, std::abs(signed_distance(region, point)));
  return nearest;
}


template <int dim>
double RegionField<dim>::signed_distance(const Region &region,
                                         const dealii::Point<dim> &point)
{
  if (region.shape == "sphere")
    return point.distance(region.center) - region.radius;
  if (region.shape == "half space")
    return region.normal * (point - region.center);

  double deepest = -infinity;
  dealii::Tensor<1, dim> outside;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double beyond =
      std::max(region.lower[d] - point[d], point[d] - region.upper[d]);
    deepest = std::max(deepest, beyond);
    outside[d] = std::max(beyond, 0.);
  }
  return (deepest < 0.) ? deepest : outside.norm();
}


template class RegionField<1>;
template class RegionField<2>;
template class RegionField<3>;
} // namespace contrecoup::gas
