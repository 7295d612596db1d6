// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/triangle_smoothing.h>

namespace contrecoup
{
namespace
{
  using dealii::Tensor;

  /// Moves each vertex by a factor times the way to the mean of its neighbours.
  void move(TriangleMesh &mesh, const double factor)
  {
    std::vector<Tensor<1, 3>> sums(mesh.vertices.size());
    std::vector<double> counts(mesh.vertices.size(), 0.);
    for (const TriangleMesh::Triangle &triangle : mesh.triangles)
      for (unsigned int v = 0; v < 3; ++v)
        for (const unsigned int step : {1U, 2U})
        {
          sums[triangle[v]] += mesh.vertices[triangle[(v + step) % 3]];
          counts[triangle[v]] += 1.;
        }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      if (counts[i] > 0.)
        mesh.vertices[i] +=
          factor * (sums[i] / counts[i] - Tensor<1, 3>(mesh.vertices[i]));
  }
} // namespace


TriangleMesh smoothed(const TriangleMesh &mesh, const unsigned int iterations)
{
  constexpr double forth = 0.5, back = -0.53;
  TriangleMesh result = mesh;
  for (unsigned int i = 0; i < iterations; ++i)
  {
    move(result, forth);
    move(result, back);
  }
  return result;
}
} // namespace contrecoup
