// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/conditions/classical_fields.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::gas
{
namespace
{

  void declare_center(ParameterHandler &prm)
  {
    declare_list(prm,
                 "Center",
                 "0, 0, 0",
                 1,
                 3,
                 -bounds::length,
                 bounds::length,
                 "m",
                 "Position of the centre; missing coordinates are zero.");
  }


  void declare_ambient(ParameterHandler &prm, const std::string &pressure)
  {
    declare_double(prm,
                   "Density",
                   "1",
                   bounds::smallest_density,
                   bounds::density,
                   "kg/m^3",
                   "Mass per volume of the undisturbed gas.");
    declare_double(prm,
                   "Pressure",
                   pressure,
                   -bounds::pressure,
                   bounds::pressure,
                   "Pa",
                   "Absolute pressure of the undisturbed gas; must exceed "
                   "the lowest pressure of the material at this density.");
  }


  template <int dim>
  GasState<dim> read_ambient(const ParameterHandler &prm,
                             const GasMaterial &material,
                             const std::string &where)
  {
    GasState<dim> state;
    state.density = read_double(prm, "Density");
    state.pressure = read_double(prm, "Pressure");
    check_state(state, material, where);
    return state;
  }


  void declare_positive(ParameterHandler &prm,
                        const std::string &name,
                        const std::string &default_value,
                        const std::string &unit,
                        const std::string &sentence)
  {
    declare_double(prm, name, default_value, 1e-9, 1e12, unit, sentence);
  }
} // namespace


template <int dim>
void SedovField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Sedov");
  const UsedWith used("Initial state/Kind = sedov");
  declare_positive(prm,
                   "Energy",
                   "0.851072",
                   "J",
                   "Energy released in all directions (J/m around an axis, "
                   "J/m^2 and to one side in 1-D plane geometry), even where "
                   "the domain contains only a part of it.");
  declare_positive(prm,
                   "Radius",
                   "0.02",
                   "m",
                   "Radius a of the deposit, whose energy density is "
                   "proportional to exp(-(r/a)^2); the mesh must resolve it.");
  declare_center(prm);
  declare_ambient(prm, "1e-6");
}


template <int dim>
SedovField<dim>::SedovField(ParameterHandler &prm,
                            const GasMaterial &material,
                            const Geometry geometry)
  : spreading(dim + radial_exponent(geometry))
  , material_(material)
{
  const std::string where = "Initial state/Sedov";
  const Section section(prm, "Sedov");
  energy = read_double(prm, "Energy");
  radius = read_double(prm, "Radius");
  center = dealii::Point<dim>(read_vector<dim>(prm, "Center", where));
  ambient = read_ambient<dim>(prm, material, where);
}


template <int dim>
GasState<dim> SedovField<dim>::value(const dealii::Point<dim> &point) const
{
  using boost::math::double_constants::root_pi;
  const double volume =
    std::pow(root_pi * radius, spreading) * (spreading == 1 ? 0.5 : 1.);
  const double square = (point - center).norm_square() / (radius * radius);

  GasState<dim> state = ambient;
  state.pressure = material_.pressure(
    state.density,
    material_.internal_energy_density(state.density, state.pressure, 0.) +
      energy / volume * std::exp(-square),
    0.);
  return state;
}


template <int dim>
double SedovField<dim>::smallest_feature() const
{
  return radius;
}


template <int dim>
double
SedovField<dim>::distance_to_feature(const dealii::Point<dim> &point) const
{
  // At six radii the energy density has fallen to 2e-16 of its peak.
  return std::max(0., point.distance(center) - 6. * radius);
}


template <int dim>
void NohField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Noh");
  const UsedWith used("Initial state/Kind = noh");
  declare_positive(prm, "Speed", "1", "m/s", "Speed towards the centre.");
  declare_center(prm);
  declare_ambient(prm, "1e-6");
}


