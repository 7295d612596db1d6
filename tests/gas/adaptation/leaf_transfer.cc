// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/adaptation/leaf_transfer.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include "../../set_entries.h"
#include "gas_run.h"
#include <gtest/gtest.h>

#include <random>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
GasMaterial make_material(const bool mixture)
{
  return described<GasMaterial>(mixture ? products_in_air()
                                        : std::vector<std::string>());
}


/// A leaf, its transfer and its volumes.
template <int dim>
struct Parent
{
  Parent(const bool is_galerkin,
         const unsigned int n,
         const Geometry geometry,
         const bool mixture)
    : points(make_scheme(is_galerkin, n), geometry)
    , layout(dim, n, dim + 2 + (mixture ? 1 : 0))
    , material(make_material(mixture))
    , transfer(points, layout, material)
  {
    for (unsigned int d = 0; d < dim; ++d)
    {
      box.origin[d] = 0.3 + 0.1 * d;
      box.extents[d] = 0.5 + 0.2 * d;
    }
  }

  LeafBox<dim> child_box(const unsigned int child) const
  {
    LeafBox<dim> result = box;
    result.extents *= 0.5;
    for (unsigned int d = 0; d < dim; ++d)
      if ((child >> d) & 1U)
        result.origin[d] += result.extents[d];
    return result;
  }

  /// Integral of each component over one leaf.
  std::vector<double> integral(const std::vector<double> &values,
                               const LeafBox<dim> &where) const
  {
    std::vector<double> sum(layout.n_components, 0.);
    for (unsigned int c = 0; c < layout.n_components; ++c)
      for (unsigned int q = 0; q < layout.n_points; ++q)
        sum[c] += values[c * layout.n_points + q] *
                  points.volume(where.origin, where.extents, q);
    return sum;
  }

  std::vector<double>
  integral(const std::vector<std::vector<double>> &children) const
  {
    std::vector<double> sum(layout.n_components, 0.);
    for (unsigned int child = 0; child < children.size(); ++child)
    {
      const auto part = integral(children[child], child_box(child));
      for (unsigned int c = 0; c < sum.size(); ++c)
        sum[c] += part[c];
    }
    return sum;
  }

  /// Smallest density and smallest energy above the cold gas, in units of
  /// the leaf's first point's.
  bool is_admissible(const std::vector<double> &values) const
  {
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      const double density = values[q];
      double kinetic = 0.;
      for (unsigned int d = 0; d < dim; ++d)
        kinetic += 0.5 * values[(1 + d) * layout.n_points + q] *
                   values[(1 + d) * layout.n_points + q] / density;
      const double products =
        layout.n_components > dim + 2
          ? values[(dim + 2) * layout.n_points + q] / density
          : 0.;
      if (!(density > 0.) ||
          !(values[(dim + 1) * layout.n_points + q] - kinetic >
            material.least_energy_density(density, products)))
        return false;
    }
    return true;
  }

  /// Rough admissible values: densities and thermal energies over @p decades
  /// powers of ten, Mach numbers of the order of @p mach.
  std::vector<double> rough(const double decades,
                            const unsigned int seed,
                            const double mach = 3.) const
  {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> any(-1., 1.);
    std::vector<double> values(layout.n_components * layout.n_points);
    for (unsigned int q = 0; q < layout.n_points; ++q)
    {
      GasState<dim> state;
      state.density =
        std::min(std::pow(10., 0.5 * decades * any(engine)), 2000.);
      if (layout.n_components > dim + 2)
        state.products = 0.5 + 0.5 * any(engine);
      const double thermal = 2.5e5 * std::pow(10., 0.5 * decades * any(engine));
      state.pressure = material.pressure(
        state.density,
        material.least_energy_density(state.density, state.products) + thermal,
        state.products);
      const double speed = std::sqrt(thermal / state.density);
      for (unsigned int d = 0; d < dim; ++d)
        state.velocity[d] = mach * speed * any(engine);
      const auto u = conserved_state(state, material, layout.n_components);
      for (unsigned int c = 0; c < u.size(); ++c)
        values[c * layout.n_points + q] = u[c];
    }
    return values;
  }

  LeafPoints<dim> points;
  LeafLayout layout;
  GasMaterial material;
  LeafTransfer<dim> transfer;
  LeafBox<dim> box;
};


/// Compares leaf values, each component in units of its largest number.
void expect_close(const std::vector<double> &a,
                  const std::vector<double> &b,
                  const unsigned int n_points,
                  const double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (unsigned int first = 0; first < b.size(); first += n_points)
  {
    double scale = 0.;
    for (unsigned int q = first; q < first + n_points; ++q)
      scale = std::max(scale, std::abs(b[q]));
    for (unsigned int q = first; q < first + n_points; ++q)
      EXPECT_NEAR(a[q], b[q], tolerance * scale) << "number " << q;
  }
}


