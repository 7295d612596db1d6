// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/io/file/hdf5_input.h>
#include <contrecoup/io/file/temporary_folder.h>

#include "../../named_value.h"
#include "../gas_run.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
/// A shock of overpressure 1.46 runs onto a sphere, a quarter of it computed.
void set_up(GasSimulation<3> &blast)
{
  dealii::ParameterHandler prm;
  GasSimulation<3>::declare_parameters(prm);
  prm.enter_subsection("Time");
  prm.declare_entry("End time", "1");
  prm.leave_subsection();
  std::vector<Assignment> assignments;
  for (const char *line : {"Domain/Lower corner=-1, 0, 0",
                           "Domain/Upper corner=0.5, 1, 1",
                           "Domain/Coarse leaves=3, 2, 2",
                           "Domain/Initial refinement=1",
                           "Boundaries/x low=initial",
                           "Boundaries/y low=symmetry",
                           "Boundaries/z low=symmetry",
                           "Rigid body/Kind=body",
                           "Body/Kind=shape",
                           "Body/Shape/Shape=sphere",
                           "Body/Shape/Size=0.5",
                           "Initial state/Kind=riemann",
                           "Initial state/Riemann/Position=-0.59",
                           "Initial state/Riemann/Left density=2.606896",
                           "Initial state/Riemann/Left velocity=0.694444",
                           "Initial state/Riemann/Left pressure=2.458333",
                           "Initial state/Riemann/Right density=1.4",
                           "Initial state/Riemann/Right pressure=1",
                           "Loads/Record=true",
                           "Loads/Gauges=front: -0.5, 0, 0",
                           "Loads/Gauge radius=1e-9"})
    assignments.push_back(parse_override(line));
  apply_assignments(assignments, prm);
  blast.parse_parameters(prm);
  blast.setup();
}


/// Force on the facets of all ranks along x.
double force(const WallLoads<3> &loads)
{
  double sum = 0.;
  const std::vector<double> overpressures = loads.overpressures();
  for (std::size_t i = 0; i < overpressures.size(); ++i)
    sum += overpressures[i] * loads.facets().owned()[i].area[0];
  return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}


/// Overpressure on the facet of all ranks whose centroid is nearest to a place.
double nearest(const WallLoads<3> &loads, const dealii::Point<3> &place)
{
  const auto &geometry = loads.facets().geometry();
  std::size_t number = 0;
  double smallest = 1e300;
  for (std::size_t i = 0; i < loads.facets().n_global(); ++i)
  {
    const double *centroid = &geometry[6 * i];
    const double distance =
      place.distance({centroid[0], centroid[1], centroid[2]});
    if (distance < smallest)
    {
      smallest = distance;
      number = i;
    }
  }
  double sum = 0.;
  const std::vector<double> overpressures = loads.overpressures();
  for (std::size_t i = 0; i < overpressures.size(); ++i)
    if (loads.facets().owned()[i].number == number)
      sum += overpressures[i];
  return dealii::Utilities::MPI::sum(sum, MPI_COMM_WORLD);
}
} // namespace


TEST(WallLoads, OverpressuresAfterEachStepMakeTheImpulse)
{
  GasSimulation<3> blast(MPI_COMM_WORLD);
  set_up(blast);
  const WallLoads<3> &loads = blast.loads();
  ASSERT_TRUE(loads.is_active());
  ASSERT_EQ(loads.gauges().names(), std::vector<std::string>{"front"});
  double impulse = 0., last = 0., time = 0.;
  while (blast.time() < 0.15)
  {
    blast.advance(1e10);
    blast.adapt();
    const double now = force(loads);
    impulse += 0.5 * (last + now) * (blast.time() - time);
    last = now;
    time = blast.time();
    EXPECT_DOUBLE_EQ(loads.gauges().overpressures().at(0),
                     nearest(loads, {-0.5, 0., 0.}));
  }
  EXPECT_GT(loads.gauges().overpressures().at(0), 1.46);
  // A quarter of the sphere counts four times.
  EXPECT_NEAR(value_of(blast.results(), "loads_impulse_x"),
              4. * impulse,
              1e-12 * std::abs(impulse));
}


// A quarter of a sphere of radius 0.5 counts four times.
TEST(WallLoads, KnowTheProjectionsOfTheWholeSkin)
{
  GasSimulation<3> blast(MPI_COMM_WORLD);
  set_up(blast);
  // Of each direction, a disk from both sides.
  const double sphere = 6. * dealii::numbers::PI * 0.25;
  EXPECT_NEAR(value_of(blast.checks(), "loads_skin_projections"), sphere, 0.05);
}


TEST(WallLoads, KnowNothingWhereNoBlastHasCome)
{
  const io::TemporaryFolder folder;
  GasSimulation<3> blast(MPI_COMM_WORLD);
  set_up(blast);
  blast.set_output_folder(folder.path());
  while (blast.time() < 0.1)
    blast.advance(1e10);
  blast.finish(folder.path());
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  const io::Hdf5Input file(folder.path() + "/loads.h5");
  const std::vector<double> peaks = file.numbers("peak"),
                            centroids = file.numbers("centroid");
  for (const char *name : {"peak", "impulse", "arrival", "duration"})
  {
    const std::vector<double> values = file.numbers(name);
    ASSERT_EQ(values.size(), peaks.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      EXPECT_EQ(std::isnan(values[i]), std::isnan(peaks[i]));
      EXPECT_FALSE(values[i] <= 0.);
      // The shock has passed the front of the sphere, and not its middle.
      EXPECT_TRUE(std::isnan(values[i]) ? centroids[3 * i] > -0.45
                                        : centroids[3 * i] < 0.);
    }
  }
}
