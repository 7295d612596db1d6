// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/leaf_sampling.h>

#include "run_lines.h"
#include <gtest/gtest.h>

#include <set>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
template <int dim>
double whole_volume(const LeafPoints<dim> &points, const LeafBox<dim> &box)
{
  double sum = 0.;
  for (unsigned int q = 0; q < dealii::Utilities::pow(points.n(), dim); ++q)
    sum += points.volume(box.origin, box.extents, q);
  return sum;
}


template <int dim>
LeafBox<dim> make_box()
{
  LeafBox<dim> box;
  for (unsigned int d = 0; d < dim; ++d)
  {
    box.origin[d] = 0.5 + d;
    box.extents[d] = 0.25 * (d + 1);
  }
  return box;
}
} // namespace


TEST(LeafLayout, ValuesFillABatchOnce)
{
  const LeafLayout layout(3, 4, 5);
  EXPECT_EQ(layout.n_points, 64u);
  EXPECT_EQ(layout.n_face_points, 16u);
  EXPECT_EQ(layout.batch_size(), 64u * 5 * double_width);
  std::set<std::size_t> seen;
  for (unsigned int leaf = 0; leaf < 2 * double_width; ++leaf)
    for (unsigned int c = 0; c < 5; ++c)
      for (unsigned int q = 0; q < 64; ++q)
        seen.insert(layout.offset(leaf) + layout.value(c, q));
  EXPECT_EQ(seen.size(), 2 * layout.batch_size());
  EXPECT_EQ(*seen.begin(), 0u);
  EXPECT_EQ(*seen.rbegin(), 2 * layout.batch_size() - 1);
}


TEST(LeafLayout, FacePointsLieBelowTheirFace)
{
  const unsigned int n = 4;
  for (unsigned int dim = 1; dim <= 3; ++dim)
  {
    const LeafLayout layout(dim, n, 5);
    for (unsigned int face = 0; face < 2 * dim; ++face)
      for (unsigned int depth = 0; depth < n; ++depth)
        for (unsigned int q = 0; q < layout.n_face_points; ++q)
        {
          unsigned int point = layout.face_point(face, q, depth), rest = q;
          for (unsigned int d = 0; d < dim; ++d, point /= n)
          {
            if (d == face / 2)
            {
              EXPECT_EQ(point % n, face % 2 ? n - 1 - depth : depth);
              continue;
            }
            // The other directions in increasing order number the face.
            EXPECT_EQ(point % n, rest % n);
            rest /= n;
          }
        }
    EXPECT_EQ(layout.stride(dim - 1) * n, layout.n_points);
  }
}


TEST(LeafPoints, VolumesAddUpToTheBody)
{
  for (const bool is_galerkin : {false, true})
    for (const unsigned int n : {2U, 3U, 4U})
    {
      const auto line = make_box<1>();
      EXPECT_NEAR(
        whole_volume(
          LeafPoints<1>(make_scheme(is_galerkin, n), Geometry::plane), line),
        0.25,
        1e-15);
      const auto box = make_box<3>();
      EXPECT_NEAR(
        whole_volume(
          LeafPoints<3>(make_scheme(is_galerkin, n), Geometry::plane), box),
        0.25 * 0.5 * 0.75,
        1e-15);
    }
  for (const bool is_galerkin : {false, true})
    for (const unsigned int n : {1U, 2U, 3U, 4U, 8U})
      for (const double inner : {0., 0.2, 0.25, 0.5})
      {
        if (is_galerkin && (n < 2 || n > 4))
          continue;
        const Scheme scheme = make_scheme(is_galerkin, n);
        auto line = make_box<1>();
        line.origin[0] = inner;
        auto box = make_box<2>();
        box.origin[0] = inner;
        const double outer = inner + 0.25;
        EXPECT_NEAR(
          whole_volume(LeafPoints<1>(scheme, Geometry::spherical), line),
          4. / 3. * M_PI * (outer * outer * outer - inner * inner * inner),
          1e-14);
        EXPECT_NEAR(
          whole_volume(LeafPoints<1>(scheme, Geometry::cylindrical), line),
          M_PI * (outer * outer - inner * inner),
          1e-14);
        EXPECT_NEAR(
          whole_volume(LeafPoints<2>(scheme, Geometry::axisymmetric), box),
          M_PI * (outer * outer - inner * inner) * 0.5,
          1e-14);
      }
}


