// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/solid/boundary/facet_search.h>
#include <contrecoup/solid/boundary/recorded_loads.h>

#include "../named_value.h"
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace contrecoup;
using dealii::Point;
using dealii::Tensor;

namespace
{
/// Two facets of 1 and 2 m^2, at x = 0 and 1, that face -x and +x, with four
/// samples of 1 ms.
void write_loads(const std::string &file)
{
  io::LoadFile loads(file);
  loads.create(
    {{0., 0., 0., 1., 0., 0.}, {-1., 0., 0., 1., 0., 0.}, {1., 2.}, {}},
    {{"application", "test"}});
  loads.append({1e-3, 2e-3}, {100.F, 10.F, 300.F, 30.F});
  loads.append({3e-3, 4e-3}, {200.F, 20.F, 0.F, 0.F});
}

std::shared_ptr<solid::RecordedLoads> read_loads(const std::string &file,
                                                 const double interval = 0.,
                                                 const std::string &most = "",
                                                 const bool keeps = true)
{
  ParameterHandler prm;
  solid::RecordedLoads::declare_parameters(prm);
  prm.set("File", file);
  prm.set("Largest distance", 0.4);
  prm.set("Averaging interval", interval);
  prm.set("Keep impulse", keeps);
  if (!most.empty())
    prm.set("Largest correction", most);
  return solid::RecordedLoads::parse_parameters(prm);
}


double audited(const solid::RecordedLoads &loads, const std::string &name)
{
  return value_of(loads.check_values(), name);
}
} // namespace


TEST(RecordedLoads, NearestFacetThatFacesTheSameWay)
{
  const std::string file = "recorded_loads.h5";
  write_loads(file);
  const auto loads = read_loads(file);
  // Near each, and one far from both.
  const std::vector<Point<3>> middles{
    {0.1, 0.1, 0.}, {0.9, 0., 0.1}, {0.5, 2., 0.}};
  const std::vector<Tensor<1, 3>> areas{
    Point<3>(-1., 0.5, 0.), Point<3>(2., 0., 0.), Point<3>(0., 1., 0.)};
  loads->reinit(middles, areas, MPI_COMM_SELF);

  loads->set_time(0.5e-3); // the middle of the first sample
  EXPECT_NEAR(loads->pressure(0), 100., 1e-10);
  EXPECT_NEAR(loads->pressure(1), 10., 1e-11);
  EXPECT_EQ(loads->pressure(2), 0.);
  loads->set_time(1e-3); // between the first two
  EXPECT_NEAR(loads->pressure(0), 200., 1e-10);
  loads->set_time(2.25e-3);
  EXPECT_NEAR(loads->pressure(0), 225., 1e-10);
  loads->set_time(10.);
  EXPECT_EQ(loads->pressure(0), 0.);

  EXPECT_EQ(audited(*loads, "loads_unmatched_facets"), 1.);
  // Means over 1 ms: 600 and 60 Pa ms, on 1 m^2 towards +x and 2 towards -x.
  EXPECT_NEAR(audited(*loads, "loads_recorded_impulse_x"), 0.6 - 0.12, 1e-12);
  EXPECT_NEAR(audited(*loads, "loads_mapped_impulse_y"), -0.3, 1e-12);
  std::filesystem::remove(file);
}


