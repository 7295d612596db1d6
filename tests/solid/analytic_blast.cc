// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>
#include <contrecoup/solid/boundary/analytic_blast.h>

#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;
using solid::AnalyticBlast;

namespace
{
std::shared_ptr<AnalyticBlast>
blast(const std::string &kind,
      const std::vector<std::pair<std::string, std::string>> &entries)
{
  ParameterHandler prm;
  AnalyticBlast::declare_parameters(prm);
  prm.enter_subsection(kind == "friedlander" ? "Friedlander"
                                             : "Kingery Bulmash");
  for (const auto &[name, value] : entries)
    prm.set(name, value);
  prm.leave_subsection();
  return AnalyticBlast::parse_parameters(prm, kind, "Loads/Load test");
}

/// Impulse on each facet until 20 ms [Pa s].
std::vector<double> impulses(AnalyticBlast &blast, const unsigned int n_facets)
{
  const double step = 1e-6;
  std::vector<double> sums(n_facets, 0.);
  for (double time = 0.5 * step; time < 0.02; time += step)
  {
    blast.set_time(time);
    for (unsigned int i = 0; i < n_facets; ++i)
      sums[i] += step * blast.pressure(i);
  }
  return sums;
}
} // namespace


TEST(AnalyticBlast, FacetsHaveTheImpulsesOfTheTables)
{
  const auto load =
    blast("kingery bulmash", {{"Mass", "1"}, {"Centre", "2, 0, 0"}});
  // Facing the charge, turned by 60 degrees, sideways, and away from it.
  load->reinit(std::vector<Point<3>>(4),
               {Point<3>(1e-4, 0., 0.),
                Point<3>(0.5e-4, std::sqrt(0.75) * 1e-4, 0.),
                Point<3>(0., 1e-4, 0.),
                Point<3>(-1e-4, 0., 0.)},
               MPI_COMM_SELF);
  const KingeryBulmash tables("spherical", 1.);
  const double passing = tables.value(BlastQuantity::impulse, 2.);
  const double wall = tables.value(BlastQuantity::reflected_impulse, 2.);
  const std::vector<double> found = impulses(*load, 4);
  EXPECT_NEAR(found[0], wall, 2e-3 * wall);
  EXPECT_NEAR(found[1], 0.25 * wall + passing, 2e-3 * wall);
  EXPECT_NEAR(found[2], passing, 2e-3 * passing);
  EXPECT_NEAR(found[3], passing, 2e-3 * passing);
  const double arrival = tables.value(BlastQuantity::arrival, 2.);
  load->set_time(0.999 * arrival);
  EXPECT_EQ(load->pressure(0), 0.);
  load->set_time(1.001 * arrival);
  EXPECT_NEAR(load->pressure(0),
              tables.value(BlastQuantity::reflected_overpressure, 2.),
              0.01 * load->pressure(0));
}


// A plate of two facets before the charge, at x = 1, hides the first of two
// facets behind it, which then bears the incident wave alone.
TEST(AnalyticBlast, HiddenFacetsBearTheIncidentWave)
{
  const double h = 0.05;
  const auto square = [&](const double x, const double y) {
    return std::array<Point<3>, 4>{
      {{x, y - h, -h}, {x, y + h, -h}, {x, y + h, h}, {x, y - h, h}}};
  };
  const auto load =
    blast("kingery bulmash", {{"Mass", "1"}, {"Centre", "2, 0, 0"}});
  const std::vector<Point<3>> middles{
    {0., 0., 0.}, {0., 0.3, 0.}, {1., 0., 0.}, {0., 0., 0.}};
  const double area = 4. * h * h;
  const std::vector<Tensor<1, 3>> areas{Point<3>(area, 0., 0.),
                                        Point<3>(area, 0., 0.),
                                        Point<3>(area, 0., 0.),
                                        Point<3>(-area, 0., 0.)};
  load->set_surface({square(1., 0.), square(0., 0.), square(0., 0.3)},
                    MPI_COMM_SELF);
  load->reinit(middles, areas, MPI_COMM_SELF);
  const std::vector<double> found = impulses(*load, 4);
  const KingeryBulmash tables("spherical", 1.);
  const double passing = tables.value(BlastQuantity::impulse, 2.);
  EXPECT_NEAR(found[0], passing, 2e-3 * passing);
  EXPECT_NEAR(found[3], passing, 2e-3 * passing);
  // The second is not hidden, nor is the plate itself.
  const double far = std::hypot(2., 0.3), cosine = 2. / far;
  const double expected =
    pressure_at_angle(tables.value(BlastQuantity::impulse, far),
                      tables.value(BlastQuantity::reflected_impulse, far),
                      cosine);
  EXPECT_NEAR(found[1], expected, 2e-3 * expected);
  EXPECT_NEAR(found[2],
              tables.value(BlastQuantity::reflected_impulse, 1.),
              3e-3 * found[2]);

  // Without the plate it sees the charge.
  load->set_surface({square(0., 0.)}, MPI_COMM_SELF);
  load->reinit(middles, areas, MPI_COMM_SELF);
  EXPECT_GT(impulses(*load, 1)[0], 1.5 * passing);
}


TEST(AnalyticBlast, RunsMayBeginAfterTheDetonation)
{
  const auto whole =
    blast("kingery bulmash", {{"Mass", "1"}, {"Centre", "2, 0, 0"}});
  const auto late =
    blast("kingery bulmash",
          {{"Mass", "1"}, {"Centre", "2, 0, 0"}, {"Start time", "1.5e-3"}});
  for (const auto &one : {whole, late})
    one->reinit({Point<3>()}, {Point<3>(1., 0., 0.)}, MPI_COMM_SELF);
  for (const double time : {0., 0.2e-3, 0.5e-3, 1e-3})
  {
    whole->set_time(1.5e-3 + time);
    late->set_time(time);
    EXPECT_NEAR(
      late->pressure(0), whole->pressure(0), 1e-9 * whole->pressure(0));
  }
  EXPECT_GT(late->pressure(0), 1e4);
}


TEST(AnalyticBlast, FrontOfEvenSpeed)
{
  const auto load = blast("friedlander",
                          {{"Peak", "1e5"},
                           {"Duration", "2e-3"},
                           {"Decay", "1.5"},
                           {"Centre", "10, 0, 0"},
                           {"Speed", "500"},
                           {"First distance", "9"}});
  load->reinit({Point<3>(), Point<3>()},
               {Point<3>(1., 0., 0.), Point<3>(-1., 0., 0.)},
               MPI_COMM_SELF);
  load->set_time(1.999e-3);
  EXPECT_EQ(load->pressure(0), 0.);
  load->set_time(3e-3); // half of the duration after the arrival
  const double there = 1e5 * 0.5 * std::exp(-0.75);
  EXPECT_NEAR(load->pressure(1), there, 1e-6);
  EXPECT_NEAR(load->pressure(0),
              there * reflected_overpressure(1e5, 101325.) / 1e5,
              1e-6);
}


TEST(AnalyticBlast, FacetsThatTablesDoNotCoverAreRefused)
{
  const auto load =
    blast("kingery bulmash", {{"Mass", "1"}, {"Centre", "1000, 0, 0"}});
  EXPECT_THROW(
    load->reinit({Point<3>()}, {Point<3>(1., 0., 0.)}, MPI_COMM_SELF),
    InputError);
}