TEST(LeafPoints, SubcellsFillTheEdgeAndHoldTheirPoint)
{
  for (const bool is_galerkin : {false, true})
    for (const unsigned int n : {2U, 3U, 4U})
    {
      const LeafPoints<1> points(make_scheme(is_galerkin, n), Geometry::plane);
      EXPECT_EQ(points.n(), n);
      EXPECT_EQ(points.is_galerkin(), is_galerkin);
      EXPECT_EQ(points.subcell_begin(0), 0.);
      EXPECT_EQ(points.subcell_end(n - 1), 1.);
      for (unsigned int i = 0; i < n; ++i)
      {
        if (i > 0)
        {
          EXPECT_EQ(points.subcell_begin(i), points.subcell_end(i - 1));
        }
        EXPECT_LE(points.subcell_begin(i), points.position(i));
        EXPECT_GE(points.subcell_end(i), points.position(i));
        EXPECT_NEAR(points.relative_volume(i),
                    points.subcell_end(i) - points.subcell_begin(i),
                    1e-15);
      }
      if (is_galerkin)
      {
        EXPECT_EQ(points.position(0), 0.);
        EXPECT_EQ(points.position(n - 1), 1.);
      }
    }
}


TEST(LeafPoints, InterpolationIsExactForPolynomials)
{
  for (const unsigned int n : {2U, 3U, 4U})
  {
    const LeafPoints<1> galerkin(make_scheme(true, n), Geometry::plane);
    for (const double x : {0., 0.1, 0.37, 0.5, 0.99, 1.})
    {
      const auto weights = galerkin.interpolation(x);
      for (unsigned int degree = 0; degree < n; ++degree)
      {
        double sum = 0.;
        for (unsigned int i = 0; i < n; ++i)
          sum += weights[i] * std::pow(galerkin.position(i), degree);
        EXPECT_NEAR(sum, std::pow(x, degree), 1e-14);
      }
    }
  }
  const LeafPoints<1> subcells(make_scheme(false, 8), Geometry::plane);
  for (const double x : {0., 0.03, 0.0625, 0.4, 0.51, 0.9375, 0.96, 1.})
  {
    const auto weights = subcells.interpolation(x);
    double sum = 0., place = 0.;
    for (unsigned int i = 0; i < 8; ++i)
    {
      EXPECT_GE(weights[i], 0.);
      sum += weights[i];
      place += weights[i] * subcells.position(i);
    }
    EXPECT_NEAR(sum, 1., 1e-15);
    // Constant beyond the outermost centres.
    EXPECT_NEAR(place, std::min(std::max(x, 0.0625), 0.9375), 1e-15);
  }
}


TEST(LeafSampling, StatesComeBack)
{
  dealii::ParameterHandler prm;
  GasMaterial::declare_parameters(prm);
  for (const std::string name :
       {"ideal gas", "stiffened gas", "jwl", "jwl in air"})
  {
    prm.enter_subsection("Material");
    prm.set("Equation of state", name);
    prm.leave_subsection();
    GasMaterial material;
    material.parse_parameters(prm);
    const unsigned int n = material.is_ideal() ? 5 : 6;
    GasState<3> state;
    state.density = 120.;
    state.velocity[0] = 100.;
    state.velocity[1] = -40.;
    state.velocity[2] = 7.;
    state.pressure = 3e8;
    state.products = material.has_products() ? 0.4 : 0.;
    const auto u = conserved_state(state, material, n);
    EXPECT_DOUBLE_EQ(u[0], 120.);
    EXPECT_DOUBLE_EQ(u[2], -4800.);
    const auto back = primitive_state<3>(u.data(), material);
    EXPECT_NEAR(back.density, state.density, 1e-12 * state.density);
    EXPECT_NEAR((back.velocity - state.velocity).norm(), 0., 1e-11);
    EXPECT_NEAR(back.pressure, state.pressure, 1e-12 * state.pressure);
    EXPECT_NEAR(back.products, state.products, 1e-15);
  }
}


