// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/conditions/layer_fields.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace contrecoup::gas
{
namespace
{
  void declare_direction(ParameterHandler &prm)
  {
    declare_list(prm,
                 "Direction",
                 "1, 0, 0",
                 1,
                 3,
                 -bounds::direction,
                 bounds::direction,
                 "-",
                 "Normal of the planes, pointing to the right; any length.");
  }


  void declare_side(ParameterHandler &prm,
                    const std::string &side,
                    const std::string &density,
                    const std::string &pressure)
  {
    declare_double(prm,
                   side + " density",
                   density,
                   bounds::smallest_density,
                   bounds::density,
                   "kg/m^3",
                   "Mass per volume.");
    declare_double(prm,
                   side + " velocity",
                   "0",
                   -bounds::speed,
                   bounds::speed,
                   "m/s",
                   "Velocity along the direction, seen from the frame.");
    declare_double(prm,
                   side + " pressure",
                   pressure,
                   -bounds::pressure,
                   bounds::pressure,
                   "Pa",
                   "Absolute pressure; must exceed the lowest pressure of "
                   "the material at this density (0 for an ideal gas).");
    declare_double(prm,
                   side + " products",
                   "0",
                   0.,
                   1.,
                   "-",
                   "Mass fraction of explosive products; no effect in "
                   "materials that are not mixtures.");
  }


  GasState<1> read_side(const ParameterHandler &prm,
                        const std::string &side,
                        const GasMaterial &material)
  {
    GasState<1> state;
    state.density = read_double(prm, side + " density");
    state.velocity[0] = read_double(prm, side + " velocity");
    state.pressure = read_double(prm, side + " pressure");
    state.products = read_double(prm, side + " products");
    check_state(state, material, "Initial state/Riemann, " + side + " state");
    return state;
  }


  void declare_values(ParameterHandler &prm,
                      const std::string &name,
                      const std::string &default_value,
                      const std::pair<double, double> &range,
                      const std::string &unit,
                      const std::string &sentence)
  {
    declare_list(prm,
                 name,
                 default_value,
                 1,
                 1000,
                 range.first,
                 range.second,
                 unit,
                 sentence + " of each layer, from left to right.");
  }


  std::vector<double> read_values(const ParameterHandler &prm,
                                  const std::string &name,
                                  const std::size_t n_layers)
  {
    const std::vector<double> values = read_list(prm, name);
    if (values.size() != n_layers)
      throw InputError("Initial state/Layers: " + name + " = " + prm.get(name) +
                       " must have " + std::to_string(n_layers) +
                       " values, one more than Positions");
    return values;
  }
} // namespace


template <int dim>
void RiemannField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Riemann");
  const UsedWith used("Initial state/Kind = riemann");
  declare_double(prm,
                 "Position",
                 "0.5",
                 -bounds::length,
                 bounds::length,
                 "m",
                 "Distance of the plane from the origin, along the "
                 "direction.");
  declare_direction(prm);
  declare_list(prm,
               "Frame velocity",
               "0, 0, 0",
               1,
               3,
               -bounds::speed,
               bounds::speed,
               "m/s",
               "Velocity that is added to both sides; missing components "
               "are zero.");
  declare_side(prm, "Left", "1", "1");
  declare_side(prm, "Right", "0.125", "0.1");
}


template <int dim>
RiemannField<dim>::RiemannField(ParameterHandler &prm,
                                const GasMaterial &material)
{
  const std::string where = "Initial state/Riemann";
  const Section section(prm, "Riemann");
  position_ = read_double(prm, "Position");
  direction_ = read_direction<dim>(prm, "Direction", where);
  frame_velocity_ = read_vector<dim>(prm, "Frame velocity", where);
  left_ = read_side(prm, "Left", material);
  right_ = read_side(prm, "Right", material);
}


template <int dim>
GasState<dim> RiemannField<dim>::value(const dealii::Point<dim> &point) const
{
  return in_space(distance(point, 0.) < 0. ? left_ : right_);
}


