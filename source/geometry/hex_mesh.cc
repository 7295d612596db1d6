// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/hex_mesh.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  /// Corner c of a cell is that much further in each direction.
  constexpr std::array<std::array<unsigned int, 3>, 8> corner_offset{
    {{{0, 0, 0}},
     {{1, 0, 0}},
     {{1, 1, 0}},
     {{0, 1, 0}},
     {{0, 0, 1}},
     {{1, 0, 1}},
     {{1, 1, 1}},
     {{0, 1, 1}}}};

  /// Corners of the faces at -x, +x, -y, +y, -z, +z, seen from outside.
  constexpr std::array<std::array<unsigned int, 4>, 6> face_corners{
    {{{0, 4, 7, 3}},
     {{1, 2, 6, 5}},
     {{0, 1, 5, 4}},
     {{3, 7, 6, 2}},
     {{0, 3, 2, 1}},
     {{4, 5, 6, 7}}}};

  /// Numbers of the nodes of a grid, given in the order they are first seen,
  /// for two layers at a time.
  class NodeNumbers
  {
  public:
    NodeNumbers(const LabelGrid &grid, HexMesh &mesh)
      : grid_(grid)
      , mesh_(mesh)
      , row_(grid.size[0] + 1)
      , layers_{{Layer(row_ * (grid.size[1] + 1), none),
                 Layer(row_ * (grid.size[1] + 1), none)}}
    {}

    /// Goes one layer of cells up.
    void advance()
    {
      std::swap(layers_[0], layers_[1]);
      std::fill(layers_[1].begin(), layers_[1].end(), none);
      ++k_;
    }

    std::uint32_t
    number(const unsigned int i, const unsigned int j, const unsigned int above)
    {
      std::uint32_t &entry = layers_[above][j * row_ + i];
      if (entry == none)
      {
        entry = mesh_.nodes.size();
        mesh_.nodes.emplace_back(grid_.origin[0] + i * grid_.spacing,
                                 grid_.origin[1] + j * grid_.spacing,
                                 grid_.origin[2] +
                                   (k_ + above) * grid_.spacing);
      }
      return entry;
    }

  private:
    using Layer = std::vector<std::uint32_t>;
    static constexpr std::uint32_t none = -1;

    const LabelGrid &grid_;
    HexMesh &mesh_;
    std::size_t row_;
    std::array<Layer, 2> layers_;
    unsigned int k_ = 0;
  };

  void add_boundary(const LabelGrid &grid,
                    const int i,
                    const int j,
                    const int k,
                    HexMesh &mesh)
  {
    const HexMesh::Cell &cell = mesh.cells.back();
    for (unsigned int face = 0; face < 6; ++face)
    {
      std::array<int, 3> neighbor{{i, j, k}};
      neighbor[face / 2] += face % 2 ? 1 : -1;
      if (grid.at_any(neighbor[0], neighbor[1], neighbor[2]) !=
          LabelGrid::nothing)
        continue;
      HexMesh::Facet facet;
      for (unsigned int v = 0; v < 4; ++v)
        facet.nodes[v] = cell[face_corners[face][v]];
      facet.cell = mesh.cells.size() - 1;
      mesh.boundary.push_back(facet);
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


HexMesh make_voxel_mesh(const LabelGrid &grid,
                        const std::vector<BodyPart> &parts)
{
  HexMesh mesh;
  mesh.parts = parts;
  NodeNumbers numbers(grid, mesh);
  for (unsigned int k = 0; k < grid.size[2]; ++k, numbers.advance())
    for (unsigned int j = 0; j < grid.size[1]; ++j)
      for (unsigned int i = 0; i < grid.size[0]; ++i)
      {
        const unsigned char label = grid.at(i, j, k);
        if (label == LabelGrid::nothing)
          continue;
        HexMesh::Cell cell;
        for (unsigned int c = 0; c < 8; ++c)
          cell[c] = numbers.number(i + corner_offset[c][0],
                                   j + corner_offset[c][1],
                                   corner_offset[c][2]);
        mesh.cells.push_back(cell);
        mesh.part.push_back(label);
        add_boundary(grid, i, j, k, mesh);
      }
  return mesh;
}
} // namespace contrecoup
