// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/shape/obj_file.h>
#include <contrecoup/geometry/shape/ply_file.h>
#include <contrecoup/geometry/shape/stl_file.h>
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

  /// Formats other than STL, OBJ and PLY.
  TriangleMesh read_with_assimp(const std::string &file,
                                const std::string &ending,
                                const double unit)
  {
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
    TriangleMesh mesh;
    for (unsigned int m = 0; m < scene->mNumMeshes; ++m)
      append(*scene->mMeshes[m], unit, mesh);
    return mesh;
  }
} // namespace

void check_single_precision(const TriangleMesh &mesh,
                            const std::string &file,
                            std::vector<std::string> &remarks)
{
  double largest = 0.;
  for (const Point<3> &vertex : mesh.vertices)
    for (unsigned int d = 0; d < 3; ++d)
      largest = std::max(largest, std::abs(vertex[d]));
  const auto box = mesh.bounding_box();
  const double size = box.vertex(0).distance(box.vertex(7));
  const double step = largest * std::numeric_limits<float>::epsilon();
  const std::string text =
    "surface \"" + file +
    "\" is so far from its origin that its positions, in single precision, are "
    "known to " +
    brief(1e3 * step, 2) +
    " mm only; move it to the origin before it is saved, or save it as OBJ or "
    "ASCII PLY";
  constexpr double refused = 1e-2, noted = 1e-5; // of the size
  if (step > refused * size)
    throw InputError(text);
  if (step > noted * size)
    remarks.push_back("WARNING: " + text);
}

TriangleMesh read_surface(const std::string &file,
                          const double unit,
                          std::vector<std::string> *remarks)
{
  require_readable("the surface", file);
  std::string ending = std::filesystem::path(file).extension();
  for (char &letter : ending)
    letter = static_cast<char>(std::tolower(letter));
  std::vector<std::string> found;
  TriangleMesh mesh;
  if (ending == ".stl")
    mesh = read_stl(file, unit, found);
  else if (ending == ".obj")
    mesh = read_obj(file, unit);
  else if (ending == ".ply")
    mesh = read_ply(file, unit);
  else
  {
    mesh = read_with_assimp(file, ending, unit);
    check_single_precision(mesh, file, found);
  }
  check(mesh, file);
  if (remarks != nullptr)
    remarks->insert(remarks->end(), found.begin(), found.end());
  return mesh;
}
} // namespace contrecoup
