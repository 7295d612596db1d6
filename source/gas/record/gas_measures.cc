// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/octree/leaf_metric.h>
#include <contrecoup/gas/octree/node_volumes.h>
#include <contrecoup/gas/octree/radial_nodes.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/quadrature_lib.h>

namespace contrecoup::gas
{
namespace
{
  /// Computed and exact state at one position, with the volume of its
  /// quadrature point.
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

  /// Absolute errors of density, velocity and pressure.
  template <int dim>
  std::array<double, 3> errors_of(const Comparison<dim> &item)
  {
    return {{std::abs(item.computed.density - item.exact.density),
             (item.computed.velocity - item.exact.velocity).norm(),
             std::abs(item.computed.pressure - item.exact.pressure)}};
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
                        point_volume(box, points, q)});
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
      const double volume = quadrature.weight(s) * box.jacobian(x) *
                            radial_power(points.exponent(), box.place(x)[0]);
      for (unsigned int d = 0; d < dim; ++d)
        line[d] = points.interpolation(x[d]);
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

  /// Integrals over the gas and extremes; minima are negated.
  struct Totals
  {
    explicit Totals(const unsigned int n_components)
      : sums(n_components + 1, 0.)
      , largest(4, std::numeric_limits<double>::lowest())
    {}

    std::vector<double> sums;    ///< conserved quantities, kinetic energy
    std::vector<double> largest; ///< -density, density, -pressure, pressure
  };

  /// Volumes of the points of a batch of leaves from @p first on; zero where
  /// there are none.
  template <int dim>
  void set_volumes(const unsigned int first,
                   const LeafMesh<dim> &mesh,
                   const LeafPoints<dim> &points,
                   LeafMetric<std::max(dim, 2)> *metric,
                   dealii::AlignedVector<Lanes<double>> &volumes)
  {
    if constexpr (dim > 1)
      if (metric != nullptr)
      {
        metric->reinit(mesh, first / double_width);
        for (unsigned int q = 0; q < volumes.size(); ++q)
          volumes[q] = metric->volume(q);
        return;
      }
    volumes.fill(Lanes<double>(0.));
    const bool is_plane = points.exponent() == 0;
    for (unsigned int lane = 0;
         lane < double_width && first + lane < mesh.n_owned();
         ++lane)
    {
      const LeafBox<dim> box = leaf_box(mesh, first + lane);
      if (!box.is_box())
      {
        const std::vector<double> parts = node_volumes(box, points);
        for (unsigned int q = 0; q < volumes.size(); ++q)
          volumes[q][lane] = parts[q];
        continue;
      }
      // In plane geometry the volumes of all points are alike up to a factor.
      const double whole = points.volume(box.origin, box.extents, 0) *
                           (1. / points.relative_volume(0));
      for (unsigned int q = 0; q < volumes.size(); ++q)
        volumes[q][lane] = is_plane ? whole * points.relative_volume(q)
                                    : points.volume(box.origin, box.extents, q);
    }
  }

  /// Adds up to double_width leaves from @p first_leaf on.
  template <int dim, typename Gas>
  void add_leaves(const unsigned int first_leaf,
                  const LeafMesh<dim> &mesh,
                  const dealii::AlignedVector<Lanes<double>> &volumes,
                  const GasField &field,
                  const Gas &gas,
                  Totals &totals)
  {
    using Number = Lanes<double>;
    using C = Component<dim>;
    constexpr unsigned int nc = n_conserved<dim, Gas>, n = double_width;

    std::array<Number, nc + 1> sums;
    sums.fill(Number(0.));
    const Number none(std::numeric_limits<double>::lowest());
    std::array<Number, 4> largest;
    largest.fill(none);
    for (unsigned int q = 0; q < field.layout().n_points; ++q)
    {
      Number volume = volumes[q];
      Number is_gas(1.);
      for (unsigned int lane = 0; lane < n && field.open_fractions() != nullptr;
           ++lane)
      {
        const double open_fraction = field.open_fraction(first_leaf + lane, q);
        volume[lane] *= open_fraction;
        is_gas[lane] = open_fraction;
      }
      std::array<Number, nc> u;
      for (unsigned int c = 0; c < nc; ++c)
      {
        u[c] = field.values(first_leaf, c, q);
        sums[c] += volume * u[c];
      }
      auto p = to_primitive<dim>(gas, u);
      for (unsigned int lane = 0; lane < n && field.burn() != nullptr; ++lane)
        p[C::pressure][lane] = field.exerted_pressure(
          p[C::pressure][lane], field.burned(first_leaf + lane, q));
      for (unsigned int d = 0; d < dim; ++d)
        sums[nc] += volume * p[C::velocity + d] * u[C::momentum + d] * 0.5;
      const auto if_gas = [&](const Number &value) {
        return select_less(Number(0.), is_gas, value, none);
      };
      largest[0] = std::max(largest[0], if_gas(Number(-p[C::density])));
      largest[1] = std::max(largest[1], if_gas(p[C::density]));
      largest[2] = std::max(largest[2], if_gas(Number(-p[C::pressure])));
      largest[3] = std::max(largest[3], if_gas(p[C::pressure]));
    }
    for (unsigned int lane = 0; lane < n && first_leaf + lane < mesh.n_owned();
         ++lane)
    {
      for (unsigned int c = 0; c <= nc; ++c)
        totals.sums[c] += sums[c][lane];
      for (unsigned int i = 0; i < 4; ++i)
        totals.largest[i] = std::max(totals.largest[i], largest[i][lane]);
    }
  }
} // namespace


