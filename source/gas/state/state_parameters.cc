// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <cmath>
#include <limits>

namespace contrecoup::gas
{
void declare_state(ParameterHandler &prm)
{
  declare_double(prm,
                 "Density",
                 "1.225",
                 bounds::smallest_density,
                 bounds::density,
                 "kg/m^3",
                 "Mass per volume.");
  declare_list(prm,
               "Velocity",
               "0, 0, 0",
               1,
               3,
               -bounds::speed,
               bounds::speed,
               "m/s",
               "Velocity; missing components are zero.");
  declare_double(prm,
                 "Pressure",
                 "101325",
                 -bounds::pressure,
                 bounds::pressure,
                 "Pa",
                 "Absolute pressure; must exceed the lowest pressure of the "
                 "material at this density (0 for an ideal gas).");
  declare_double(prm,
                 "Products",
                 "0",
                 0.,
                 1.,
                 "-",
                 "Mass fraction of explosive products; no effect in "
                 "materials that are not mixtures.");
}


template <int dim>
GasState<dim> read_state(const ParameterHandler &prm,
                         const GasMaterial &material,
                         const std::string &where,
                         const std::optional<double> energy_density)
{
  GasState<dim> state;
  state.density = read_double(prm, "Density");
  state.velocity = read_vector<dim>(prm, "Velocity", where);
  state.products = read_double(prm, "Products");
  state.pressure =
    energy_density
      ? material.pressure(state.density, *energy_density, state.products)
      : read_double(prm, "Pressure");
  check_state(state, material, where);
  return state;
}


template <int dim>
void check_state(const GasState<dim> &state,
                 const GasMaterial &material,
                 const std::string &where)
{
  const auto refuse = [&](const std::string &name,
                          const double value,
                          const std::string &allowed) {
    throw InputError(where + ": " + name + " " + brief(value, 6) + " must be " +
                     allowed);
  };

  if (!(state.density > 0.) || !std::isfinite(state.density))
    refuse("density", state.density, "above 0 kg/m^3 and finite");
  if (!(state.products >= 0. && state.products <= 1.))
    refuse("mass fraction of products", state.products, "from 0 to 1");
  if (!std::isfinite(state.velocity.norm()))
    refuse("speed", state.velocity.norm(), "finite");

  const double lowest = material.pressure(
    state.density,
    material.least_energy_density(state.density, state.products),
    state.products);
  if (!(state.pressure > lowest) || !std::isfinite(state.pressure))
    refuse("pressure",
           state.pressure,
           "finite and above " + brief(lowest, 6) + " Pa, " +
             (!material.has_products() && material.explosive().B < 0.
                ? "below which the sound speed is not real"
                : "the lowest that this material has") +
             " at a density of " + brief(state.density, 6) + " kg/m^3");
}


template <int dim>
dealii::Tensor<1, dim> read_vector(const ParameterHandler &prm,
                                   const std::string &name,
                                   const std::string &where)
{
  const std::vector<double> numbers = read_list(prm, name);
  dealii::Tensor<1, dim> vector;
  for (unsigned int d = 0; d < numbers.size(); ++d)
    if (d < dim)
      vector[d] = numbers[d];
    else if (numbers[d] != 0.)
      throw InputError(where + ": " + name + " = " + prm.get(name) +
                       " has more than the " + std::to_string(dim) +
                       " component(s) of this domain");
  return vector;
}


template <int dim>
dealii::Tensor<1, dim> read_direction(const ParameterHandler &prm,
                                      const std::string &name,
                                      const std::string &where)
{
  const dealii::Tensor<1, dim> vector = read_vector<dim>(prm, name, where);
  if (!(vector.norm() > 0.))
    throw InputError(where + ": " + name + " = " + prm.get(name) +
                     " must have a component that is not zero");
  return vector / vector.norm();
}


#define INSTANTIATE(dim)                                                 \
  template GasState<dim> read_state<dim>(const ParameterHandler &,       \
                                         const GasMaterial &,            \
                                         const std::string &,            \
                                         std::optional<double>);         \
  template void check_state<dim>(                                        \
    const GasState<dim> &, const GasMaterial &, const std::string &);    \
  template dealii::Tensor<1, dim> read_vector<dim>(                      \
    const ParameterHandler &, const std::string &, const std::string &); \
  template dealii::Tensor<1, dim> read_direction<dim>(                   \
    const ParameterHandler &, const std::string &, const std::string &);
INSTANTIATE(1)
INSTANTIATE(2)
INSTANTIATE(3)
#undef INSTANTIATE
} // namespace contrecoup::gas