// The first facet has 0.95 of its area: a factor gives the impulse back. With
// half of it the surfaces are not the same, and nothing is done.
TEST(RecordedLoads, ImpulseIsKept)
{
  const std::string file = "recorded_impulse.h5";
  write_loads(file);
  const auto loads = read_loads(file);
  const std::vector<Point<3>> middles{{0., 0., 0.}, {1., 0., 0.}};
  for (const double area : {0.95, 0.5})
  {
    loads->reinit(
      middles, {Point<3>(-area, 0., 0.), Point<3>(2., 0., 0.)}, MPI_COMM_SELF);
    const double factor = area > 0.9 ? 0.48 / (0.95 * 0.6 - 0.12) : 1.;
    loads->set_time(0.5e-3);
    EXPECT_NEAR(loads->pressure(0), factor * 100., 1e-10);
    EXPECT_NEAR(loads->correction(), factor, 1e-12);
    EXPECT_NEAR(audited(*loads, "loads_impulse_factor"), factor, 1e-12);
  }
  // Who asks for it gets any impulse back, or none.
  for (const auto &[most, factor] :
       {std::pair{"1", 0.48 / (0.5 * 0.6 - 0.12)}, std::pair{"0.01", 1.}})
  {
    const auto chosen = read_loads(file, 0., most);
    const double area = factor > 1. ? 0.5 : 0.95;
    chosen->reinit(
      middles, {Point<3>(-area, 0., 0.), Point<3>(2., 0., 0.)}, MPI_COMM_SELF);
    EXPECT_NEAR(audited(*chosen, "loads_impulse_factor"), factor, 1e-12);
  }
  // Surfaces that differ are warned of in any case.
  const auto kept = read_loads(file, 0., "", false);
  testing::internal::CaptureStdout();
  kept->reinit(
    middles, {Point<3>(-0.5, 0., 0.), Point<3>(2., 0., 0.)}, MPI_COMM_SELF);
  EXPECT_EQ(testing::internal::GetCapturedStdout().find("WARNING: "), 0U);
  EXPECT_EQ(kept->correction(), 1.);
  std::filesystem::remove(file);
}


// The wave pushes with 1 N s, and what comes back from a wall takes 0.99 of
// them: 0.95 of the push arrive, of what is left at the end minus four times.
TEST(RecordedLoads, ImpulseThatIsPushedBackIsKept)
{
  const std::string file = "recorded_back.h5";
  {
    io::LoadFile loads(file);
    loads.create(
      {{0., 0., 0., 1., 0., 0.}, {-1., 0., 0., 1., 0., 0.}, {1., 2.}, {}},
      {{"application", "test"}});
    loads.append({1e-3, 2e-3}, {1000.F, 0.F, 0.F, 495.F});
  }
  const auto loads = read_loads(file);
  loads->reinit({{0., 0., 0.}, {1., 0., 0.}},
                {Point<3>(-0.95, 0.5, 0.), Point<3>(2., 0., 0.)},
                MPI_COMM_SELF);
  EXPECT_NEAR(loads->correction(), 1. / 0.95, 1e-12);
  EXPECT_NEAR(audited(*loads, "loads_recorded_impulse_x"), 0.01, 1e-12);
  for (const std::string where : {"recorded", "mapped"})
    EXPECT_NEAR(
      audited(*loads, "loads_largest_" + where + "_impulse"), 1., 1e-12);
  std::filesystem::remove(file);
}


// Facets around a place, all as far from it, and the first faces away.
TEST(RecordedLoads, OfFacetsAsNearTheFirstThatFacesCounts)
{
  io::LoadFile::Facets facets;
  for (unsigned int i = 0; i < 24; ++i)
  {
    const double angle = i * 2. * std::acos(-1.) / 24.;
    for (const double x : {std::cos(angle), std::sin(angle), 0.})
      facets.centroids.push_back(0.01 * x);
    for (const double x : {0., 0., i == 0 ? -1. : 1.})
      facets.normals.push_back(x);
    facets.areas.push_back(1.);
  }
  const solid::FacetSearch search(facets, 0.05);
  EXPECT_EQ(search.find({0., 0., 0.}, Point<3>(0., 0., 1.)), 1U);
  EXPECT_EQ(search.find({0., 0., 0.}, Point<3>(0., 0., -1.)), 0U);
}


