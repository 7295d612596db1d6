// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/gauge_tables.h>

#include <gtest/gtest.h>

using namespace contrecoup::gas;

// Bowen's curves follow from the positive phase: of one that the end of the run
// cuts off, the load of the lungs is a lower limit, the peak at an ear is not.
TEST(GaugeTables, CallTheLoadOfACutPositivePhaseALowerLimit)
{
  const std::vector<double> times{0., 1e-3, 2e-3}, wave{0., 2e5, 1e5};
  for (const double duration : {0.5e-3, 1.5e-3})
  {
    const BlastMeasures blast{2e5, 100., 0.5e-3, duration};
    const std::string table = gauge_injury_table(
      {{"chest", blast, 1e-3, wave}, {"left ear", blast, 1e-3, wave}},
      times,
      70.);
    const std::size_t first = table.find("a lower limit");
    EXPECT_EQ(first != std::string::npos, duration > 1e-3) << table;
    EXPECT_EQ(table.find("a lower limit", first + 1), std::string::npos);
  }
}
