// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/element/hex8_moments.h>
#include <contrecoup/solid/body/slip_interface.h>

#include <algorithm>
#include <map>

namespace contrecoup::solid
{
namespace
{
  /// Sides of an interface that touch a node, one bit each.
  constexpr unsigned char sliding_side = 1, held_side = 2, neither = 4;
  constexpr unsigned char both = sliding_side | held_side;

  /// Least length of the sum of the faces' normals at a node over the sum of
  /// their areas.
  constexpr double least_agreement = 0.3;

  using FaceNodes = std::array<std::uint32_t, 4>;

  FaceNodes face_of(const HexMesh::Cell &cell, const unsigned int face)
  {
    FaceNodes nodes;
    for (unsigned int v = 0; v < 4; ++v)
      nodes[v] = cell[hex_faces[face][v]];
    return nodes;
  }

  FaceNodes sorted(FaceNodes nodes)
  {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
  }

  bool contains(const std::vector<Tissue> &tissues, const Tissue tissue)
  {
    return std::find(tissues.begin(), tissues.end(), tissue) != tissues.end();
  }

  /// Divides the nodes of a mesh.
  class Split
  {
  public:
    Split(HexMesh &mesh,
          const std::vector<Tissue> &sliding,
          const std::vector<Tissue> &held)
      : mesh_(mesh)
      , touched_(mesh.nodes.size(), 0)
    {
      for (std::size_t i = 0; i < mesh.cells.size(); ++i)
      {
        const Tissue tissue = mesh.parts[mesh.part[i]].tissue;
        side_.push_back(contains(sliding, tissue) ? sliding_side
                        : contains(held, tissue)  ? held_side
                                                  : neither);
        for (const std::uint32_t node : mesh.cells[i])
          touched_[node] |= side_.back();
      }
    }

    /// Faces between both sides, as faces of the sliding one.
    std::vector<HexMesh::Facet> find_facets() const
    {
      std::map<FaceNodes, std::uint32_t> held;
      visit_faces(held_side, [&](const std::uint32_t cell, const auto &nodes) {
        held[sorted(nodes)] = cell;
      });
      std::vector<HexMesh::Facet> facets;
      visit_faces(sliding_side,
                  [&](const std::uint32_t cell, const auto &nodes) {
                    if (held.count(sorted(nodes)) > 0)
                      facets.push_back({nodes, cell});
                  });
      return facets;
    }

    /// Whether each node gets a copy.
    std::vector<bool>
    find_split_nodes(const std::vector<HexMesh::Facet> &facets) const
    {
      std::map<std::uint32_t, std::pair<dealii::Tensor<1, 3>, double>> sums;
      for (const HexMesh::Facet &facet : facets)
      {
        const auto area = mesh_.area_vector(facet);
        for (const std::uint32_t node : facet.nodes)
        {
          sums[node].first += area;
          sums[node].second += area.norm();
        }
      }
      std::vector<bool> is_split(mesh_.nodes.size());
      for (const auto &[node, sum] : sums)
        is_split[node] = touched_[node] == both &&
                         sum.first.norm() > least_agreement * sum.second;
      return is_split;
    }

    /// Creates the copies and gives them to the sliding side.
    SlipInterface divide(const std::vector<bool> &is_split,
                         std::vector<HexMesh::Facet> facets)
    {
      SlipInterface result;
      std::vector<std::uint32_t> copy(is_split.size(), no_index);
      for (std::uint32_t node = 0; node < is_split.size(); ++node)
        if (is_split[node])
        {
          copy[node] = static_cast<std::uint32_t>(mesh_.nodes.size());
          result.pairs.push_back({copy[node], node});
          mesh_.nodes.push_back(dealii::Point<3>(mesh_.nodes[node]));
        }
      const auto replace = [&](auto &nodes) {
        for (std::uint32_t &node : nodes)
          if (copy[node] != no_index)
            node = copy[node];
      };
      for (std::size_t i = 0; i < side_.size(); ++i)
        if (side_[i] == sliding_side)
          replace(mesh_.cells[i]);
      for (HexMesh::Facet &facet : mesh_.boundary)
        if (side_[facet.cell] == sliding_side)
          replace(facet.nodes);
      for (HexMesh::Facet &facet : facets)
        replace(facet.nodes);
      result.facets = std::move(facets);
      return result;
    }

  private:
    /// Calls @p function for faces of one side whose nodes touch both.
    template <typename Function>
    void visit_faces(const unsigned char side, const Function &function) const
    {
      for (std::uint32_t i = 0; i < side_.size(); ++i)
        if (side_[i] == side)
          for (unsigned int f = 0; f < 6; ++f)
          {
            const FaceNodes nodes = face_of(mesh_.cells[i], f);
            if (std::all_of(nodes.begin(), nodes.end(), [&](const auto node) {
                  return (touched_[node] & both) == both;
                }))
              function(i, nodes);
          }
    }

    HexMesh &mesh_;
    std::vector<unsigned char> side_;    ///< by cell
    std::vector<unsigned char> touched_; ///< by node
  };

  /// @throws InputError if a node that is split hangs or is a master
  void refuse_hanging(const HexMesh &mesh,
                      const std::vector<bool> &is_split,
                      const std::string &entry)
  {
    for (const HexMesh::HangingNode &one : mesh.hanging_nodes)
    {
      bool here = is_split[one.node];
      for (const std::uint32_t master : one.masters)
        here = here || is_split[master];
      if (here)
        throw InputError(entry +
                         ": elements of different size meet where tissues "
                         "slide; set Mesh/Coarsening levels = 0, or refine "
                         "both sides");
    }
  }
} // namespace


SlipInterface split_interface(HexMesh &mesh,
                              const std::vector<Tissue> &sliding,
                              const std::vector<Tissue> &held,
                              const std::string &entry)
{
  Split split(mesh, sliding, held);
  const std::vector<HexMesh::Facet> facets = split.find_facets();
  const std::vector<bool> is_split = split.find_split_nodes(facets);
  if (std::find(is_split.begin(), is_split.end(), true) == is_split.end())
    throw InputError(entry +
                     ": the tissues of Tissues and Against share no face in "
                     "this mesh, or only at nodes that a third tissue touches");
  refuse_hanging(mesh, is_split, entry);
  return split.divide(is_split, facets);
}
} // namespace contrecoup::solid
