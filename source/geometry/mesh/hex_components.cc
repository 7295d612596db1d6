// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/hex_components.h>

#include <algorithm>
#include <numeric>

namespace contrecoup
{
namespace
{
  using Pair = std::array<std::uint32_t, 2>;

  /// Number of connected sets of each label.
  std::array<unsigned int, 256> count(const std::vector<Pair> &pairs,
                                      const std::vector<unsigned char> &label)
  {
    std::vector<std::uint32_t> parent(label.size());
    std::iota(parent.begin(), parent.end(), 0U);
    const auto root = [&](std::uint32_t i) {
      while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
      return i;
    };
    for (const auto &[a, b] : pairs)
      if (label[a] == label[b])
        parent[root(a)] = root(b);
    std::array<unsigned int, 256> counts{};
    for (std::uint32_t cell = 0; cell < label.size(); ++cell)
      if (root(cell) == cell)
        ++counts[label[cell]];
    return counts;
  }
} // namespace


std::vector<std::array<std::uint32_t, 2>> neighbors_of(const HexMesh &mesh)
{
  // Sorted nodes of each face, then its cell.
  std::vector<std::array<std::uint32_t, 5>> faces;
  faces.reserve(6 * mesh.cells.size());
  for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (const auto &corner : hex_face_corners)
    {
      std::array<std::uint32_t, 5> face{};
      for (unsigned int v = 0; v < 4; ++v)
        face[v] = mesh.cells[cell][corner[v]];
      std::sort(face.begin(), face.begin() + 4);
      face[4] = cell;
      faces.push_back(face);
    }
  std::sort(faces.begin(), faces.end());
  std::vector<Pair> pairs;
  for (std::size_t i = 1; i < faces.size(); ++i)
    if (std::equal(
          faces[i].begin(), faces[i].begin() + 4, faces[i - 1].begin()))
      pairs.push_back({{faces[i - 1][4], faces[i][4]}});
  return pairs;
}


std::array<unsigned int, 256>
count_components(const HexMesh &mesh, const std::vector<unsigned char> &label)
{
  const std::vector<Pair> pairs = neighbors_of(mesh);
  std::array<unsigned int, 256> counts = count(pairs, label);
  counts[LabelGrid::outside] =
    count(pairs, std::vector<unsigned char>(label.size(), 0))[0];
  return counts;
}
} // namespace contrecoup