// Equal pushes from both sides leave nothing or little, which compares
// with nothing; their magnitudes do, by which half of a side is warned of.
TEST(RecordedLoads, PushesThatCancelAreComparedByTheirMagnitudes)
{
  const std::string file = "recorded_both_sides.h5";
  for (const float left : {300.F, 285.F})
  {
    {
      io::LoadFile loads(file);
      loads.create(
        {{0., 0., 0., 1., 0., 0.}, {-1., 0., 0., 1., 0., 0.}, {1., 1.}, {}},
        {{"application", "test"}});
      loads.append({1e-3, 2e-3}, {300.F, left, 0.F, 0.F});
    }
    for (const double area : {0.98, 0.5})
    {
      const auto loads = read_loads(file);
      testing::internal::CaptureStdout();
      loads->reinit({{0., 0., 0.}, {1., 0., 0.}},
                    {Point<3>(-area, 0., 0.), Point<3>(1., 0., 0.)},
                    MPI_COMM_SELF);
      EXPECT_EQ(testing::internal::GetCapturedStdout().find("WARNING: ") == 0U,
                area < 0.9);
      EXPECT_EQ(loads->correction(), 1.);
      EXPECT_EQ(audited(*loads, "loads_pushes_cancel"), 1.);
      // The push left is that of the whole side less that of the other.
      EXPECT_NEAR(audited(*loads, "loads_largest_recorded_push"),
                  1e-3 * (300. - left),
                  1e-6);
      EXPECT_NEAR(audited(*loads, "loads_largest_mapped_push"),
                  left < 300.F ? 1e-3 * (300. * area - left) : 0.,
                  1e-6);
    }
    std::filesystem::remove(file);
  }
}


// The push of the pressures, without directions, is 0.72 N s: a third of it
// arrives where 0.4 of the first facet is loaded and the second is away.
TEST(RecordedLoads, LoadsThatHardlyArriveAreRefused)
{
  const std::string file = "recorded_elsewhere.h5";
  write_loads(file);
  const auto loads = read_loads(file);
  const std::vector<Point<3>> middles{{0., 0., 0.}, {2., 0., 0.}};
  const auto load = [&](const double area) {
    loads->reinit(
      middles, {Point<3>(-area, 0., 0.), Point<3>(2., 0., 0.)}, MPI_COMM_SELF);
  };
  EXPECT_THROW(load(0.4), InputError);
  EXPECT_THROW(load(-1.), InputError);
  EXPECT_NO_THROW(load(0.7));
  std::filesystem::remove(file);
}


// A blast is recorded from its arrival: a first sample for all time before, one
// at rest that is as long as the others, then the wave. Nothing is felt before
// it, not even by lines between the middles of samples, and no impulse is lost.
TEST(RecordedLoads, RecordedFromArrival)
{
  const std::string file = "recorded_late.h5";
  {
    io::LoadFile loads(file);
    loads.create({{0., 0., 0.}, {-1., 0., 0.}, {1.}, {}},
                 {{"application", "t"}});
    loads.append({1.000, 1.001, 1.002, 1.003}, {0.F, 0.F, 400.F, 200.F});
  }
  const auto loads = read_loads(file);
  loads->reinit({Point<3>()}, {Point<3>(-1., 0., 0.)}, MPI_COMM_SELF);
  for (const double time : {0., 0.5, 0.9995, 1.0005})
  {
    loads->set_time(time);
    EXPECT_EQ(loads->pressure(0), 0.) << time;
  }
  loads->set_time(1.001);
  EXPECT_NEAR(loads->pressure(0), 200., 1e-6);
  loads->set_time(1.0015);
  EXPECT_NEAR(loads->pressure(0), 400., 1e-6);
  // A front that rises at the end of the record has its pressure until then.
  loads->set_time(1.0029);
  EXPECT_NEAR(loads->pressure(0), 200., 1e-6);
  loads->set_time(1.0031);
  EXPECT_EQ(loads->pressure(0), 0.);
  EXPECT_NEAR(audited(*loads, "loads_recorded_impulse_x"), 0.6, 1e-9);
  std::filesystem::remove(file);
}


