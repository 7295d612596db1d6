// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/gas_measures.h>
#include <contrecoup/gas/primitive.h>

#include <deal.II/base/quadrature_lib.h>

namespace contrecoup::gas
{
namespace
{
  /// Density, velocity, pressure of one leaf and of the exact solution at
  /// one place, with the volume they stand for.
  template <int dim>
  struct Comparison
  {
    GasState<dim> computed;
    GasState<dim> exact;
    double volume;
  };

  template <int dim>
  GasState<dim> state_at(const std::vector<double> &leaf,
                         const unsigned int q,
                         const unsigned int n_points,
                         const GasMaterial &material)
  {
    std::vector<double> u(leaf.size() / n_points);
    for (unsigned int c = 0; c < u.size(); ++c)
      u[c] = leaf[c * n_points + q];
    return primitive_state<dim>(u.data(), material);
  }

  template <int dim>
  std::vector<Comparison<dim>>
  compare_means(const LeafBox<dim> &box,
                const LeafPoints<dim> &points,
                const std::vector<double> &leaf,
                const unsigned int n_components,
                const GasMaterial &material,
                const ReferenceSolution<dim> &reference,
                const double time)
  {
    const auto field = [&](const dealii::Point<dim> &p) {
      return reference.value(p, time);
    };
    const unsigned int n_points = leaf.size() / n_components;
    const auto exact = sample_leaf<dim>(
      field, box, points, material, n_components, true, dim == 1 ? 8 : 4);
    std::vector<Comparison<dim>> result;
    for (unsigned int q = 0; q < n_points; ++q)
      result.push_back({state_at<dim>(leaf, q, n_points, material),
                        state_at<dim>(exact, q, n_points, material),
                        points.volume(box.origin, box.extents, q)});
    return result;
  }

  template <int dim>
  std::vector<Comparison<dim>>
  compare_polynomials(const LeafBox<dim> &box,
                      const LeafPoints<dim> &points,
                      const std::vector<double> &leaf,
                      const unsigned int n_components,
                      const GasMaterial &material,
                      const ReferenceSolution<dim> &reference,
                      const double time)
  {
    const dealii::QGauss<dim> quadrature(points.n() + 2);
    const unsigned int n_points = leaf.size() / n_components;
    std::vector<Comparison<dim>> result;
    for (unsigned int s = 0; s < quadrature.size(); ++s)
    {
      const auto &x = quadrature.point(s);
      std::array<std::vector<double>, dim> line;
      double volume = quadrature.weight(s);
      for (unsigned int d = 0; d < dim; ++d)
      {
        line[d] = points.interpolation(x[d]);
        volume *= box.extents[d];
      }
      std::vector<double> u(n_components, 0.);
      for (unsigned int q = 0; q < n_points; ++q)
      {
        const auto index = points.indices(q);
        double weight = 1.;
        for (unsigned int d = 0; d < dim; ++d)
          weight *= line[d][index[d]];
        for (unsigned int c = 0; c < n_components; ++c)
          u[c] += weight * leaf[c * n_points + q];
      }
      result.push_back({primitive_state<dim>(u.data(), material),
                        reference.value(box.place(x), time),
                        volume});
    }
    return result;
  }
} // namespace


template <int dim>
LeafBox<dim> leaf_box(const LeafMesh<dim> &mesh, const unsigned int leaf)
{
  LeafBox<dim> box;
  for (unsigned int d = 0; d < dim; ++d)
  {
    box.origin[d] = mesh.origins(leaf / W)[d][leaf % W];
    box.extents[d] = mesh.extents(leaf / W)[d][leaf % W];
  }
  return box;
}


template <int dim>
std::vector<NamedValue> gas_totals(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material)
{
  using C = Component<dim>;
  const unsigned int nc = field.layout().n_components;
  const unsigned int np = field.layout().n_points;
  std::vector<double> totals(nc + 1, 0.); // and kinetic energy
  double extremes[4];
  std::fill(extremes, extremes + 4, std::numeric_limits<double>::lowest());
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const auto box = leaf_box(mesh, leaf);
    const auto values = field.leaf(leaf);
    std::vector<double> sums(nc + 1, 0.);
    for (unsigned int q = 0; q < np; ++q)
    {
      const double volume = points.volume(box.origin, box.extents, q);
      const GasState<dim> state = state_at<dim>(values, q, np, material);
      for (unsigned int c = 0; c < nc; ++c)
        sums[c] += volume * values[c * np + q];
      sums[nc] += 0.5 * volume * state.density * state.velocity.norm_square();
      extremes[0] = std::max(extremes[0], -state.density);
      extremes[1] = std::max(extremes[1], state.density);
      extremes[2] = std::max(extremes[2], -state.pressure);
      extremes[3] = std::max(extremes[3], state.pressure);
    }
    for (unsigned int c = 0; c <= nc; ++c)
      totals[c] += sums[c];
  }
  dealii::Utilities::MPI::sum(totals, mesh.communicator(), totals);
  for (double &extreme : extremes)
    extreme = dealii::Utilities::MPI::max(extreme, mesh.communicator());