template <int dim>
double
RiemannField<dim>::distance_to_feature(const dealii::Point<dim> &point) const
{
  return std::abs(distance(point, 0.));
}


template <int dim>
const GasState<1> &RiemannField<dim>::left() const
{
  return left_;
}


template <int dim>
const GasState<1> &RiemannField<dim>::right() const
{
  return right_;
}


template <int dim>
double RiemannField<dim>::distance(const dealii::Point<dim> &point,
                                   const double time) const
{
  return direction_ * (point - dealii::Point<dim>() - time * frame_velocity_) -
         position_;
}


template <int dim>
GasState<dim> RiemannField<dim>::in_space(const GasState<1> &state) const
{
  return {state.density,
          frame_velocity_ + state.velocity[0] * direction_,
          state.pressure,
          state.products};
}


template <int dim>
void LayerField<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Layers");
  const UsedWith used("Initial state/Kind = layers");
  declare_direction(prm);
  declare_list(prm,
               "Positions",
               "0.1, 0.9",
               1,
               999,
               -bounds::length,
               bounds::length,
               "m",
               "Distances of the planes between the layers from the origin, "
               "along the direction, increasing.");
  declare_values(prm,
                 "Densities",
                 "1, 1, 1",
                 {bounds::smallest_density, bounds::density},
                 "kg/m^3",
                 "Density");
  declare_values(prm,
                 "Velocities",
                 "0, 0, 0",
                 {-bounds::speed, bounds::speed},
                 "m/s",
                 "Velocity along the direction");
  declare_values(prm,
                 "Pressures",
                 "1000, 0.01, 100",
                 {-bounds::pressure, bounds::pressure},
                 "Pa",
                 "Absolute pressure");
  declare_values(
    prm, "Products", "0, 0, 0", {0., 1.}, "-", "Mass fraction of products");
}


template <int dim>
LayerField<dim>::LayerField(ParameterHandler &prm, const GasMaterial &material)
{
  const std::string where = "Initial state/Layers";
  const Section section(prm, "Layers");
  direction_ = read_direction<dim>(prm, "Direction", where);
  positions_ = read_list(prm, "Positions");
  if (std::adjacent_find(positions_.begin(),
                         positions_.end(),
                         std::greater_equal<double>()) != positions_.end())
    throw InputError(where + ": Positions = " + prm.get("Positions") +
                     " must increase");

  const std::size_t n_layers = positions_.size() + 1;
  const auto densities = read_values(prm, "Densities", n_layers);
  const auto velocities = read_values(prm, "Velocities", n_layers);
  const auto pressures = read_values(prm, "Pressures", n_layers);
  const auto products = read_values(prm, "Products", n_layers);
  for (std::size_t i = 0; i < n_layers; ++i)
  {
    states_.push_back(
      {densities[i], velocities[i] * direction_, pressures[i], products[i]});
    check_state(
      states_.back(), material, where + ", layer " + std::to_string(i + 1));
  }
}


template <int dim>
GasState<dim> LayerField<dim>::value(const dealii::Point<dim> &point) const
{
  const double position = direction_ * (point - dealii::Point<dim>());
  return states_[std::upper_bound(
                   positions_.begin(), positions_.end(), position) -
                 positions_.begin()];
}


template <int dim>
double LayerField<dim>::smallest_feature() const
{
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < positions_.size(); ++i)
    smallest = std::min(smallest, positions_[i] - positions_[i - 1]);
  return smallest;
}


template <int dim>
double
LayerField<dim>::distance_to_feature(const dealii::Point<dim> &point) const
{
  const double position = direction_ * (point - dealii::Point<dim>());
  double nearest = std::numeric_limits<double>::infinity();
  for (const double plane : positions_)
    nearest = std::min(nearest, std::abs(position - plane));
  return nearest;
}


template class RiemannField<1>;
template class RiemannField<2>;
template class RiemannField<3>;
template class LayerField<1>;
template class LayerField<2>;
template class LayerField<3>;
} // namespace contrecoup::gas
