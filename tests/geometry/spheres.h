// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/triangle_mesh.h>

#include <cmath>

namespace contrecoup
{
/// A sphere of n rings, twice as many around.
inline TriangleMesh
make_sphere(const unsigned int n,
            const dealii::Point<3> &center = dealii::Point<3>(),
            const double radius = 1.)
{
  TriangleMesh mesh;
  const unsigned int m = 2 * n;
  const auto at = [&](const unsigned int ring, const unsigned int around) {
    const double theta = M_PI * ring / n;
    const double phi = 2. * M_PI * around / m;
    return center + radius * dealii::Point<3>(std::sin(theta) * std::cos(phi),
                                              std::sin(theta) * std::sin(phi),
                                              std::cos(theta));
  };
  mesh.vertices = {at(0, 0), at(n, 0)};
  for (unsigned int ring = 1; ring < n; ++ring)
    for (unsigned int around = 0; around < m; ++around)
      mesh.vertices.push_back(at(ring, around));
  const auto number = [&](const unsigned int ring, const unsigned int around) {
    return ring == 0 ? 0u : (ring == n ? 1u : 2 + (ring - 1) * m + around % m);
  };
  for (unsigned int ring = 0; ring < n; ++ring)
    for (unsigned int around = 0; around < m; ++around)
    {
      const auto a = number(ring, around);
      const auto b = number(ring + 1, around);
      const auto c = number(ring + 1, around + 1);
      const auto d = number(ring, around + 1);
      if (b != c)
        mesh.triangles.push_back({{a, b, c}});
      if (a != d)
        mesh.triangles.push_back({{a, c, d}});
    }
  return mesh;
}

inline void append(TriangleMesh &mesh, const TriangleMesh &other)
{
  const std::uint32_t first = mesh.vertices.size();
  mesh.vertices.insert(
    mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto &t : other.triangles)
    mesh.triangles.push_back({{first + t[0], first + t[1], first + t[2]}});
}

/// Triangles that share no vertices, as STL files have them.
inline TriangleMesh to_soup(const TriangleMesh &mesh)
{
  TriangleMesh soup;
  for (const auto &triangle : mesh.triangles)
  {
    const std::uint32_t first = soup.vertices.size();
    for (const std::uint32_t vertex : triangle)
      soup.vertices.push_back(mesh.vertices[vertex]);
    soup.triangles.push_back({{first, first + 1, first + 2}});
  }
  return soup;
}
} // namespace contrecoup
