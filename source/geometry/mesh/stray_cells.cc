// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/hex_components.h>
#include <contrecoup/geometry/mesh/stray_cells.h>

#include <algorithm>
#include <map>
#include <optional>

namespace contrecoup
{
namespace
{
  bool is_organ(const Tissue tissue)
  {
    return tissue == Tissue::brain || tissue == Tissue::lung ||
           tissue == Tissue::heart || tissue == Tissue::liver;
  }

  std::string told(const std::size_t count, const Tissue tissue)
  {
    return std::to_string(count) + (count == 1 ? " element" : " elements") +
           " of " + name_of(tissue) + (count == 1 ? " shares" : " share") +
           " no face with another of this tissue";
  }

  /// The part that takes a voxel if it is a stray.
  std::optional<unsigned char> new_part(const std::vector<BodyPart> &parts,
                                        const LabelGrid &grid,
                                        const std::array<int, 3> &place)
  {
    const unsigned char label = grid.at(place[0], place[1], place[2]);
    if (!is_organ(parts[label].tissue))
      return {};
    std::map<unsigned char, unsigned int> n_faces;
    for (unsigned int face = 0; face < 6; ++face)
    {
      std::array<int, 3> beside = place;
      beside[face / 2] += face % 2 == 0 ? -1 : 1;
      const unsigned char other =
        grid.label_or_outside(beside[0], beside[1], beside[2]);
      if (other == LabelGrid::outside)
        continue;
      if (parts[other].tissue == parts[label].tissue)
        return {};
      ++n_faces[other];
    }
    const auto most = std::max_element(
      n_faces.begin(), n_faces.end(), [](const auto &a, const auto &b) {
        return a.second < b.second;
      });
    if (most == n_faces.end())
      return {};
    return most->first;
  }
} // namespace


std::vector<std::string> join_strays(const std::vector<BodyPart> &parts,
                                     LabelGrid &grid)
{
  std::map<std::array<Tissue, 2>, std::size_t> counts; // from, to
  const int nx = grid.size[0], ny = grid.size[1], nz = grid.size[2];
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i)
      {
        unsigned char &label = grid.labels[grid.index(i, j, k)];
        if (label == LabelGrid::outside)
          continue;
        const auto part = new_part(parts, grid, {{i, j, k}});
        if (!part)
          continue;
        ++counts[{{parts[label].tissue, parts[*part].tissue}}];
        label = *part;
      }
  std::vector<std::string> lines;
  for (const auto &[tissues, count] : counts)
    lines.push_back(told(count, tissues[0]) + ": now " + name_of(tissues[1]));
  return lines;
}


std::vector<std::string> stray_warnings(const HexMesh &mesh)
{
  std::vector<bool> has_neighbor(mesh.cells.size(), false);
  for (const auto &[a, b] : neighbors_of(mesh))
    if (mesh.parts[mesh.part[a]].tissue == mesh.parts[mesh.part[b]].tissue)
      has_neighbor[a] = has_neighbor[b] = true;
  std::map<Tissue, std::size_t> counts;
  for (std::size_t cell = 0; cell < has_neighbor.size(); ++cell)
    if (const Tissue tissue = mesh.parts[mesh.part[cell]].tissue;
        is_organ(tissue) && !has_neighbor[cell])
      ++counts[tissue];
  std::vector<std::string> lines;
  for (const auto &[tissue, count] : counts)
    lines.push_back(
      "WARNING: " + told(count, tissue) +
      "; peaks and measures of injury there are not the tissue's");
  return lines;
}
} // namespace contrecoup
