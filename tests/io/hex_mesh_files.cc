// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/body/body.h>
#include <contrecoup/geometry/shape/primitive_shapes.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/hex_mesh_files.h>

#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

#include <gtest/gtest.h>

#include <filesystem>

using namespace contrecoup;
using dealii::Point;

namespace
{
class HexMeshFiles : public ::testing::Test
{
protected:
  HexMeshFiles()
    : folder_(std::filesystem::temp_directory_path() /
              ("contrecoup_hex_mesh_files_" + std::to_string(getpid())))
    , ball_(std::make_shared<Sphere>(Point<3>(0.1, 0., 0.), 1.))
  {
    std::filesystem::create_directories(folder_);
    const auto core = std::make_shared<Sphere>(Point<3>(), 0.5);
    const ShapeBody body(
      ball_,
      {{{"core", Tissue::brain}, core}, {{"shell", Tissue::skeleton}, ball_}});
    LabelGrid grid = make_grid(ball_->bounding_box(), 0.2);
    body.fill(grid);
    mesh_ = make_hex_mesh(grid, body.parts());
  }

  ~HexMeshFiles() override
  {
    std::filesystem::remove_all(folder_);
  }

  std::string path(const std::string &name) const
  {
    return folder_ / name;
  }

  std::filesystem::path folder_;
  ShapePointer ball_;
  HexMesh mesh_;
};
} // namespace


TEST_F(HexMeshFiles, DealiiReadsTheGmshFile)
{
  io::write_msh(mesh_, path("mesh.msh"));
  // Gmsh has no group 0.
  const std::string text = io::read_file(path("mesh.msh"));
  EXPECT_NE(text.find("3 1 \"soft tissue\""), std::string::npos);
  EXPECT_EQ(text.find("\n3 0 \""), std::string::npos);
  dealii::Triangulation<3> triangulation;
  dealii::GridIn<3> reader(triangulation);
  std::ifstream file(path("mesh.msh"));
  reader.read_msh(file);
  ASSERT_EQ(triangulation.n_active_cells(), mesh_.cells.size());
  EXPECT_NEAR(
    dealii::GridTools::volume(triangulation), 8e-3 * mesh_.cells.size(), 1e-9);
  for (const auto &cell : triangulation.active_cell_iterators())
    EXPECT_EQ(cell->material_id(),
              static_cast<unsigned int>(cell->center().norm() <= 0.5
                                          ? Tissue::brain
                                          : Tissue::skeleton));
}


TEST_F(HexMeshFiles, StlHasTwoTrianglesForEachFacet)
{
  io::write_surface_stl(mesh_, path("surface.stl"));
  const std::string content = io::read_file(path("surface.stl"));
  ASSERT_EQ(content.size(), 84u + 100u * mesh_.boundary.size());
  std::uint32_t count = 0;
  std::copy_n(content.data() + 80, 4, reinterpret_cast<char *>(&count));
  EXPECT_EQ(count, 2 * mesh_.boundary.size());
  // The enclosed volume, by the divergence theorem.
  double volume = 0.;
  for (std::uint32_t t = 0; t < count; ++t)
  {
    std::array<float, 12> values;
    std::copy_n(content.data() + 84 + 50 * t,
                48,
                reinterpret_cast<char *>(values.data()));
    std::array<Point<3>, 3> x;
    for (unsigned int v = 0; v < 3; ++v)
      x[v] = Point<3>(values[3 + 3 * v], values[4 + 3 * v], values[5 + 3 * v]);
    volume += x[0] * dealii::cross_product_3d(x[1], x[2]) / 6.;
  }
  EXPECT_NEAR(volume, 8e-3 * mesh_.cells.size(), 1e-5);
}


TEST_F(HexMeshFiles, VtkFilesNameTheirArrays)
{
  io::write_vtu(mesh_, path("mesh.vtu"));
  io::write_surface_vtu(mesh_, *ball_, path("surface.vtu"));
  io::write_distance(*ball_, 0.2, 0.5, path("distance.vti"));
  const std::string mesh = io::read_file(path("mesh.vtu"));
  EXPECT_NE(
    mesh.find("NumberOfCells=\"" + std::to_string(mesh_.cells.size()) + "\""),
    std::string::npos);
  for (const char *name :
       {"points", "connectivity", "offsets", "types", "part", "tissue"})
    EXPECT_NE(mesh.find(std::string("Name=\"") + name + "\""),
              std::string::npos);
  EXPECT_NE(io::read_file(path("surface.vtu")).find("Name=\"normal\""),
            std::string::npos);
  EXPECT_NE(
    io::read_file(path("distance.vti")).find("Name=\"signed_distance\""),
    std::string::npos);
}
