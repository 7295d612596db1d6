// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/recorders.h>

#include "gas_run.h"
#include <gtest/gtest.h>

#include <cmath>

using namespace contrecoup;
using namespace contrecoup::gas;

// Of two probes beside 0.85 kg of TNT the blast has reached the nearer one. A
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
