// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/recorders.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <optional>
#include <sstream>

using namespace contrecoup;
using namespace contrecoup::gas;

namespace
{
/// A probe 0.25 m from 0.85 kg of TNT.
ProbeSet<2> probe_beside(const GasRun<2> &run)
{
  dealii::ParameterHandler prm;
  Recorders<2>::declare_parameters(prm);
  apply_assignments({parse_override("Probes/Points=0.25, 0")}, prm);
  ProbeSet<2> probes;
  probes.parse_parameters(prm, run);
  return probes;
}


/// Records overpressures at the ends of steps of 10 us, with a checkpoint
/// before the last @p n_resumed.
ProbeSet<2> record(const GasRun<2> &run,
                   const std::vector<double> &overpressures,
                   const std::size_t n_resumed = 0)
{
  ProbeSet<2> probes = probe_beside(run), resumed = probe_beside(run);
  for (std::size_t i = 0; i < overpressures.size(); ++i)
  {
    if (i + n_resumed == overpressures.size())
    {
      std::stringstream stream;
      probes.save(stream, "");
      resumed.load(stream, "");
      probes = resumed;
    }
    GasState<2> state;
    state.density = 1.2;
    state.pressure = 101325. + overpressures[i];
    probes.take({state}, 1e-5 * (i + 1));
  }
  return probes;
}
} // namespace


// The blast of 0.85 kg of TNT has reached the nearer one of two probes. A
// cell that is wider than usual moves no column.
TEST(ProbeSet, TellsWhereNoBlastHasArrived)
{
  GasRun<2> run({"Domain/Coarse leaves=2, 2",
                 "Domain/Upper corner=3, 3",
                 "Reference/Kind=kingery bulmash",
                 "Reference/Kingery Bulmash/Mass=0.8535"},
                MPI_COMM_SELF);
  dealii::ParameterHandler prm;
  Recorders<2>::declare_parameters(prm);
  apply_assignments({parse_override("Probes/Points=0.25, 0; 2, 0")}, prm);
  ProbeSet<2> probes;
  probes.parse_parameters(prm, run);
  GasState<2> shocked, ambient;
  ambient.density = shocked.density = 1.2;
  ambient.pressure = 101325.;
  shocked.pressure = 101325. + 12.62e6;
  probes.take({ambient, ambient}, 0.05e-3);
  probes.take({shocked, ambient}, 0.06e-3);

  const std::vector<std::string> lines = probes.report(run.snapshot());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NE(lines[2].find("1.262e+04 / 1.079e+04 (+17.0 %)"), std::string::npos)
    << lines[2];
  EXPECT_NE(lines[3].find("not reached / 173.1 "), std::string::npos)
    << lines[3];
  EXPECT_EQ(lines[3].find('%'), std::string::npos) << lines[3];
  EXPECT_EQ(lines[1].find("impulse"), lines[3].find("not reached / 83.3"));
  EXPECT_EQ(lines[1].find("impulse"), lines[2].find(">= "));
  for (const NamedValue &value : probes.measures(run.reference))
    EXPECT_EQ(std::isnan(value.value),
              begins_with(value.name, "probe_2") &&
                value.name.find("reference") == std::string::npos)
      << value.name;
}


TEST(ProbeSet, TellsTheFirstProbesWithoutAReference)
{
  GasRun<2> run({"Domain/Coarse leaves=2, 2", "Domain/Upper corner=30, 3"},
                MPI_COMM_SELF);
  dealii::ParameterHandler prm;
  Recorders<2>::declare_parameters(prm);
  std::string points = "0.25, 0";
  for (unsigned int i = 1; i < 14; ++i)
    points += "; " + std::to_string(i) + ", 0";
  apply_assignments({parse_override("Probes/Points=" + points)}, prm);
  ProbeSet<2> probes;
  probes.parse_parameters(prm, run);
  const std::vector<std::string> lines = probes.report(run.snapshot());
  ASSERT_EQ(lines.size(), 14U);
  EXPECT_NE(lines[0].find("place [m]"), std::string::npos);
  EXPECT_NE(lines[1].find("0.25, 0  "), std::string::npos) << lines[1];
  EXPECT_EQ(lines[13], "and 2 more in summary.json");
}


