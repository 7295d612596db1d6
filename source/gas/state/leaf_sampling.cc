// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/quadrature_lib.h>

namespace contrecoup::gas
{
namespace
{
  /// Quadrature along an edge of a subcell, from 0 to 1.
  dealii::Quadrature<1> edge_samples(const bool near_feature,
                                     const unsigned int n_samples)
  {
    if (!near_feature)
      return dealii::QGauss<1>(2);
    return dealii::QIterated<1>(dealii::QMidpoint<1>(), n_samples);
  }

  template <int dim>
  bool is_admissible(const std::vector<double> &values,
                     const unsigned int n_points,
                     const GasMaterial &material)
  {
    using C = Component<dim>;
    for (unsigned int q = 0; q < n_points; ++q)
    {
      const double density = values[C::density * n_points + q];
      double kinetic = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        kinetic +=
          0.5 / density * std::pow(values[(C::momentum + d) * n_points + q], 2);
      const double products = material.has_products()
                                ? values[C::products * n_points + q] / density
                                : 0.;
      if (!(density > 0.) ||
          !(values[C::energy * n_points + q] - kinetic >
            material.least_energy_density(density, products)))
        return false;
    }
    return true;
  }

  /// Corrects the content of a leaf. In curvilinear geometry the volume of a
  /// Galerkin node differs from that of the subcell whose mean it took. Scales
  /// the excess of each component over its minimum so that the leaf's integral
  /// equals that of the subcells, if the result is admissible.
  template <int dim>
  void restore_integrals(const LeafBox<dim> &box,
                         const LeafPoints<dim> &points,
                         const GasMaterial &material,
                         const unsigned int n_points,
                         std::vector<double> &values)
  {
    std::vector<double> scaled = values;
    for (unsigned int first = 0; first < values.size(); first += n_points)
    {
      const double smallest = *std::min_element(
        values.begin() + first, values.begin() + first + n_points);
      double wanted = 0., held = 0.;
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto index = points.indices(q);
        dealii::Point<dim> begin, end;
        for (unsigned int d = 0; d < dim; ++d)
        {
          begin[d] = points.subcell_begin(index[d]);
          end[d] = points.subcell_end(index[d]);
        }
        const double excess = values[first + q] - smallest;
        wanted += excess * points.volume(box.origin, box.extents, begin, end);
        held += excess * points.volume(box.origin, box.extents, q);
      }
      for (unsigned int q = 0; q < n_points && held > 0.; ++q)
        scaled[first + q] =
          smallest + (values[first + q] - smallest) * (wanted / held);
    }
    if (is_admissible<dim>(scaled, n_points, material))
      values = scaled;
  }
} // namespace


template <int dim>
std::vector<double> conserved_state(const GasState<dim> &state,
                                    const GasMaterial &material,
                                    const unsigned int n_components)
{
  using C = Component<dim>;
  std::vector<double> u(n_components);
  u[C::density] = state.density;
  for (unsigned int d = 0; d < dim; ++d)
    u[C::momentum + d] = state.density * state.velocity[d];
  u[C::energy] = material.internal_energy_density(
                   state.density, state.pressure, state.products) +
                 0.5 * state.density * state.velocity.norm_square();
  if (n_components > C::products)
    u[C::products] = state.density * state.products;
  return u;
}


template <int dim>
GasState<dim> primitive_state(const double *conserved,
                              const GasMaterial &material)
{
  using C = Component<dim>;
  GasState<dim> state;
  state.density = conserved[C::density];
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = conserved[C::momentum + d] / state.density;
  if (material.has_products())
    state.products = conserved[C::products] / state.density;
  state.pressure = material.pressure(
    state.density,
    conserved[C::energy] - 0.5 * state.density * state.velocity.norm_square(),
    state.products);
  return state;
}


template <int dim>
std::vector<double> sample_leaf(
  const std::function<GasState<dim>(const dealii::Point<dim> &)> &field,
  const LeafBox<dim> &box,
  const LeafPoints<dim> &points,
  const GasMaterial &material,
  const unsigned int n_components,
  const bool near_feature,
  const unsigned int n_samples)
{
  const unsigned int n_points = dealii::Utilities::pow(points.n(), dim);
  // A node on the leaf's boundary takes the value on this leaf's side of a
  // jump.
  const double inwards = 1e-10;
  const dealii::Quadrature<1> edge = edge_samples(near_feature, n_samples);
  const dealii::Quadrature<dim> samples((dealii::Quadrature<dim>(edge)));
  std::vector<double> result(std::size_t(n_components) * n_points);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const auto index = points.indices(q);
    // The mean is summed as a deviation from the first sample, so that all
    // subcells of a uniform field are bitwise equal.
    std::vector<double> first, sum(n_components, 0.);
    double volume = 0.;
    dealii::Point<dim> x;
    if (points.is_galerkin() && !near_feature)
    {
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = points.position(index[d]) +
               inwards * (0.5 - points.position(index[d]));
      first = conserved_state(field(box.place(x)), material, n_components);
      volume = 1.;
    }
    else
      for (unsigned int s = 0; s < samples.size(); ++s)
      {
        for (unsigned int d = 0; d < dim; ++d)
        {
          const double begin = points.subcell_begin(index[d]);
          const double end = points.subcell_end(index[d]);
          x[d] = begin + samples.point(s)[d] * (end - begin);
        }
        const double radius = box.place(x)[0];
        const double weight =
          samples.weight(s) * (!box.is_box()            ? box.jacobian(x)
                               : points.exponent() == 0 ? 1.
                               : points.exponent() == 1 ? radius
                                                        : radius * radius);
        const auto u =
          conserved_state(field(box.place(x)), material, n_components);
        if (first.empty())
          first = u;
        volume += weight;
        for (unsigned int c = 0; c < n_components; ++c)
          sum[c] += weight * (u[c] - first[c]);
      }
    for (unsigned int c = 0; c < n_components; ++c)
      result[c * n_points + q] = first[c] + sum[c] / volume;
  }
  if (points.is_galerkin() && near_feature && points.exponent() != 0)
    restore_integrals(box, points, material, n_points, result);
  return result;
}


#define CONTRECOUP_INSTANTIATE(dim)                                   \
  template std::vector<double> conserved_state(                       \
    const GasState<dim> &, const GasMaterial &, unsigned int);        \
  template GasState<dim> primitive_state<dim>(const double *,         \
                                              const GasMaterial &);   \
  template std::vector<double> sample_leaf(                           \
    const std::function<GasState<dim>(const dealii::Point<dim> &)> &, \
    const LeafBox<dim> &,                                             \
    const LeafPoints<dim> &,                                          \
    const GasMaterial &,                                              \
    unsigned int,                                                     \
    bool,                                                             \
    unsigned int)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
