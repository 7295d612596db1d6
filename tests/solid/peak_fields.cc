// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/solid/record/peak_fields.h>
#include <contrecoup/solid/run/strain_item.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

using namespace contrecoup;

// A body that is stretched along x, and pressed together later.
TEST(PeakFields, AreLowerLimitsWhereTheLastOnesAreTheLargest)
{
  solid::SolidBody<double> body;
  make_half_brain(body);
  dealii::ParameterHandler prm;
  solid::PeakFields<double>::declare_parameters(prm);
  apply_assignments({{{"Peaks"}, "Active", "true", "test"},
                     {{"Peaks"}, "Every steps", "1", "test"}},
                    prm);
  solid::PeakFields<double> peaks;
  peaks.parse_parameters(prm, {});
  peaks.reinit(body);
  double time = 0.;
  const auto marks_at = [&](const double strain) {
    for (std::size_t i = 0; i < body.mesh().nodes.size(); ++i)
    {
      body.nodes().displacement_of(i)[0] = strain * body.mesh().nodes[i][0];
      // Elements whose nodes move are active.
      body.nodes().velocity_of(i)[0] = 1.;
    }
    body.start(time += 1e-6);
    peaks.record(body);
    std::string found;
    const auto list = peaks.results(body);
    for (const char *name : {"highest_pressure_brain",
                             "lowest_pressure_brain",
                             "largest_von_mises_stress_brain",
                             "largest_principal_strain_skeleton",
                             "principal_strain_95_brain"})
      found += std::any_of(list.begin(),
                           list.end(),
                           [&](const NamedValue &one) {
                             return one.name == std::string(name) + "_cut_off";
                           })
                 ? '1'
                 : '0';
    return found;
  };
  EXPECT_EQ(marks_at(1e-4), "01111");
  EXPECT_EQ(marks_at(-2e-4), "10100");
  EXPECT_EQ(marks_at(0.), "00000");
}


// A strain that grows is not within its limit, but may be beyond it.
TEST(StrainItem, DoesNotJudgeAStrainThatStillGrows)
{
  for (const bool grows : {false, true})
    for (const double strain : {0.09, 0.11})
    {
      const Assumption item = solid::strain_item(
        SolidKinematics::finite_rotation, {"lung", strain, grows});
      EXPECT_EQ(item.value, strain);
      EXPECT_EQ(std::isnan(item.limit), grows && strain < 0.1);
      EXPECT_EQ(item.fails(), strain > 0.1);
    }
}