TEST(LeafSampling, SmoothFieldsBecomeMeansOrNodalValues)
{
  const GasMaterial material;
  const auto box = make_box<2>();
  const auto field = [](const Point<2> &p) {
    GasState<2> state;
    state.density = 1. + p[0] + p[0] * p[1] * p[1];
    state.pressure = 1e5;
    return state;
  };
  const LeafPoints<2> subcells(make_scheme(false, 4), Geometry::plane);
  const auto means =
    sample_leaf<2>(field, box, subcells, material, 4, false, 4);
  const LeafPoints<2> nodes(make_scheme(true, 4), Geometry::plane);
  const auto values = sample_leaf<2>(field, box, nodes, material, 4, false, 4);
  for (unsigned int q = 0; q < 16; ++q)
  {
    const auto index = subcells.indices(q);
    const auto low = box.place({index[0] / 4., index[1] / 4.});
    const auto high = box.place({(index[0] + 1) / 4., (index[1] + 1) / 4.});
    const double x = 0.5 * (low[0] + high[0]);
    const double yy =
      (low[1] * low[1] + low[1] * high[1] + high[1] * high[1]) / 3.;
    EXPECT_NEAR(means[q], 1. + x + x * yy, 1e-13);
    EXPECT_NEAR(means[3 * 16 + q], 2.5e5, 1e-8);

    const auto node =
      box.place({nodes.position(index[0]), nodes.position(index[1])});
    EXPECT_NEAR(values[q], field(node).density, 1e-8);
  }
}


TEST(LeafSampling, JumpsAreSharedByVolume)
{
  // Dense gas below a radius inside the third of four subcells.
  const GasMaterial material;
  LeafBox<1> box;
  box.origin[0] = 0.;
  box.extents[0] = 1.;
  const double radius = 0.625;
  const auto field = [&](const Point<1> &p) {
    GasState<1> state;
    state.density = p[0] < radius ? 10. : 1.;
    state.pressure = 1e5;
    return state;
  };
  const LeafPoints<1> points(make_scheme(false, 4), Geometry::spherical);
  const auto u = sample_leaf<1>(field, box, points, material, 3, true, 1000);
  const auto cube = [](const double x) { return x * x * x; };
  const double share = (cube(radius) - cube(0.5)) / (cube(0.75) - cube(0.5));
  EXPECT_NEAR(u[0], 10., 1e-12);
  EXPECT_NEAR(u[1], 10., 1e-12);
  EXPECT_NEAR(u[2], 1. + 9. * share, 1e-5);
  EXPECT_NEAR(u[3], 1., 1e-12);
}


TEST(LeafSampling, NodesOnTheRimTakeTheirOwnSide)
{
  // A jump on the common face of two leaves: each keeps its side's value.
  const GasMaterial material;
  const LeafPoints<1> points(make_scheme(true, 4), Geometry::plane);
  const auto field = [](const Point<1> &p) {
    GasState<1> state;
    state.density = p[0] < 0.5 ? 10. : 1.;
    state.pressure = 1e5;
    return state;
  };
  LeafBox<1> box;
  box.extents[0] = 0.5;
  for (const double origin : {0., 0.5})
  {
    box.origin[0] = origin;
    const auto u = sample_leaf<1>(field, box, points, material, 3, false, 4);
    for (unsigned int q = 0; q < 4; ++q)
      EXPECT_EQ(u[q], origin == 0. ? 10. : 1.);
  }
}


TEST(LeafSampling, CurvilinearNodesHoldWhatTheirSubcellsDo)
{
  dealii::ParameterHandler prm;
  GasMaterial::declare_parameters(prm);
  GasMaterial material;
  material.parse_parameters(prm);
  const auto ball = [](const Point<1> &p) {
    GasState<1> state;
    state.density = p[0] < 0.43 ? 5. : 1.;
    state.pressure = p[0] < 0.43 ? 1e7 : 1e5;
    return state;
  };
  for (const unsigned int n : {2U, 3U, 4U})
    for (const Geometry geometry : {Geometry::cylindrical, Geometry::spherical})
    {
      const LeafPoints<1> points(make_scheme(true, n), geometry);
      double mass = 0.;
      for (unsigned int leaf = 0; leaf < 4; ++leaf)
      {
        LeafBox<1> box;
        box.origin[0] = 0.25 * leaf;
        box.extents[0] = 0.25;
        const auto values =
          sample_leaf<1>(ball, box, points, material, 3, true, 1000);
        for (unsigned int q = 0; q < n; ++q)
          mass += values[q] * points.volume(box.origin, box.extents, q);
      }
      const double exact = geometry == Geometry::spherical
                             ? 4. / 3. * M_PI * (1. + 4. * std::pow(0.43, 3))
                             : M_PI * (1. + 4. * std::pow(0.43, 2));
      EXPECT_NEAR(mass / exact, 1., 1e-3);
    }
}
