// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/geometry/image/voxel_image.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/geometry/mesh/mesh_file.h>
#include <contrecoup/geometry/shape/triangle_mesh.h>
#include <contrecoup/geometry/shape/triangle_repair.h>
#include <contrecoup/geometry/shape/triangulated_surface.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_out.h>

#include "fuzz.h"
#include <zlib.h>

#include <array>
#include <fstream>
#include <sstream>

using namespace contrecoup;

namespace
{
using Corner = std::array<float, 3>;

const std::vector<Corner> corners{{{0.F, 0.F, 0.F}},
                                  {{1.F, 0.F, 0.F}},
                                  {{0.F, 1.F, 0.F}},
                                  {{0.F, 0.F, 1.F}}};
const std::vector<std::array<int, 3>> sides{{{0, 2, 1}},
                                            {{0, 1, 3}},
                                            {{0, 3, 2}},
                                            {{1, 2, 3}}};

void write(const std::string &path, const std::string &content)
{
  std::ofstream(path, std::ios::binary) << content;
}

std::string text_of(const Corner &corner)
{
  return std::to_string(corner[0]) + " " + std::to_string(corner[1]) + " " +
         std::to_string(corner[2]);
}

template <typename Number>
void put(std::string &bytes, const Number number)
{
  bytes.append(reinterpret_cast<const char *>(&number), sizeof(number));
}


void prepare_binary_stl(const std::string &folder)
{
  std::string bytes(80, ' ');
  put(bytes, std::uint32_t(sides.size()));
  for (const auto &side : sides)
  {
    put(bytes, Corner{{0.F, 0.F, 1.F}});
    for (const int corner : side)
      put(bytes, corners[corner]);
    put(bytes, std::uint16_t(0));
  }
  write(folder + "/body.stl", bytes);
}

void prepare_ascii_stl(const std::string &folder)
{
  std::string text = "solid body\n";
  for (const auto &side : sides)
  {
    text += "facet normal 0 0 1\nouter loop\n";
    for (const int corner : side)
      text += "vertex " + text_of(corners[corner]) + "\n";
    text += "endloop\nendfacet\n";
  }
  write(folder + "/body.stl", text + "endsolid body\n");
}

void prepare_obj(const std::string &folder)
{
  std::string text = "# a body\no body\n";
  for (const Corner &corner : corners)
    text += "v " + text_of(corner) + "\n";
  for (const auto &side : sides)
    text += "f " + std::to_string(side[0] + 1) + " " +
            std::to_string(side[1] + 1) + " " + std::to_string(side[2] + 1) +
            "\n";
  write(folder + "/body.obj", text);
}

std::string ply_header(const std::string &format)
{
  return "ply\nformat " + format +
         " 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
         "property float z\nelement face 4\n"
         "property list uchar int vertex_indices\nend_header\n";
}

void prepare_ascii_ply(const std::string &folder)
{
  std::string text = ply_header("ascii");
  for (const Corner &corner : corners)
    text += text_of(corner) + "\n";
  for (const auto &side : sides)
    text += "3 " + std::to_string(side[0]) + " " + std::to_string(side[1]) +
            " " + std::to_string(side[2]) + "\n";
  write(folder + "/body.ply", text);
}

void prepare_binary_ply(const std::string &folder)
{
  std::string bytes = ply_header("binary_little_endian");
  for (const Corner &corner : corners)
    put(bytes, corner);
  for (const auto &side : sides)
  {
    put(bytes, std::uint8_t(3));
    put(bytes, side);
  }
  write(folder + "/body.ply", bytes);
}

/// Reads a surface as a body does, with its defects.
void read_body(const std::string &path)
{
  TriangleMesh mesh = read_surface(path, 1e-3);
  repair(mesh);
  if (mesh.triangles.empty())
    return;
  const TriangulatedSurface surface(mesh);
  surface.value(dealii::Point<3>(1e-4, 1e-4, 1e-4));
}


void prepare_image(const std::string &folder)
{
  // Four by three by two 16-bit numbers with a sform, in mm.
  std::string bytes(352, '\0');
  const auto set = [&](const std::size_t place, const auto number) {
    std::copy_n(
      reinterpret_cast<const char *>(&number), sizeof(number), &bytes[place]);
  };
  set(0, 348);
  const std::array<short, 4> size{{3, 4, 3, 2}};
  for (unsigned int d = 0; d < 4; ++d)
    set(40 + 2 * d, size[d]);
  set(70, short(4));
  set(72, short(16));
  for (unsigned int d = 0; d < 3; ++d)
    set(80 + 4 * d, 1.F);
  set(108, 352.F);
  bytes[123] = 2;
  set(254, short(1));
  set(280, -1.F);
  set(300, 1.F);
  set(320, 1.F);
  bytes.replace(344, 3, "n+1");
  for (short i = 0; i < 24; ++i)
    put(bytes, i);
  write(folder + "/head.nii", bytes);
  const gzFile file = gzopen((folder + "/head.nii.gz").c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned int>(bytes.size()));
  gzclose(file);
}

void read_head(const std::string &path)
{
  read_image(path);
}


void prepare_mesh(const std::string &folder)
{
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::subdivided_hyper_cube(mesh, 2);
  std::ofstream stream(folder + "/mesh.msh");
  dealii::GridOut().write_msh(mesh, stream);
}

void read_mesh(const std::string &path)
{
  dealii::ParameterHandler prm;
  CoarseMesh<3>::declare_parameters(prm);
  const auto assign = [](const std::string &entry, const std::string &value) {
    return Assignment{{"Domain"}, entry, value, "fuzz"};
  };
  apply_assignments({assign("Mesh", "file"), assign("Mesh file", path)}, prm);
  CoarseMesh<3> mesh;
  mesh.parse_parameters(prm);
  dealii::Triangulation<3> triangulation;
  mesh.create(triangulation);
}

void prepare_named_mesh(const std::string &folder)
{
  prepare_mesh(folder);
  const std::string file = folder + "/mesh.msh";
  std::ostringstream mesh;
  mesh << std::ifstream(file).rdbuf();
  write(file,
        "$PhysicalNames\n2\n3 4 \"brain\"\n3 6 \"cerebrospinal fluid\"\n"
        "$EndPhysicalNames\n" +
          mesh.str());
}

void read_names(const std::string &path)
{
  for (const auto &[number, name] : read_group_names(path, 3))
    if (name.empty())
      throw std::logic_error("group " + std::to_string(number) +
                             " has no name");
}
} // namespace


int main(int argc, char **argv)
{
  return fuzz::run(
    argc,
    argv,
    {{"stl_binary", "body.stl", prepare_binary_stl, read_body},
     {"stl_ascii", "body.stl", prepare_ascii_stl, read_body},
     {"obj", "body.obj", prepare_obj, read_body},
     {"ply_ascii", "body.ply", prepare_ascii_ply, read_body},
     {"ply_binary", "body.ply", prepare_binary_ply, read_body},
     {"nifti", "head.nii", prepare_image, read_head},
     {"nifti_gz", "head.nii.gz", prepare_image, read_head},
     {"gmsh", "mesh.msh", prepare_mesh, read_mesh},
     {"gmsh_names", "mesh.msh", prepare_named_mesh, read_names}});
}