// Recorded at y, z > 0 of a body that is symmetric.
TEST(RecordedLoads, MirroredAcrossTwoPlanes)
{
  const std::string file = "recorded_quarter.h5";
  {
    io::LoadFile loads(file);
    loads.create({{0., 1., 1.}, {-1., 0., 0.}, {1.}, {}},
                 {{"application", "t"}});
    loads.append({1e-3, 2e-3}, {100.F, 100.F});
  }
  ParameterHandler prm;
  solid::RecordedLoads::declare_parameters(prm);
  prm.set("File", file);
  prm.set("Mirror", "y and z");
  const auto loads = solid::RecordedLoads::parse_parameters(prm);
  std::vector<Point<3>> middles;
  for (const double y : {-1., 1.})
    for (const double z : {-1., 1.})
      middles.emplace_back(0., y, z);
  loads->reinit(middles,
                std::vector<Tensor<1, 3>>(4, Point<3>(-1., 0., 0.)),
                MPI_COMM_SELF);
  loads->set_time(0.5e-3);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(loads->pressure(i), 100., 1e-10);
  EXPECT_NEAR(audited(*loads, "loads_recorded_impulse_x"), 0.8, 1e-12);
  std::filesystem::remove(file);
}


// A thin plate next to the plane of symmetry, pressed by 100 Pa from the plane
// and by 300 Pa from outside: so is its mirror image.
TEST(RecordedLoads, MirroredFacetsFeelWhatFacesThem)
{
  const std::string file = "recorded_plate.h5";
  {
    io::LoadFile loads(file);
    loads.create(
      {{0., 0.5, 0., 0., 0.52, 0.}, {0., -1., 0., 0., 1., 0.}, {1., 1.}, {}},
      {{"application", "t"}});
    loads.append({1e-3, 2e-3}, {100.F, 300.F, 100.F, 300.F});
  }
  ParameterHandler prm;
  solid::RecordedLoads::declare_parameters(prm);
  prm.set("File", file);
  prm.set("Mirror", "y");
  const auto loads = solid::RecordedLoads::parse_parameters(prm);
  loads->reinit(
    {{0., 0.5, 0.}, {0., 0.52, 0.}, {0., -0.5, 0.}, {0., -0.52, 0.}},
    {Point<3>(0., -1., 0.),
     Point<3>(0., 1., 0.),
     Point<3>(0., 1., 0.),
     Point<3>(0., -1., 0.)},
    MPI_COMM_SELF);
  loads->set_time(0.5e-3);
  for (unsigned int i = 0; i < 4; ++i)
    EXPECT_NEAR(loads->pressure(i), i % 2 == 0 ? 100. : 300., 1e-10) << i;
  std::filesystem::remove(file);
}


TEST(RecordedLoads, RunsMayBeginWithinTheRecord)
{
  const std::string file = "recorded_offset.h5";
  write_loads(file);
  ParameterHandler prm;
  solid::RecordedLoads::declare_parameters(prm);
  prm.set("File", file);
  prm.set("Time offset", "1e-3");
  const auto loads = solid::RecordedLoads::parse_parameters(prm);
  loads->reinit({{0., 0., 0.}, {1., 0., 0.}},
                {Point<3>(-1., 0., 0.), Point<3>(2., 0., 0.)},
                MPI_COMM_SELF);
  loads->set_time(0.); // between the first two samples
  EXPECT_NEAR(loads->pressure(0), 200., 1e-10);
  loads->set_time(0.5e-3); // the middle of the second
  EXPECT_NEAR(loads->pressure(1), 30., 1e-11);
  loads->set_time(3e-3); // the end of the last
  EXPECT_EQ(loads->pressure(0), 0.);
  std::filesystem::remove(file);
}


TEST(RecordedLoads, WhatIsNoFileOfLoadsIsRefused)
{
  EXPECT_THROW(read_loads("no such file.h5"), InputError);
  ParameterHandler prm;
  solid::RecordedLoads::declare_parameters(prm);
  EXPECT_EQ(solid::RecordedLoads::parse_parameters(prm), nullptr);
}