// A front that has arrived when larger cells take over falls and rises once
// more; where it arrives afterwards, the next rise is another wave.
TEST(ProbeSet, ExpectsThatOnlyFrontsThatHaveArrivedAreSmeared)
{
  GasRun<2> run({"Domain/Coarse leaves=2, 2", "Domain/Upper corner=3, 3"},
                MPI_COMM_SELF);
  const auto no_record = [](const dealii::Point<2> &) {
    return std::optional<BlastRecord<double>>();
  };
  const std::vector<double> rises = {200e3, 150e3, 100e3, 150e3, 80e3};
  for (const bool has_arrived : {false, true})
  {
    ProbeSet<2> probes =
      record(run, {0., has_arrived ? 150e3 : 0., has_arrived ? 100e3 : 0.});
    probes.inherit(no_record, run.snapshot());
    GasState<2> state;
    state.density = 1.2;
    for (std::size_t i = 0; i < rises.size(); ++i)
    {
      state.pressure = 101325. + rises[i];
      probes.take({state}, 1e-5 * (i + 4));
    }
    std::size_t n_later = 0;
    for (const NamedValue &value : probes.measures(run.reference))
      n_later += value.name == "probe_1_later_peak_overpressure";
    EXPECT_EQ(n_later, has_arrived ? 0U : 1U);
  }
}


// A reflection that comes later and is larger is none of the wave that the
// reference has; ripples are no waves.
TEST(ProbeSet, ComparesThePeakOfTheFirstWave)
{
  GasRun<2> run({"Domain/Coarse leaves=2, 2",
                 "Domain/Upper corner=3, 3",
                 "Reference/Kind=kingery bulmash",
                 "Reference/Kingery Bulmash/Mass=0.8535"},
                MPI_COMM_SELF);
  const std::vector<double> ripples = {
    0., 9e6, 10.5e6, 10e6, 10.7e6, 3e6, 3.8e6, 2e6};
  std::vector<double> waves = ripples;
  waves.insert(waves.end(), {9e6, 12e6, 5e6, 7e6});
  const auto values = [&](const ProbeSet<2> &probes) {
    std::map<std::string, double> found;
    for (const NamedValue &value : probes.measures(run.reference))
      found[value.name] = value.value;
    return found;
  };
  const auto simple = values(record(run, ripples));
  EXPECT_DOUBLE_EQ(simple.at("probe_1_first_peak_overpressure"), 10.7e6);
  EXPECT_EQ(simple.count("probe_1_later_peak_overpressure"), 0U);
  const ProbeSet<2> probes = record(run, waves);
  const auto found = values(probes);
  EXPECT_DOUBLE_EQ(found.at("probe_1_first_peak_overpressure"), 10.7e6);
  EXPECT_DOUBLE_EQ(found.at("probe_1_peak_overpressure"), 12e6);
  EXPECT_DOUBLE_EQ(found.at("probe_1_later_peak_overpressure"), 12e6);
  EXPECT_DOUBLE_EQ(found.at("probe_1_later_peak_time"), 1e-4);
  EXPECT_EQ(simple.count("probe_1_impulse_of_all_phases"), 0U);
  EXPECT_GE(found.at("probe_1_impulse_of_all_phases"),
            found.at("probe_1_impulse"));
  for (const std::size_t n : {9, 3, 2})
    EXPECT_EQ(values(record(run, waves, n)), found) << n;

  const double reference = found.at("probe_1_reference_peak_overpressure");
  EXPECT_DOUBLE_EQ(probes.errors(run.snapshot())[0].value,
                   10.7e6 / reference - 1.);
  const std::vector<std::string> lines = probes.report(run.snapshot());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NE(lines[2].find("1.07e+04 / 1.079e+04 (-0.8 %)"), std::string::npos)
    << lines[2];
  EXPECT_EQ(lines[3],
            "a later wave has the larger peak at probe 1: 1.2e+04 kPa at 0.1 "
            "ms");
}
