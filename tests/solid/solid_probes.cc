// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/body/stress_invariants.h>
#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/record/solid_probes.h>

#include "../named_value.h"
#include "bone_and_brain.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// Averages of the elements' pressures in the tissue, as the fields have them.
std::vector<double> averages_of(const solid::SolidBody<double> &body,
                                const solid::TissueAverage &average)
{
  std::vector<double> pressures;
  for (const std::uint32_t cell : average.elements())
    pressures.push_back(solid::pressure_of(
      body.elements().values(body.nodes(), body.times(), cell).stress));
  return average.average(pressures);
}

} // namespace


TEST(SolidProbes, AveragedPressureIsThatOfTheTissueAverage)
{
  solid::SolidBody<double> body;
  make_half_brain(body);
  for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
  {
    const Point<3> &x = body.mesh().nodes[i];
    body.nodes().displacement_of(i)[0] =
      1e-5 * std::sin(400. * x[0] + 500. * x[1] * x[1] / 0.01);
    body.nodes().displacement_of(i)[2] = 1e-5 * std::cos(450. * x[2]);
  }
  body.start(0.);

  for (unsigned int tissue = 0; tissue < body.mesh().tissues.size(); ++tissue)
  {
    solid::TissueAverage average;
    average.reinit(body.mesh(), body.exchange(), tissue);
    const std::vector<double> expected = averages_of(body, average);
    const std::size_t n_here = average.elements().size();
    const std::vector<std::size_t> on_ranks =
      dealii::Utilities::MPI::all_gather(MPI_COMM_WORLD, n_here);
    for (unsigned int rank = 0; rank < on_ranks.size(); ++rank)
      for (const std::size_t i : {std::size_t(0), on_ranks[rank] / 2})
      {
        if (on_ranks[rank] == 0)
          continue;
        // Middle of the element and its average, from the rank that has it.
        std::vector<double> known(4, 0.);
        if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == rank)
        {
          for (const std::uint32_t node :
               body.mesh().elements[average.elements()[i]])
            for (unsigned int d = 0; d < 3; ++d)
              known[d] += body.mesh().nodes[node][d] / 8.;
          known[3] = expected[i];
        }
        dealii::Utilities::MPI::sum(known, MPI_COMM_WORLD, known);
        dealii::ParameterHandler prm;
        solid::SolidProbes<double>::declare_parameters(prm);
        prm.enter_subsection("Probes");
        prm.set("Points",
                exact(known[0]) + ", " + exact(known[1]) + ", " +
                  exact(known[2]));
        prm.leave_subsection();
        solid::SolidProbes<double> probes;
        probes.parse_parameters(prm, {});
        probes.reinit(body);
        probes.record(body);
        EXPECT_NEAR(value_of(probes.values(body), "probe_1_averaged_pressure"),
                    known[3],
                    1e-10 * std::abs(known[3]));
        EXPECT_GT(std::abs(value_of(probes.values(body), "probe_1_pressure") -
                           known[3]),
                  1e-3 * std::abs(known[3]));
      }
  }
}


// A signal falls through a threshold as often as it rises through one; what is
// never crossed has no time.
TEST(SolidProbes, ArrivalIsTheFirstCrossingInEitherDirection)
{
  solid::SolidBody<double> body;
  make_half_brain(body);
  dealii::ParameterHandler prm;
  solid::SolidProbes<double>::declare_parameters(prm);
  std::vector<Assignment> assignments;
  const auto set = [&](const std::string &name,
                       const std::string &entry,
                       const std::string &value) {
    assignments.push_back(
      {{"Measures", "Measure " + name}, entry, value, "test"});
  };
  for (const std::string name : {"falls", "rises", "waves", "late"})
    set(name, "Quantity", "velocity_x");
  set("falls", "Statistic", "arrival");
  set("falls", "Threshold", "-0.55");
  set("rises", "Statistic", "arrival");
  set("rises", "Threshold", "0.55");
  set("waves", "Statistic", "frequency");
  set("late", "First time", "9");
  assignments.push_back({{"Probes"}, "Points", "0, 0, 0", "test"});
  apply_assignments(assignments, prm);
  solid::SolidProbes<double> probes;
  probes.parse_parameters(prm, {});
  probes.reinit(body);
  for (unsigned int step = 0; step <= 10; ++step)
  {
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
      body.nodes().velocity_of(i)[0] = -0.1 * step;
    body.start(0.01 * step);
    probes.record(body);
  }
  const std::vector<NamedValue> results = probes.results(body);
  ASSERT_EQ(results.size(), 4u);
  for (const NamedValue &result : results)
    if (result.name == "falls")
      EXPECT_NEAR(result.value, 0.055, 1e-12);
    else
      EXPECT_TRUE(std::isnan(result.value)) << result.name;
  EXPECT_EQ(probes.gaps().size(), 3u);
}
