// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/hex_mesh.h>

#include <cmath>
#include <map>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Offset of each corner of a cell in units of its edge.
  constexpr std::array<std::array<unsigned int, 3>, 8> corner_offset{
    {{{0, 0, 0}},
     {{1, 0, 0}},
     {{1, 1, 0}},
     {{0, 1, 0}},
     {{0, 0, 1}},
     {{1, 0, 1}},
     {{1, 1, 1}},
     {{0, 1, 1}}}};

  using Place = std::array<unsigned int, 3>;

  /// Merges the voxels of a grid away from boundary and interfaces.
  class Merging
  {
  public:
    Merging(const LabelGrid &grid, const unsigned int levels)
      : grid_(grid)
      , level_(levels > 0 ? grid.labels.size() : 0, 0)
    {
      for (unsigned int level = 1; level <= levels; ++level)
        merge(level);
    }

    /// Number of doublings of the cube at a voxel.
    unsigned int level(const Place &place) const
    {
      return level_.empty() ? 0 : level_[number(place)];
    }

  private:
    std::size_t number(const Place &place) const
    {
      return grid_.index(place[0], place[1], place[2]);
    }

    void merge(const unsigned int level)
    {
      const unsigned int width = 1 << level;
      for (unsigned int k = 0; k + width <= grid_.size[2]; k += width)
        for (unsigned int j = 0; j + width <= grid_.size[1]; j += width)
          for (unsigned int i = 0; i + width <= grid_.size[0]; i += width)
            if (may_merge({{i, j, k}}, level))
              mark({{i, j, k}}, level);
    }

    /// Whether the eight cubes at @p base may be merged: they and all their
    /// neighbours belong to one part and are not smaller.
    bool may_merge(const Place &base, const unsigned int level) const
    {
      const int half = 1 << (level - 1);
      const unsigned char label = grid_.labels[number(base)];
      if (label == LabelGrid::outside)
        return false;
      for (int z = -1; z < 3; ++z)
        for (int y = -1; y < 3; ++y)
          for (int x = -1; x < 3; ++x)
          {
            const std::array<int, 3> place{{int(base[0]) + x * half,
                                            int(base[1]) + y * half,
                                            int(base[2]) + z * half}};
            if (grid_.label_or_outside(place[0], place[1], place[2]) != label)
              return false;
            const unsigned int other =
              level_[grid_.index(place[0], place[1], place[2])];
            if (other + 1 < level)
              return false;
          }
      return true;
    }

    void mark(const Place &base, const unsigned int level)
    {
      const unsigned int width = 1 << level;
      for (unsigned int k = 0; k < width; ++k)
        for (unsigned int j = 0; j < width; ++j)
          for (unsigned int i = 0; i < width; ++i)
            level_[grid_.index(base[0] + i, base[1] + j, base[2] + k)] = level;
    }

    const LabelGrid &grid_;
    std::vector<unsigned char> level_;
  };

  /// Numbers the nodes of a grid in the order of first use.
  class NodeNumbers
  {
  public:
    NodeNumbers(const LabelGrid &grid, HexMesh &mesh)
      : grid_(grid)
      , mesh_(mesh)
      , numbers_(std::size_t(grid.size[0] + 1) * (grid.size[1] + 1) *
                   (grid.size[2] + 1),
                 no_index)
    {}

    /// Number of a node, if it exists.
    std::uint32_t find(const Place &place) const
    {
      return numbers_[index(place)];
    }

    /// Number of a node, which is created if necessary.
    std::uint32_t make(const Place &place)
    {
      std::uint32_t &entry = numbers_[index(place)];
      if (entry == no_index)
      {
        entry = mesh_.nodes.size();
        Point<3> node = grid_.origin;
        for (unsigned int d = 0; d < 3; ++d)
          node[d] += place[d] * grid_.spacing;
        mesh_.nodes.push_back(node);
      }
      return entry;
    }

  private:
    std::size_t index(const Place &place) const
    {
      return place[0] +
             std::size_t(grid_.size[0] + 1) *
               (place[1] + std::size_t(grid_.size[1] + 1) * place[2]);
    }

    const LabelGrid &grid_;
    HexMesh &mesh_;
    std::vector<std::uint32_t> numbers_;
  };

  /// Adds the boundary faces of the last cell, and its faces towards parts
  /// with a higher number.
  void add_faces(const LabelGrid &grid, const Place &place, HexMesh &mesh)
  {
    const HexMesh::Cell &cell = mesh.cells.back();
    for (unsigned int face = 0; face < 6; ++face)
    {
      std::array<int, 3> neighbor{
        {int(place[0]), int(place[1]), int(place[2])}};
      neighbor[face / 2] += face % 2 ? 1 : -1;
      const unsigned char other =
        grid.label_or_outside(neighbor[0], neighbor[1], neighbor[2]);
      if (other <= mesh.part.back())
        continue;
      HexMesh::Facet facet;
      for (unsigned int v = 0; v < 4; ++v)
        facet.nodes[v] = cell[hex_face_corners[face][v]];
      facet.cell = mesh.cells.size() - 1;
      if (other == LabelGrid::outside)
        mesh.boundary.push_back(facet);
      else
        mesh.interfaces.push_back(facet.nodes);
    }
  }

  using Weights = std::map<std::uint32_t, double>;

  /// Finds the hanging nodes on the edges and faces of a cell.
  void find_hanging(const HexMesh::Cell &cell,
                    const Place &base,
                    const unsigned int level,
                    const NodeNumbers &numbers,
                    std::map<std::uint32_t, Weights> &hanging)
  {
    const unsigned int half = 1 << (level - 1);
    for (unsigned int code = 0; code < 27; ++code)
    {
      const Place step{{code % 3, code / 3 % 3, code / 9}};
      const unsigned int n_middles =
        (step[0] == 1) + (step[1] == 1) + (step[2] == 1);
      if (n_middles != 1 && n_middles != 2)
        continue;
      const std::uint32_t node = numbers.find({{base[0] + step[0] * half,
                                                base[1] + step[1] * half,
                                                base[2] + step[2] * half}});
      if (node == no_index)
        continue;
      Weights &weights = hanging[node];
      weights.clear();
      for (unsigned int c = 0; c < 8; ++c)
      {
        bool is_master = true;
        for (unsigned int d = 0; d < 3; ++d)
          is_master &= step[d] == 1 || step[d] == 2 * corner_offset[c][d];
        if (is_master)
          weights[cell[c]] = n_middles == 1 ? 0.5 : 0.25;
      }
    }
  }

  /// Replaces masters that hang by their own masters.
  void resolve(std::map<std::uint32_t, Weights> &hanging)
  {
    bool is_changed = true;
    while (is_changed)
    {
      is_changed = false;
      for (auto &[node, weights] : hanging)
      {
        Weights resolved;
        for (const auto &[master, weight] : weights)
        {
          const auto found = hanging.find(master);
          if (found == hanging.end())
            resolved[master] += weight;
          else
            for (const auto &[other, factor] : found->second)
              resolved[other] += weight * factor;
          is_changed |= found != hanging.end();
        }
        weights = resolved;
      }
    }
  }

  void
  add_hanging_nodes(const std::vector<std::pair<Place, unsigned int>> &bases,
                    const NodeNumbers &numbers,
                    HexMesh &mesh)
  {
    std::map<std::uint32_t, Weights> hanging;
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
      if (bases[i].second > 0)
        find_hanging(
          mesh.cells[i], bases[i].first, bases[i].second, numbers, hanging);
    resolve(hanging);
    for (const auto &[node, weights] : hanging)
    {
      HexMesh::HangingNode entry;
      entry.node = node;
      for (const auto &[master, weight] : weights)
      {
        entry.masters.push_back(master);
        entry.weights.push_back(weight);
      }
      mesh.hanging_nodes.push_back(entry);
    }
  }
} // namespace