template <int dim>
std::vector<NamedValue> gas_totals(const LeafMesh<dim> &mesh,
                                   const LeafPoints<dim> &points,
                                   const GasField &field,
                                   const GasMaterial &material)
{
  using C = Component<dim>;
  const unsigned int nc = field.layout().n_components;
  Totals totals(nc);
  std::optional<LeafMetric<std::max(dim, 2)>> metric;
  if (!mesh.coarse_mesh().is_axis_aligned() && !points.is_galerkin())
    metric.emplace(field.layout().n);
  dealii::AlignedVector<Lanes<double>> volumes(field.layout().n_points);
  std::visit(
    [&](const auto &gas) {
      for (unsigned int leaf = 0; leaf < mesh.n_owned(); leaf += double_width)
      {
        set_volumes(leaf, mesh, points, metric ? &*metric : nullptr, volumes);
        add_leaves(leaf, mesh, volumes, field, gas, totals);
      }
    },
    material.model());
  dealii::Utilities::MPI::sum(totals.sums, mesh.communicator(), totals.sums);
  dealii::Utilities::MPI::max(
    totals.largest, mesh.communicator(), totals.largest);

  const std::array<const char *, 3> axes = {{"x", "y", "z"}};
  std::vector<NamedValue> result;
  result.push_back({"mass", "kg", totals.sums[C::density], true});
  for (unsigned int d = 0; d < dim; ++d)
    result.push_back({std::string("momentum_") + axes[d],
                      "kg m/s",
                      totals.sums[C::momentum + d]});
  result.push_back({"energy", "J", totals.sums[C::energy], true});
  result.push_back({"kinetic_energy", "J", totals.sums[nc]});
  if (material.has_products())
    result.push_back({"products_mass", "kg", totals.sums[C::products], true});
  result.push_back({"smallest_density", "kg/m^3", -totals.largest[0]});
  result.push_back({"largest_density", "kg/m^3", totals.largest[1]});
  result.push_back({"smallest_pressure", "Pa", -totals.largest[2]});
  result.push_back({"largest_pressure", "Pa", totals.largest[3]});
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
  // Volume, then L1, L2 and mean_L1 of each quantity.
  std::vector<double> sums(10, 0.);
  std::vector<double> largest(3, 0.);
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
  {
    const auto compare = [&](const auto &way) {
      return way(leaf_box(mesh, leaf),
                 points,
                 field.leaf(leaf),
                 field.layout().n_components,
                 material,
                 reference,
                 time);
    };
    auto means = compare(compare_means<dim>);
    // Only finite volumes (one item per subcell) support burn and rigid
    // bodies.
    for (unsigned int q = 0; q < means.size() && !points.is_galerkin(); ++q)
    {
      means[q].volume *= field.open_fraction(leaf, q);
      means[q].computed.pressure = field.exerted_pressure(
        means[q].computed.pressure, field.burned(leaf, q));
    }
    for (const auto &item :
         points.is_galerkin() ? compare(compare_polynomials<dim>) : means)
    {
      const auto errors = errors_of(item);
      sums[0] += item.volume;
      for (unsigned int i = 0; i < 3 && item.volume > 0.; ++i)
      {
        sums[1 + 2 * i] += item.volume * errors[i];
        sums[2 + 2 * i] += item.volume * errors[i] * errors[i];
        largest[i] = std::max(largest[i], errors[i]);
      }
    }
    for (const auto &item : means)
      for (unsigned int i = 0; i < 3; ++i)
        sums[7 + i] += item.volume * errors_of(item)[i];
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
    if (points.is_galerkin())
      result.push_back({name + "_mean_L1", units[i], sums[7 + i] / sums[0]});
  }
  return result;
}


#define CONTRECOUP_INSTANTIATE(dim)                                           \
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