  const std::array<const char *, 3> axes = {{"x", "y", "z"}};
  std::vector<NamedValue> result;
  result.push_back({"mass", "kg", totals[C::density], true});
  for (unsigned int d = 0; d < dim; ++d)
    result.push_back(
      {std::string("momentum_") + axes[d], "kg m/s", totals[C::momentum + d]});
  result.push_back({"energy", "J", totals[C::energy], true});
  result.push_back({"kinetic_energy", "J", totals[nc]});
  if (nc > C::products)
    result.push_back({"products_mass", "kg", totals[C::products], true});
  result.push_back({"smallest_density", "kg/m^3", -extremes[0]});
  result.push_back({"largest_density", "kg/m^3", extremes[1]});
  result.push_back({"smallest_pressure", "Pa", -extremes[2]});
  result.push_back({"largest_pressure", "Pa", extremes[3]});
  return result;
}


template <int dim>
std::vector<NamedValue> gas_errors(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material,
                                   const ReferenceSolution<dim> &reference,
                                   const double time)
{
  std::vector<double> sums(7, 0.); // volume, then L1 and L2 of each
  std::vector<double> largest(3, 0.);
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const auto compare =
      points.is_galerkin() ? compare_polynomials<dim> : compare_means<dim>;
    for (const auto &item : compare(leaf_box(mesh, leaf),
                                    points,
                                    field.leaf(leaf),
                                    field.layout().n_components,
                                    material,
                                    reference,
                                    time))
    {
      const double errors[] = {
        std::abs(item.computed.density - item.exact.density),
        (item.computed.velocity - item.exact.velocity).norm(),
        std::abs(item.computed.pressure - item.exact.pressure)};
      sums[0] += item.volume;
      for (unsigned int i = 0; i < 3; ++i)
      {
        sums[1 + 2 * i] += item.volume * errors[i];
        sums[2 + 2 * i] += item.volume * errors[i] * errors[i];
        largest[i] = std::max(largest[i], errors[i]);
      }
    }
  }
  dealii::Utilities::MPI::sum(sums, mesh.communicator(), sums);
  dealii::Utilities::MPI::max(largest, mesh.communicator(), largest);

  const char *const names[] = {"density", "velocity", "pressure"};
  const char *const units[] = {"kg/m^3", "m/s", "Pa"};
  std::vector<NamedValue> result;
  for (unsigned int i = 0; i < 3; ++i)
  {
    const std::string name = names[i];
    result.push_back({name + "_L1", units[i], sums[1 + 2 * i] / sums[0]});
    result.push_back(
      {name + "_L2", units[i], std::sqrt(sums[2 + 2 * i] / sums[0])});
    result.push_back({name + "_Linf", units[i], largest[i]});
  }
  return result;
}


#define CONTRECOUP_INSTANTIATE(dim)                                           \
  template LeafBox<dim> leaf_box(const LeafMesh<dim> &, unsigned int);        \
  template std::vector<NamedValue> gas_totals(const LeafMesh<dim> &,          \
                                              const LeafPoints<dim> &,        \
                                              const GasField &,               \
                                              const GasMaterial &);           \
  template std::vector<NamedValue> gas_errors(const LeafMesh<dim> &,          \
                                              const LeafPoints<dim> &,        \
                                              const GasField &,               \
                                              const GasMaterial &,            \
                                              const ReferenceSolution<dim> &, \
                                              double)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
