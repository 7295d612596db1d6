// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/gauge_raster.h>

#include <gtest/gtest.h>

#include <algorithm>

using namespace contrecoup::coupling;
using dealii::Point;

namespace
{
std::vector<GaugeRaster> all()
{
  return find_gauges(
    {{"Probes/Points", "1, 2, 3"},
     {"Probes/Lines", "0,0,1 : 4,4,1 : 5"},
     {"Probes/Gauge planes", "2,-1,1.5 : -2,1,1.5 : 5,3; 0,0 : 1,1 : 2,2"}});
}
} // namespace


// A probe, a line and a plane; the corners of the last one blast refuses.
TEST(GaugeRaster, IsReadFromTheEntriesOfTheBlast)
{
  const auto gauges = all();
  ASSERT_EQ(gauges.size(), 3U);
  EXPECT_EQ(gauges[0].begin, Point<3>(1., 2., 3.));
  EXPECT_EQ(gauges[0].end, gauges[0].begin);
  EXPECT_TRUE(gauges[1].is_line);
  EXPECT_FALSE(gauges[2].is_line);
  EXPECT_EQ(gauges[2].box().lower_bound(0), -2.);
  EXPECT_DOUBLE_EQ(farthest_distance(gauges[2].box(), Point<3>(2., 1., 1.5)),
                   std::sqrt(20.));
}


TEST(GaugeRaster, HasTheNearestPlace)
{
  const auto gauges = all();
  EXPECT_EQ(gauges[0].nearest(Point<3>(5., 5., 5.)), gauges[0].begin);
  // The nearest place is on the line, not in its box.
  EXPECT_LT(
    gauges[1].nearest(Point<3>(4., 0., 1.)).distance(Point<3>(2., 2., 1.)),
    1e-12);
  EXPECT_EQ(gauges[2].nearest(Point<3>(0.3, 5., 0.)), Point<3>(0.3, 1., 1.5));
}


TEST(GaugeRaster, IsCoveredByPlacesThatAreClose)
{
  for (const GaugeRaster &gauge : all())
  {
    const auto places = gauge.places(0.6);
    for (const double a : {0., 0.31, 1.})
      for (const double b : {0., 0.77, 1.})
      {
        Point<3> wanted = gauge.begin;
        for (unsigned int d = 0; d < 3; ++d)
          wanted[d] +=
            (gauge.is_line || d == 0 ? a : b) * (gauge.end[d] - gauge.begin[d]);
        EXPECT_TRUE(
          std::any_of(places.begin(), places.end(), [&](const auto &p) {
            return p.distance(wanted) <= 0.3 * std::sqrt(2.) + 1e-12;
          }));
      }
  }
}
