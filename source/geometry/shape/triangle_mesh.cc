// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/shape/ply_file.h>
#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <filesystem>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

Tensor<1, 3> TriangleMesh::area_vector(const Triangle &triangle) const
{
  const Point<3> &a = vertices[triangle[0]];
  return 0.5 *
         cross_product_3d(vertices[triangle[1]] - a, vertices[triangle[2]] - a);
}

double TriangleMesh::area() const
{
  double sum = 0.;
  for (const Triangle &triangle : triangles)
    sum += area_vector(triangle).norm();
  return sum;
}

double TriangleMesh::volume() const
{
  // Relative to a vertex, so that distant surfaces lose no digits.
  const Point<3> origin = vertices.empty() ? Point<3>() : vertices.front();
  double sum = 0.;
  for (const Triangle &triangle : triangles)
    sum += area_vector(triangle) * (vertices[triangle[0]] - origin) / 3.;
  return sum;
}

dealii::BoundingBox<3> TriangleMesh::bounding_box() const
{
  return dealii::BoundingBox<3>(vertices);
}

namespace
{
  void append(const aiMesh &part, const double unit, TriangleMesh &mesh)
  {
    const std::uint32_t first = mesh.vertices.size();
    for (unsigned int v = 0; v < part.mNumVertices; ++v)
    {
      const aiVector3D &x = part.mVertices[v];
      mesh.vertices.emplace_back(unit * x.x, unit * x.y, unit * x.z);
    }
    for (unsigned int f = 0; f < part.mNumFaces; ++f)
    {
      const aiFace &face = part.mFaces[f];
      if (face.mNumIndices == 3)
        mesh.triangles.push_back({{first + face.mIndices[0],
                                   first + face.mIndices[1],
                                   first + face.mIndices[2]}});
    }
  }

  void check(const TriangleMesh &mesh, const std::string &file)
  {
    if (mesh.triangles.empty())
      throw InputError("surface \"" + file + "\": it holds no triangles");
    for (const Point<3> &vertex : mesh.vertices)
      if (!std::isfinite(vertex.norm_square()))
        throw InputError("surface \"" + file +
                         "\": it has a vertex whose coordinates are not "
                         "finite numbers");
  }
} // namespace

TriangleMesh read_surface(const std::string &file, const double unit)
{
  require_readable("the surface", file);
  TriangleMesh mesh;
  std::string ending = std::filesystem::path(file).extension();
  for (char &letter : ending)
    letter = static_cast<char>(std::tolower(letter));
  // Assimp 5.2 crashes on many damaged files of this format.
  if (ending == ".ply")
  {
    mesh = read_ply(file, unit);
    check(mesh, file);
    return mesh;
  }
  Assimp::Importer importer;
  // Without a known extension, Assimp takes any content for DXF.
  if (ending.empty() || !importer.IsExtensionSupported(ending))
    throw InputError("surface \"" + file +
                     "\" cannot be read: its name must "
                     "end as that of a surface, as in .stl, .ply or .obj");
  const aiScene *scene = importer.ReadFile(
    file, aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (scene == nullptr)
    throw InputError("surface \"" + file + "\" cannot be read as " + ending +
                     ": " + one_line(importer.GetErrorString()));
  for (unsigned int m = 0; m < scene->mNumMeshes; ++m)
    append(*scene->mMeshes[m], unit, mesh);
  check(mesh, file);
  return mesh;
}
} // namespace contrecoup
