// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "gas_run.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using namespace contrecoup::gas;
using dealii::Point;

namespace
{
/// A periodic box with hanging faces inside and across its sides.
template <int dim>
std::vector<std::string> periodic_box()
{
  return {std::string("Domain/Periodic directions=") +
            (dim == 2 ? "x, y" : "x, y, z"),
          "Domain/Coarse leaves=2, 2, 2",
          "Domain/Initial refinement=1"};
}


/// Waves of density, velocity and pressure, with a jump by a factor of five
/// across a ball.
template <int dim>
GasState<dim> waves(const Point<dim> &p, const bool mixture)
{
  double wave = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    wave += ripple(p[d], d + 1) / dim;
  Point<dim> centre;
  for (unsigned int d = 0; d < dim; ++d)
    centre[d] = 0.4;
  const bool inside = p.distance(centre) < 0.2;
  GasState<dim> state;
  state.density = 1.2 * (1. + 0.3 * wave) * (inside ? 3. : 1.);
  state.pressure = 1e5 * (1. + 0.2 * wave) * (inside ? 5. : 1.);
  for (unsigned int d = 0; d < dim; ++d)
    state.velocity[d] = 100. * (d + 1. + wave);
  if (mixture)
  {
    state.products = inside ? 1. : 0.;
    state.density *= inside ? 20. : 1.;
    state.pressure *= inside ? 50. : 1.;
  }
  return state;
}


/// Runs 10 steps; mass, momentum, energy and products stay.
template <int dim>
void check(const std::vector<std::string> &method, const bool mixture)
{
  GasRun<dim> run(periodic_box<dim>() + method +
                  (mixture ? products_in_air() : std::vector<std::string>{}));
  run.refine([](const Point<dim> &p) { return p.norm() < 0.6; });
  ASSERT_GT(dealii::Utilities::MPI::sum(run.mesh.hanging_faces().size(),
                                        MPI_COMM_WORLD),
            0u);
  run.set_state([&](const Point<dim> &p) { return waves(p, mixture); });
  const auto before = run.totals();
  run.steps(10);
  const auto after = run.totals();

  const auto change = [&](const std::string &name) {
    return after.at(name) - before.at(name);
  };
  const double tolerance = 1e-13;
  EXPECT_NEAR(change("mass"), 0., tolerance * before.at("mass"));
  EXPECT_NEAR(change("energy"), 0., tolerance * before.at("energy"));
  if (mixture)
  {
    EXPECT_NEAR(
      change("products_mass"), 0., tolerance * before.at("products_mass"));
  }
  // Momentum is exchanged at the rate of the pressure.
  const double momentum = std::sqrt(before.at("mass") * before.at("energy"));
  for (unsigned int d = 0; d < dim; ++d)
    EXPECT_NEAR(
      change("momentum_" + std::string(1, "xyz"[d])), 0., tolerance * momentum);
  // The gas has changed meanwhile.
  EXPECT_GT(std::abs(change("kinetic_energy")),
            1e-6 * before.at("kinetic_energy"));
}
} // namespace


TEST(Conservation, FiniteVolumes2d)
{
  for (const bool mixture : {false, true})
    for (const unsigned int n : {1U, 2U, 4U, 8U})
      check<2>(finite_volume(n), mixture);
}


TEST(Conservation, FiniteVolumes3d)
{
  for (const bool mixture : {false, true})
    for (const unsigned int n : {2U, 4U})
      check<3>(finite_volume(n), mixture);
}


TEST(Conservation, Galerkin2d)
{
  for (const bool mixture : {false, true})
    for (const unsigned int degree : {1U, 2U, 3U, 4U, 5U})
      check<2>(galerkin(degree), mixture);
}


TEST(Conservation, Galerkin3d)
{
  for (const bool mixture : {false, true})
    for (const unsigned int degree : {1U, 2U, 3U})
      check<3>(galerkin(degree), mixture);
}


TEST(Conservation, EveryFlux)
{
  for (const std::string &flux : names_of(riemann_fluxes))
  {
    check<2>(finite_volume(4) + std::vector<std::string>{"Method/Flux=" + flux},
             false);
    check<2>(galerkin(2) + std::vector<std::string>{"Method/Flux=" + flux},
             false);
  }
}


TEST(Conservation, ClosedAxisymmetricVessel)
{
  for (const bool blending : {true, false})
    for (const auto &method :
         {finite_volume(8), galerkin(1), galerkin(2), galerkin(3)})
    {
      GasRun<2> run(method +
                    std::vector<std::string>{"Domain/Geometry=axisymmetric",
                                             "Domain/Initial refinement=2",
                                             std::string("Method/Blending=") +
                                               (blending ? "true" : "false")});
      run.refine([](const Point<2> &p) { return p.norm() < 0.6; });
      run.set_state([](const Point<2> &p) {
        GasState<2> state = waves(p, false);
        state.velocity[0] *= p[0] * (1. - p[0]);
        return state;
      });
      const auto before = run.totals();
      run.steps(10);
      const auto after = run.totals();
      for (const std::string name : {"mass", "energy"})
        EXPECT_NEAR(after.at(name), before.at(name), 1e-13 * before.at(name));
    }
}


TEST(Conservation, ClosedSphereAndCylinder)
{
  for (const std::string geometry : {"spherical", "cylindrical"})
    for (const auto &method :
         {finite_volume(8), galerkin(1), galerkin(2), galerkin(3)})
    {
      GasRun<1> run(method +
                    std::vector<std::string>{"Domain/Geometry=" + geometry,
                                             "Domain/Coarse leaves=11"});
      run.set_state([](const Point<1> &p) {
        GasState<1> state = waves(p, false);
        state.velocity[0] *= p[0] * (1. - p[0]);
        return state;
      });
      const auto before = run.totals();
      run.steps(50);
      const auto after = run.totals();
      for (const std::string name : {"mass", "energy"})
        EXPECT_NEAR(after.at(name), before.at(name), 1e-13 * before.at(name));
    }
}
