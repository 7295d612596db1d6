// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
const double amplitude = 1e-7;
const double density = 1.4;

/// Standing sound waves of amplitude 1e-7 in a closed vessel of radius (and
/// height) 1, sound speed 1: relative pressure at a radius and its slope.
struct Standing
{
  explicit Standing(const std::string &geometry)
    : geometry(geometry)
    , k(geometry == "spherical" ? 4.493409457909064 : 3.831705970207512)
  {}

  double pressure(const double r) const
  {
    if (geometry == "spherical")
      return r == 0. ? 1. : std::sin(k * r) / (k * r);
    return std::cyl_bessel_j(0., k * r);
  }

  double slope(const double r) const
  {
    if (geometry == "spherical")
      return r == 0. ? 0. : (std::cos(k * r) - std::sin(k * r) / (k * r)) / r;
    return -k * std::cyl_bessel_j(1., k * r);
  }

  template <int dim>
  GasState<dim> state(const Point<dim> &p, const double time) const
  {
    const double m = dim == 2 ? M_PI : 0.;
    const double omega = std::hypot(k, m);
    const double z = dim == 2 ? p[dim - 1] : 0.;
    const double wave =
      amplitude * pressure(p[0]) * std::cos(m * z) * std::cos(omega * time);
    const double swing = -amplitude * std::sin(omega * time) / omega / density;
    GasState<dim> state;
    state.density = density * (1. + wave / 1.4);
    state.pressure = 1. + wave;
    state.velocity[0] = swing * slope(p[0]) * std::cos(m * z);
    if (dim == 2)
      state.velocity[dim - 1] = swing * pressure(p[0]) * -m * std::sin(m * z);
    return state;
  }

  std::string geometry;
  double k;
};


/// Mean absolute error of the pressure at t = 0.5, in amplitudes.
template <int dim>
double error(const std::string &geometry,
             const unsigned int degree,
             const unsigned int refinement,
             const bool hanging)
{
  GasRun<dim> run(galerkin(degree) +
                  std::vector<std::string>{"Domain/Geometry=" + geometry,
                                           "Domain/Initial refinement=" +
                                             std::to_string(refinement),
                                           "Method/CFL number=0.2"});
  if (hanging)
    run.refine(
      [](const Point<dim> &p) { return std::abs(p[dim - 1] - 0.5) < 0.25; });
  const Standing wave(geometry);
  run.set_state([&](const Point<dim> &p) { return wave.state<dim>(p, 0.); });
  const double end = 0.5;
  while (run.time < end * (1. - 1e-12))
  {
    const double stable = run.stepper->stable_step();
    EXPECT_FALSE(run.step(std::min(1., (end - run.time) / stable)).failed);
  }
  double sum = 0., volume = 0.;
  for (unsigned int leaf = 0; leaf < run.mesh.n_owned(); ++leaf)
  {
    const auto values = run.field.leaf(leaf);
    const LeafBox<dim> box = leaf_box(run.mesh, leaf);
    for (unsigned int q = 0; q < run.layout.n_points; ++q)
    {
      std::vector<double> u;
      for (unsigned int c = 0; c < dim + 2; ++c)
        u.push_back(values[c * run.layout.n_points + q]);
      Point<dim> x;
      for (unsigned int d = 0; d < dim; ++d)
        x[d] = run.points.position(run.points.indices(q)[d]);
      const double v = point_volume(box, run.points, q);
      sum += v / amplitude *
             std::abs(primitive_state<dim>(u.data(), run.material).pressure -
                      wave.state<dim>(box.place(x), run.time).pressure);
      volume += v;
    }
  }
  return sum / volume;
}


template <int dim>
void check_order(const std::string &geometry,
                 const unsigned int degree,
                 const unsigned int refinement,
                 const double order,
                 const bool hanging = false)
{
  const double coarse = error<dim>(geometry, degree, refinement, hanging);
  const double fine = error<dim>(geometry, degree, refinement + 1, hanging);
  EXPECT_GT(std::log2(coarse / fine), order)
    << geometry << ", degree " << degree << ": " << coarse << ", " << fine;
}
} // namespace


// The leaves at the axis are finite volumes of second order. They are the
// smaller a part of the whole the more directions meet there.
TEST(RadialGalerkin, StandingWavesInASphere)
{
  check_order<1>("spherical", 1, 4, 1.8);
  check_order<1>("spherical", 2, 4, 2.8);
  check_order<1>("spherical", 3, 4, 3.6);
}


TEST(RadialGalerkin, StandingWavesInACylinder)
{
  check_order<1>("cylindrical", 1, 4, 1.8);
  check_order<1>("cylindrical", 2, 4, 2.8);
  check_order<1>("cylindrical", 3, 4, 2.9);
}


TEST(RadialGalerkin, StandingWavesInAVessel)
{
  for (const bool hanging : {false, true})
  {
    check_order<2>("axisymmetric", 1, 3, 1.7, hanging);
    check_order<2>("axisymmetric", 2, 2, 2.5, hanging);
    check_order<2>("axisymmetric", 3, 2, 2.5, hanging);
  }
}
