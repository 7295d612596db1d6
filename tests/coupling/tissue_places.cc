// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/coupling/scene/tissue_places.h>
#include <contrecoup/geometry/body/mesh_body.h>
#include <contrecoup/geometry/body/phantom.h>
#include <contrecoup/geometry/mesh/hex_mesh.h>

#include "../set_entries.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace contrecoup;
using namespace contrecoup::coupling;

namespace
{
BodyPointer standing_man()
{
  return described<Phantom>({}).create();
}


Tissue tissue_in_grid(const Body &body,
                      const LabelGrid &grid,
                      const dealii::Point<3> &place)
{
  std::array<unsigned int, 3> cube;
  for (unsigned int d = 0; d < 3; ++d)
    cube[d] = static_cast<unsigned int>(
      std::floor((place[d] - grid.origin[d]) / grid.spacing));
  return body.parts()[grid.at(cube[0], cube[1], cube[2])].tissue;
}
} // namespace

// However a mesh is turned against the grid of samples.
TEST(TissuePlaces, MassOfOwnHexahedraIsThatOfTheirVolumes)
{
  LabelGrid grid = make_grid({{{0., 0., 0.}, {0.2, 0.2, 0.3}}}, 0.1);
  std::fill(grid.labels.begin(), grid.labels.end(), 0);
  HexMesh mesh = make_hex_mesh(grid, {{"gelatin", Tissue::gelatin}});
  const double expected =
    1e3 * 1e-3 * static_cast<double>(mesh.cells.size()); // cubes of 0.1 m
  for (const double angle : {0., 20., 45.})
  {
    HexMesh turned = mesh;
    const double c = std::cos(angle * M_PI / 180.);
    const double s = std::sin(angle * M_PI / 180.);
    for (auto &x : turned.nodes)
      x = {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
    const double mass =
      estimate_mass(MeshBody(turned), 0.04, [](const Tissue) { return 1e3; });
    EXPECT_NEAR(mass, expected, 1e-9 * expected) << angle;
  }
}

// Elements take the label of their centre; thin tissues are missed by shapes.
TEST(TissuePlaces, LieInElementsOfTheirTissueWhateverTheirSize)
{
  const std::map<std::string, Tissue> wanted = {
    {"coup", Tissue::brain},
    {"brain", Tissue::brain},
    {"contrecoup", Tissue::brain},
    {"skull", Tissue::skeleton},
    {"lung left", Tissue::lung},
    {"lung right", Tissue::lung},
    {"spinal cord", Tissue::spinal_cord}};
  const BodyPointer body = standing_man();
  for (const double spacing : {0.02, 0.01, 0.005})
  {
    LabelGrid grid = make_grid(body->surface()->bounding_box(), spacing);
    body->fill(grid);
    const auto places =
      find_tissue_places(*body, dealii::Point<3>(2.5, 0., 1.27), {}, spacing);
    // Cubes of 20 mm hold no spinal cord and no bone before the brain.
    EXPECT_EQ(places.size(), spacing < 0.02 ? 7U : 5U) << spacing;
    for (const TissuePlace &place : places)
      EXPECT_EQ(tissue_in_grid(*body, grid, place.place), wanted.at(place.name))
        << place.name << " at " << place.place << ", " << spacing;
    std::map<std::string, dealii::Point<3>> by_name;
    for (const TissuePlace &place : places)
      by_name[place.name] = place.place;
    // The man's lungs differ, the positions in them do not.
    const dealii::Point<3> &left = by_name.at("lung left");
    const dealii::Point<3> &right = by_name.at("lung right");
    EXPECT_GT(left[1], 0.);
    EXPECT_LT(left.distance({right[0], -right[1], right[2]}), 0.1 * spacing)
      << left << " and " << right << ", " << spacing;
  }
}