Point<3> HexMesh::center(const Facet &facet) const
{
  Point<3> sum;
  for (const std::uint32_t node : facet.nodes)
    sum += Tensor<1, 3>(nodes[node]);
  return sum / 4.;
}

Tensor<1, 3> HexMesh::area_vector(const Facet &facet) const
{
  return 0.5 * cross_product_3d(nodes[facet.nodes[2]] - nodes[facet.nodes[0]],
                                nodes[facet.nodes[3]] - nodes[facet.nodes[1]]);
}


HexMesh make_hex_mesh(const LabelGrid &grid,
                      const std::vector<BodyPart> &parts,
                      const unsigned int levels)
{
  HexMesh mesh;
  mesh.parts = parts;
  const Merging merging(grid, levels);
  NodeNumbers numbers(grid, mesh);
  std::vector<std::pair<Place, unsigned int>> bases;
  for (unsigned int k = 0; k < grid.size[2]; ++k)
    for (unsigned int j = 0; j < grid.size[1]; ++j)
      for (unsigned int i = 0; i < grid.size[0]; ++i)
      {
        const unsigned char label = grid.at(i, j, k);
        if (label == LabelGrid::outside)
          continue;
        const unsigned int level = merging.level({{i, j, k}});
        const unsigned int width = 1 << level;
        if (i % width != 0 || j % width != 0 || k % width != 0)
          continue;
        HexMesh::Cell cell;
        for (unsigned int c = 0; c < 8; ++c)
          cell[c] = numbers.make({{i + width * corner_offset[c][0],
                                   j + width * corner_offset[c][1],
                                   k + width * corner_offset[c][2]}});
        mesh.cells.push_back(cell);
        mesh.part.push_back(label);
        if (levels > 0)
          bases.push_back({{{i, j, k}}, level});
        if (level == 0)
          add_faces(grid, {{i, j, k}}, mesh);
      }
  if (levels > 0)
    add_hanging_nodes(bases, numbers, mesh);
  return mesh;
}


HexMeshSize count_hexahedra(const LabelGrid &grid, const unsigned int levels)
{
  HexMeshSize size;
  const Merging merging(grid, levels);
  for (unsigned int k = 0; k < grid.size[2]; ++k)
    for (unsigned int j = 0; j < grid.size[1]; ++j)
      for (unsigned int i = 0; i < grid.size[0]; ++i)
      {
        if (grid.at(i, j, k) == LabelGrid::outside)
          continue;
        size.cells += std::ldexp(1., -3 * int(merging.level({{i, j, k}})));
        for (const int step : {-1, 1})
        {
          const int x = i, y = j, z = k;
          size.facets +=
            (grid.label_or_outside(x + step, y, z) == LabelGrid::outside) +
            (grid.label_or_outside(x, y + step, z) == LabelGrid::outside) +
            (grid.label_or_outside(x, y, z + step) == LabelGrid::outside);
        }
      }
  return size;
}
} // namespace contrecoup
