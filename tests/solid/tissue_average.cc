// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/body/tissue_average.h>

#include "bone_and_brain.h"
#include <gtest/gtest.h>

using namespace contrecoup;
using dealii::Point;

namespace
{
/// Mesh and averages of this rank's part of the box.
struct Part
{
  explicit Part(const MPI_Comm communicator)
    : mesh(solid::distribute(half_brain(false), communicator))
  {
    exchange.reinit(mesh, communicator);
    const auto brain =
      std::find(mesh.tissues.begin(), mesh.tissues.end(), Tissue::brain);
    average.reinit(
      mesh, exchange, static_cast<unsigned int>(brain - mesh.tissues.begin()));
    for (const std::uint32_t cell : average.elements())
    {
      Point<3> middle;
      for (const std::uint32_t node : mesh.elements[cell])
        middle += mesh.nodes[node] / 8.;
      middles.push_back(middle);
    }
  }

  solid::SolidMesh mesh;
  solid::NodeExchange exchange;
  solid::TissueAverage average;
  std::vector<Point<3>> middles; ///< of the brain's elements
};

/// 1 or -1, from element to element.
double alternating(const Point<3> &x)
{
  const int sum = static_cast<int>(x[0] / 0.01) +
                  static_cast<int>(x[1] / 0.01) + static_cast<int>(x[2] / 0.01);
  return sum % 2 == 0 ? 1. : -1.;
}
} // namespace


TEST(TissueAverage, TakesAlternatingPartsAwayAndKeepsConstants)
{
  const Part part(MPI_COMM_WORLD);
  std::vector<double> values;
  for (const Point<3> &x : part.middles)
    values.push_back(3. + alternating(x));
  const std::vector<double> averages = part.average.average(values);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    // A corner of the brain has one node with one element alone.
    const Point<3> &x = part.middles[i];
    const bool corner =
      std::abs(x[0] - 0.03) > 0.02 && std::abs(x[1] - 0.02) > 0.01;
    const double rest = corner ? alternating(x) / 8. : 0.;
    EXPECT_NEAR(averages[i], 3. + rest, 1e-14);
    EXPECT_NEAR(part.average.volumes()[i], 1e-6, 1e-18);
  }
}


TEST(TissueAverage, WavesLoseCosineSquared)
{
  const Part part(MPI_COMM_WORLD);
  const double k = 100.;
  std::vector<double> values;
  for (const Point<3> &x : part.middles)
    values.push_back(std::sin(k * x[0]));
  const std::vector<double> averages = part.average.average(values);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(part.middles[i][0] - 0.03) < 0.02)
    {
      EXPECT_NEAR(
        averages[i], values[i] * std::pow(std::cos(0.5 * k * 0.01), 2), 1e-14);
    }
}