template <int dim>
NohField<dim>::NohField(ParameterHandler &prm,
                        const GasMaterial &material,
                        const Geometry geometry)
  : spreading(dim + radial_exponent(geometry))
{
  const std::string where = "Initial state/Noh";
  const Section section(prm, "Noh");
  speed = read_double(prm, "Speed");
  center = dealii::Point<dim>(read_vector<dim>(prm, "Center", where));
  ambient = read_ambient<dim>(prm, material, where);
}


template <int dim>
GasState<dim> NohField<dim>::value(const dealii::Point<dim> &point) const
{
  const double distance = point.distance(center);
  GasState<dim> state = ambient;
  if (distance > 0.)
    state.velocity = (center - point) * (speed / distance);
  return state;
}


template <int dim>
void VortexField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Vortex");
  const UsedWith used("Initial state/Kind = vortex");
  declare_double(prm,
                 "Strength",
                 "5",
                 -1e6,
                 1e6,
                 "-",
                 "Circulation beta in units of the core radius and of "
                 "sqrt(pressure/density).");
  declare_positive(prm, "Radius", "1", "m", "Radius of the core.");
  declare_positive(
    prm, "Period", "10", "m", "Side of the periodic box in x and y.");
  declare_center(prm);
  declare_list(prm,
               "Velocity",
               "1, 1, 0",
               1,
               3,
               -bounds::speed,
               bounds::speed,
               "m/s",
               "Velocity of gas and vortex; missing components are zero.");
  declare_ambient(prm, "1");
}


template <int dim>
VortexField<dim>::VortexField(ParameterHandler &prm,
                              const GasMaterial &material,
                              const Geometry geometry)
  : axial_velocity_(0.)
{
  const std::string where = "Initial state/Vortex";
  if (dim == 1 || geometry != Geometry::plane)
    throw InputError(where + ": needs Domain/Dimension = 2 or 3 and "
                             "Domain/Geometry = plane");
  if (!material.is_ideal())
    throw InputError(where + ": needs an ideal gas as the material");

  const Section section(prm, "Vortex");
  const GasState<dim> ambient = read_ambient<dim>(prm, material, where);
  const auto center = read_vector<dim>(prm, "Center", where);
  const auto velocity = read_vector<dim>(prm, "Velocity", where);
  solution_.gamma = material.ideal().gamma();
  solution_.strength = read_double(prm, "Strength");
  solution_.radius = read_double(prm, "Radius");
  solution_.period = read_double(prm, "Period");
  solution_.density = ambient.density;
  solution_.pressure = ambient.pressure;
  for (unsigned int d = 0; d < std::min<unsigned int>(dim, 2); ++d)
  {
    solution_.center[d] = center[d];
    solution_.velocity[d] = velocity[d];
  }
  if (dim == 3)
    axial_velocity_ = velocity[dim - 1];
  if (!solution_.is_admissible())
    throw InputError(where + ": Strength = " + prm.get("Strength") +
                     " would make the core colder than absolute zero");
}


template <int dim>
GasState<dim> VortexField<dim>::value(const dealii::Point<dim> &point) const
{
  return value(point, 0.);
}


template <int dim>
GasState<dim> VortexField<dim>::value(const dealii::Point<dim> &point,
                                      const double time) const
{
  const VortexSolution::State vortex =
    solution_.value(point[0], point[dim > 1 ? 1 : 0], time);
  GasState<dim> state;
  state.density = vortex.density;
  state.pressure = vortex.pressure;
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = (d < 2) ? vortex.velocity[d] : axial_velocity_;
  return state;
}


template <int dim>
double VortexField<dim>::smallest_feature() const
{
  return solution_.radius;
}


template class SedovField<1>;
template class SedovField<2>;
template class SedovField<3>;
template class NohField<1>;
template class NohField<2>;
template class NohField<3>;
template class VortexField<1>;
template class VortexField<2>;
template class VortexField<3>;
} // namespace contrecoup::gas