/// Each component of the rough leaf, sums in units of the absolute values.
template <int dim>
void check_conservation(const Parent<dim> &parent)
{
  for (unsigned int seed = 1; seed <= 5; ++seed)
    for (const double decades : {0.1, 2., 8.})
    {
      const auto values = parent.rough(decades, seed);
      ASSERT_TRUE(parent.is_admissible(values));
      const auto before = parent.integral(values, parent.box);
      std::vector<double> absolute = values;
      for (double &value : absolute)
        value = std::abs(value);
      const auto scale = parent.integral(absolute, parent.box);

      const auto children = parent.transfer.to_children(values, parent.box);
      const auto halved = parent.integral(children);
      for (const auto &child : children)
        EXPECT_TRUE(parent.is_admissible(child)) << decades << " " << seed;

      const auto merged = parent.transfer.from_children(children, parent.box);
      const auto back = parent.integral(merged, parent.box);
      for (unsigned int c = 0; c < before.size(); ++c)
      {
        EXPECT_NEAR(halved[c], before[c], 1e-14 * scale[c]);
        EXPECT_NEAR(back[c], before[c], 1e-14 * scale[c]);
      }

      // Children that do not come from one parent.
      std::vector<std::vector<double>> foreign;
      for (unsigned int child = 0; child < children.size(); ++child)
        foreign.push_back(parent.rough(decades, 100 * seed + child));
      const auto sum = parent.integral(foreign);
      auto absolute_children = foreign;
      for (auto &child : absolute_children)
        for (double &value : child)
          value = std::abs(value);
      const auto foreign_scale = parent.integral(absolute_children);
      const auto projected = parent.integral(
        parent.transfer.from_children(foreign, parent.box), parent.box);
      for (unsigned int c = 0; c < before.size(); ++c)
        EXPECT_NEAR(projected[c], sum[c], 1e-14 * foreign_scale[c]);
    }
}


/// Children of a leaf come together to the leaf.
template <int dim>
void check_round_trip(const Parent<dim> &parent, const double tolerance)
{
  for (unsigned int seed = 1; seed <= 5; ++seed)
  {
    const auto values = parent.rough(0.05, seed, 0.05);
    const auto children = parent.transfer.to_children(values, parent.box);
    const auto back = parent.transfer.from_children(children, parent.box);
    expect_close(back, values, parent.layout.n_points, tolerance);
  }
}


/// Values of density = f at all points, everything else constant.
template <int dim>
std::vector<double>
density_values(const Parent<dim> &parent,
               const LeafBox<dim> &box,
               const std::function<double(const Point<dim> &)> &f)
{
  std::vector<double> values(parent.layout.n_components *
                             parent.layout.n_points);
  for (unsigned int q = 0; q < parent.layout.n_points; ++q)
  {
    const auto index = parent.points.indices(q);
    Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = parent.points.position(index[d]);
    values[q] = f(box.place(x));
    values[(dim + 1) * parent.layout.n_points + q] = 2.5e5;
  }
  return values;
}
} // namespace


TEST(LeafTransfer, FiniteVolumesConserve)
{
  for (const unsigned int n : {1U, 2U, 4U, 8U})
  {
    check_conservation(Parent<2>(false, n, Geometry::plane, false));
    check_conservation(Parent<2>(false, n, Geometry::axisymmetric, false));
    check_conservation(Parent<2>(false, n, Geometry::plane, true));
    check_conservation(Parent<2>(false, n, Geometry::axisymmetric, true));
    check_conservation(Parent<3>(false, n, Geometry::plane, false));
  }
  check_conservation(Parent<3>(false, 4, Geometry::plane, true));
}


TEST(LeafTransfer, GalerkinConserves)
{
  for (const unsigned int n : {2U, 3U, 4U, 6U})
  {
    check_conservation(Parent<2>(true, n, Geometry::plane, false));
    check_conservation(Parent<2>(true, n, Geometry::plane, true));
    check_conservation(Parent<3>(true, n, Geometry::plane, false));
    for (const double inner : {0., 0.3, 0.7})
    {
      Parent<2> parent(true, n, Geometry::axisymmetric, true);
      parent.box.origin[0] = inner;
      check_conservation(parent);
    }
  }
  check_conservation(Parent<3>(true, 4, Geometry::plane, true));
}


