// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/stray_cells.h>

#include <gtest/gtest.h>

using namespace contrecoup;

namespace
{
const std::vector<BodyPart> parts{{"skull", Tissue::skeleton},
                                  {"left", Tissue::brain},
                                  {"right", Tissue::brain},
                                  {"fluid", Tissue::cerebrospinal_fluid},
                                  {"lung", Tissue::lung}};

/// A block of the skull with room around it.
LabelGrid block()
{
  LabelGrid grid = make_grid(
    dealii::BoundingBox<3>({dealii::Point<3>(), dealii::Point<3>(6., 6., 6.)}),
    1.);
  for (unsigned int k = 1; k + 1 < grid.size[2]; ++k)
    for (unsigned int j = 1; j + 1 < grid.size[1]; ++j)
      for (unsigned int i = 1; i + 1 < grid.size[0]; ++i)
        grid.labels[grid.index(i, j, k)] = 0;
  return grid;
}
} // namespace

TEST(StrayCells, JoinThePartOfMostOfTheirFaces)
{
  LabelGrid grid = block();
  const auto at = [&](const unsigned int i,
                      const unsigned int j,
                      const unsigned int k) -> unsigned char & {
    return grid.labels[grid.index(i, j, k)];
  };
  // A cell that touches others of the brain at an edge only.
  at(2, 2, 2) = 1;
  at(3, 3, 2) = 1;
  at(3, 3, 3) = 2;
  // A cell between four faces of fluid and two of bone.
  for (const auto &[i, j] : {std::array<int, 2>{{4, 5}},
                             std::array<int, 2>{{6, 5}},
                             std::array<int, 2>{{5, 4}},
                             std::array<int, 2>{{5, 6}}})
    at(i, j, 3) = at(i, j, 4) = 3;
  at(5, 5, 3) = 1;
  // A layer that the mesh does not resolve.
  at(2, 6, 6) = 3;
  // A cell without neighbours.
  at(0, 0, 0) = 4;
  const LabelGrid before = grid;
  const auto lines = join_strays(parts, grid);
  EXPECT_EQ(at(2, 2, 2), 0);
  EXPECT_EQ(at(5, 5, 3), 3);
  unsigned int changed = 0;
  for (std::size_t i = 0; i < grid.labels.size(); ++i)
    changed += grid.labels[i] != before.labels[i];
  EXPECT_EQ(changed, 2u);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0],
            "1 element of brain shares no face with another of this tissue: "
            "now skeleton");
  EXPECT_TRUE(join_strays(parts, grid).empty());
}

// The second of two adjacent strays has company once the first has joined it.
TEST(StrayCells, DoNotChangePlaces)
{
  LabelGrid grid = block();
  for (unsigned char &label : grid.labels)
    label = LabelGrid::outside;
  grid.labels[grid.index(2, 2, 2)] = 1;
  grid.labels[grid.index(3, 2, 2)] = 4;
  EXPECT_EQ(join_strays(parts, grid).size(), 1u);
  EXPECT_EQ(grid.at(2, 2, 2), 4);
  EXPECT_EQ(grid.at(3, 2, 2), 4);
}

TEST(StrayCells, AreNamedInAMeshThatStays)
{
  LabelGrid grid = block();
  grid.labels[grid.index(2, 2, 2)] = 1;
  grid.labels[grid.index(5, 5, 5)] = 2;
  const auto lines = stray_warnings(make_hex_mesh(grid, parts));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].find("WARNING: 2 elements of brain share no face"), 0u);
  join_strays(parts, grid);
  EXPECT_TRUE(stray_warnings(make_hex_mesh(grid, parts)).empty());
}
