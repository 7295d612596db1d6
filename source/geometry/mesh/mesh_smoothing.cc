// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/geometry/mesh/mesh_smoothing.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

namespace
{
  constexpr double forwards = 0.6307;
  constexpr double backwards = -0.6732;

  /// Location of a node; higher values take precedence.
  enum NodeLocation : unsigned char
  {
    inside = 0,
    interface = 1,
    boundary = 2,
  };

  /// State of one call of smooth().
  class Smoother
  {
  public:
    Smoother(HexMesh &mesh, const SmoothingOptions &options)
      : mesh_(mesh)
      , options_(options)
      , locations_(mesh.nodes.size(), inside)
      , displacement_(mesh.nodes.size())
      , reduction_(mesh.nodes.size(), 1.F)
      , original_(mesh.nodes)
    {
      for (const auto &nodes : mesh.interfaces)
        for (const std::uint32_t node : nodes)
          locations_[node] = interface;
      for (const HexMesh::Facet &facet : mesh.boundary)
        for (const std::uint32_t node : facet.nodes)
          locations_[node] = boundary;
    }

    SmoothingReport run()
    {
      filter();
      spread();
      limit_displacements();
      SmoothingReport report;
      for (std::size_t i = 0; i < locations_.size(); ++i)
      {
        report.n_moved += locations_[i] != inside;
        report.n_held_back += reduction_[i] < 1.F;
        report.largest_displacement = std::max(
          report.largest_displacement, mesh_.nodes[i].distance(original_[i]));
      }
      return report;
    }

  private:
    /// Applies the filter to boundary and interfaces.
    void filter()
    {
      std::vector<Tensor<1, 3>> sum(locations_.size());
      std::vector<unsigned int> count(locations_.size());
      for (unsigned int step = 0; step < 2 * options_.iterations; ++step)
      {
        std::fill(sum.begin(), sum.end(), Tensor<1, 3>());
        std::fill(count.begin(), count.end(), 0);
        const auto add = [&](const auto &nodes, const NodeLocation location) {
          for (unsigned int v = 0; v < 4; ++v)
            for (const unsigned int w : {(v + 1) % 4, (v + 3) % 4})
              if (locations_[nodes[v]] == location)
              {
                sum[nodes[v]] += mesh_.nodes[nodes[w]];
                ++count[nodes[v]];
              }
        };
        for (const HexMesh::Facet &facet : mesh_.boundary)
          add(facet.nodes, boundary);
        for (const auto &nodes : mesh_.interfaces)
          add(nodes, interface);
        const double factor = step % 2 == 0 ? forwards : backwards;
        for (std::size_t i = 0; i < count.size(); ++i)
          if (count[i] > 0)
            mesh_.nodes[i] += factor * (sum[i] / count[i] - mesh_.nodes[i]);
      }
      for (std::size_t i = 0; i < locations_.size(); ++i)
        displacement_[i] = mesh_.nodes[i] - original_[i];
    }

    /// Diffuses displacements to interior nodes.
    void spread()
    {
      constexpr unsigned int n_rounds = 6;
      std::vector<Tensor<1, 3>> sum(locations_.size());
      std::vector<unsigned int> count(locations_.size());
      for (unsigned int round = 0; round < n_rounds; ++round)
      {
        std::fill(sum.begin(), sum.end(), Tensor<1, 3>());
        std::fill(count.begin(), count.end(), 0);
        for (const HexMesh::Cell &cell : mesh_.cells)
          for (const auto &edge : hex_edges)
            for (const auto &[to, from] :
                 {std::make_pair(cell[edge[0]], cell[edge[1]]),
                  std::make_pair(cell[edge[1]], cell[edge[0]])})
              if (locations_[to] == inside)
              {
                sum[to] += displacement_[from];
                ++count[to];
              }
        for (std::size_t i = 0; i < locations_.size(); ++i)
          if (locations_[i] == inside)
            displacement_[i] = sum[i] / std::max(count[i], 1u);
      }
    }

    /// Sets positions from displacements and their reduction factors.
    void apply()
    {
      for (std::size_t i = 0; i < locations_.size(); ++i)
        mesh_.nodes[i] = original_[i] + reduction_[i] * displacement_[i];
      for (const HexMesh::HangingNode &hanging : mesh_.hanging_nodes)
      {
        Tensor<1, 3> sum;
        for (std::size_t m = 0; m < hanging.masters.size(); ++m)
          sum += hanging.weights[m] * mesh_.nodes[hanging.masters[m]];
        mesh_.nodes[hanging.node] = Point<3>(sum);
      }
    }

    /// Reduces displacements until all elements satisfy the bound.
    void limit_displacements()
    {
      std::vector<unsigned char> is_reduced(locations_.size());
      while (true)
      {
        apply();
        std::fill(is_reduced.begin(), is_reduced.end(), 0);
        bool any = false;
        for (const HexMesh::Cell &cell : mesh_.cells)
          if (is_bad(cell))
          {
            any = true;
            for (const std::uint32_t node : cell)
              is_reduced[node] = 1;
          }
        if (!any)
          return;
        reduce(is_reduced);
      }
    }

    bool is_bad(const HexMesh::Cell &cell) const
    {
      HexCorners corners;
      for (unsigned int c = 0; c < 8; ++c)
        corners[c] = mesh_.nodes[cell[c]];
      return scaled_jacobian(corners) < options_.smallest_scaled_jacobian;
    }

    /// Reduces the factor of marked nodes; for hanging nodes, of their
    /// masters.
    void reduce(std::vector<unsigned char> &marked)
    {
      for (const HexMesh::HangingNode &hanging : mesh_.hanging_nodes)
        if (marked[hanging.node])
          for (const std::uint32_t master : hanging.masters)
            marked[master] = 1;
      for (std::size_t i = 0; i < marked.size(); ++i)
        if (marked[i])
          reduction_[i] = reduction_[i] < 0.1F ? 0.F : 0.75F * reduction_[i];
    }

    HexMesh &mesh_;
    const SmoothingOptions &options_;
    std::vector<unsigned char> locations_;
    std::vector<Tensor<1, 3>> displacement_;
    std::vector<float> reduction_;
    std::vector<Point<3>> original_;
  };
} // namespace

SmoothingReport smooth(HexMesh &mesh, const SmoothingOptions &options)
{
  return Smoother(mesh, options).run();
}
} // namespace contrecoup