namespace
{
/// A wave on one facet from 10 ms on, in samples that last as long as told
/// [ms], of the rate 100 Pa/ms for 12 ms, and then of none.
void write_ramp(const std::string &file, const std::vector<double> &lengths)
{
  io::LoadFile loads(file);
  loads.create({{0., 0., 0.}, {-1., 0., 0.}, {1.}, {}}, {{"application", "t"}});
  loads.append({9e-3, 10e-3}, {0.F, 0.F});
  double time = 0.;
  for (unsigned int i = 0; time < 20.; ++i)
  {
    const double length = lengths[i % lengths.size()];
    loads.append({1e-3 * (10. + time + length)},
                 {time < 12. ? float(100. * (time + 0.5 * length)) : 0.F});
    time += length;
  }
}

/// Impulse felt from 0 to 40 ms, summed over times 0.01 ms apart [Pa s].
double felt_impulse(solid::RecordedLoads &loads)
{
  double sum = 0.;
  for (unsigned int i = 0; i < 4000; ++i)
  {
    loads.set_time(1e-5 * (i + 0.5));
    sum += 1e-5 * loads.pressure(0);
  }
  return sum;
}
} // namespace


// Merged to samples of 4 ms the means of a ramp are those in their middles, so
// that the lines between them are the ramp itself; its impulse is kept.
TEST(RecordedLoads, MergedSamplesKeepRampsAndImpulses)
{
  const std::string file = "recorded_ramp.h5";
  for (const std::vector<double> &lengths :
       {std::vector<double>{0.5}, std::vector<double>{0.25, 0.5, 0.25, 1.}})
  {
    write_ramp(file, lengths);
    const auto loads = read_loads(file, 4e-3);
    loads->reinit({Point<3>()}, {Point<3>(-1., 0., 0.)}, MPI_COMM_SELF);
    for (const double time : {15e-3, 16.3e-3, 18e-3, 19e-3})
    {
      loads->set_time(time);
      EXPECT_NEAR(loads->pressure(0), 1e5 * (time - 10e-3), 1e-3) << time;
    }
    // The sample that ends at 9 ms has its middle at 7 ms.
    loads->set_time(6.9e-3);
    EXPECT_EQ(loads->pressure(0), 0.);
    EXPECT_NEAR(audited(*loads, "loads_mapped_impulse_x"), 7.2, 1e-6);
    EXPECT_NEAR(felt_impulse(*loads), 7.2, 1e-3);
  }
  std::filesystem::remove(file);
}


TEST(RecordedLoads, IntervalsShorterThanSamplesChangeNothing)
{
  const std::string file = "recorded_short.h5";
  write_ramp(file, {0.25, 0.5, 0.25, 1.});
  const auto loads = read_loads(file), merged = read_loads(file, 0.2e-3);
  for (solid::RecordedLoads *one : {loads.get(), merged.get()})
    one->reinit({Point<3>()}, {Point<3>(-1., 0., 0.)}, MPI_COMM_SELF);
  for (unsigned int i = 0; i < 400; ++i)
  {
    loads->set_time(1e-4 * i);
    merged->set_time(1e-4 * i);
    EXPECT_EQ(merged->pressure(0), loads->pressure(0)) << i;
  }
  std::filesystem::remove(file);
}


// The last sample leaves 20 Pa on the second facet.
TEST(RecordedLoads, WarnsOfARecordThatEndsEarly)
{
  const std::string file = "recorded_early.h5";
  {
    io::LoadFile loads(file);
    loads.create(
      {{0., 0., 0., 1., 0., 0.}, {-1., 0., 0., 1., 0., 0.}, {1., 2.}, {}},
      {{"application", "test"}});
    loads.append({1e-3, 2e-3}, {100.F, -200.F, 10.F, 20.F});
  }
  const auto loads = read_loads(file);
  loads->reinit({{0., 0., 0.}, {1., 0., 0.}},
                {Point<3>(-1., 0., 0.), Point<3>(2., 0., 0.)},
                MPI_COMM_SELF);
  EXPECT_EQ(loads->warning(2e-3), "");
  EXPECT_EQ(loads->warning(4e-3), "");
  const std::string warning = loads->warning(0.1);
  EXPECT_NE(warning.find("the record ends at 0.002 s, the run at 0.1 s"),
            std::string::npos)
    << warning;
  EXPECT_NE(warning.find("20 Pa are left at (1, 0, 0) m"), std::string::npos)
    << warning;
  std::filesystem::remove(file);
}