TEST(LeafTransfer, ChildrenComeTogetherToTheirParent)
{
  for (const unsigned int n : {1U, 2U, 4U, 8U})
  {
    check_round_trip(Parent<2>(false, n, Geometry::plane, false), 1e-14);
    check_round_trip(Parent<2>(false, n, Geometry::axisymmetric, false), 1e-14);
    check_round_trip(Parent<3>(false, n, Geometry::plane, false), 1e-14);
  }
  for (const unsigned int n : {2U, 3U, 4U})
  {
    check_round_trip(Parent<2>(true, n, Geometry::plane, false), 1e-14);
    check_round_trip(Parent<2>(true, n, Geometry::plane, true), 1e-14);
    check_round_trip(Parent<3>(true, n, Geometry::plane, false), 1e-14);
  }
}


TEST(LeafTransfer, PolynomialsStayExact)
{
  for (const unsigned int n : {2U, 3U, 4U})
  {
    const Parent<3> parent(true, n, Geometry::plane, false);
    const auto f = [n](const Point<3> &x) {
      return 2. + std::pow(x[0], n - 1.) + std::pow(x[1] - x[2], n - 1.) +
             x[0] * x[1] * x[2];
    };
    const auto values = density_values<3>(parent, parent.box, f);
    const auto children = parent.transfer.to_children(values, parent.box);
    for (unsigned int child = 0; child < 8; ++child)
      expect_close(children[child],
                   density_values<3>(parent, parent.child_box(child), f),
                   parent.layout.n_points,
                   1e-14);
    expect_close(parent.transfer.from_children(children, parent.box),
                 values,
                 parent.layout.n_points,
                 1e-14);
  }
}


TEST(LeafTransfer, LinearFieldsStayExactInsideFiniteVolumeLeaves)
{
  const Parent<2> parent(false, 8, Geometry::plane, false);
  const auto f = [](const Point<2> &x) { return 2. + x[0] - 0.5 * x[1]; };
  const auto values = density_values<2>(parent, parent.box, f);
  const auto children = parent.transfer.to_children(values, parent.box);
  for (unsigned int child = 0; child < 4; ++child)
  {
    const auto exact = density_values<2>(parent, parent.child_box(child), f);
    for (unsigned int q = 0; q < 64; ++q)
    {
      // The subcells at the parent's rim have neighbours on one side only.
      const auto index = parent.points.indices(q);
      bool inside = true;
      for (unsigned int d = 0; d < 2; ++d)
      {
        const unsigned int place = ((child >> d) & 1U) * 8 + index[d];
        inside = inside && place >= 2 && place < 14;
      }
      if (inside)
      {
        EXPECT_NEAR(children[child][q], exact[q], 1e-14);
      }
    }
  }
}


TEST(LeafTransfer, UniformGasStaysUniform)
{
  for (const bool is_galerkin : {false, true})
  {
    const Parent<3> parent(is_galerkin, 4, Geometry::plane, false);
    const auto values = density_values<3>(
      parent, parent.box, [](const Point<3> &) { return 1.2345; });
    for (const auto &child : parent.transfer.to_children(values, parent.box))
      expect_close(child, values, 64, is_galerkin ? 1e-15 : 0.);
  }
}


TEST(LeafTransfer, NearVacuumStaysAdmissible)
{
  // One point of an almost empty leaf is filled with hot dense gas.
  for (const bool is_galerkin : {false, true})
    for (const bool mixture : {false, true})
      for (unsigned int q = 0; q < 16; ++q)
      {
        const Parent<2> parent(is_galerkin, 4, Geometry::plane, mixture);
        std::vector<double> values(parent.layout.n_components * 16);
        for (unsigned int p = 0; p < 16; ++p)
        {
          GasState<2> state;
          state.density = p == q ? 1630. : 1e-9;
          state.pressure = p == q ? 2e10 : 1e-5;
          state.velocity[0] = p == q ? 3000. : -5000.;
          state.products = p == q ? 1. : 0.;
          const auto u =
            conserved_state(state, parent.material, parent.layout.n_components);
          for (unsigned int c = 0; c < u.size(); ++c)
            values[c * 16 + p] = u[c];
        }
        ASSERT_TRUE(parent.is_admissible(values));
        const auto children = parent.transfer.to_children(values, parent.box);
        for (const auto &child : children)
          EXPECT_TRUE(parent.is_admissible(child)) << "point " << q;
        EXPECT_TRUE(parent.is_admissible(
          parent.transfer.from_children(children, parent.box)));
        // Four such leaves side by side, merged.
        const std::vector<std::vector<double>> four(4, values);
        EXPECT_TRUE(
          parent.is_admissible(parent.transfer.from_children(four, parent.box)))
          << "merged, point " << q << (is_galerkin ? " galerkin" : "")
          << (mixture ? " mixture" : "");
      }
}
