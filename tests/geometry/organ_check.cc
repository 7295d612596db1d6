// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/organ_check.h>

#include <gtest/gtest.h>

using namespace contrecoup;

// Two cubes of a metre, one of each part; a third part has none.
TEST(OrganCheck, ComparesVolumesOfOrgans)
{
  LabelGrid grid;
  grid.spacing = 1.;
  grid.size = {{2, 1, 1}};
  grid.labels = {0, 1};
  const std::vector<BodyPart> parts{{"heart", Tissue::heart},
                                    {"liver", Tissue::liver},
                                    {"lungs", Tissue::lung}};
  const HexMesh mesh = make_hex_mesh(grid, parts, 0);
  const std::string image = "the image";
  auto checks = check_organs(mesh,
                             {{"both", {}, 2., 0.1, image},
                              {"heart", {"heart"}, 1.05, 0.1, image},
                              {"liver", {"liver"}, 0.8, 0.1, image},
                              {"lungs", {"lungs"}, 0.01, 0.1, image}});
  ASSERT_EQ(checks.size(), 4u);
  EXPECT_NEAR(checks[0].difference(), 0., 1e-12);
  EXPECT_TRUE(checks[1].holds());
  EXPECT_NEAR(checks[2].difference(), 0.25, 1e-12);
  EXPECT_FALSE(checks[2].holds());
  EXPECT_EQ(checks[3].volume, 0.);
  EXPECT_EQ(organ_warning(checks),
            "WARNING: the elements' volumes differ by more than 10 % from "
            "those of the image: liver +25 %, lungs without an element; a "
            "smaller Mesh/Element size brings them closer");
  checks.resize(2);
  EXPECT_EQ(organ_warning(checks), "");
}
