// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/element/hex8_geometry.h>
#include <contrecoup/solid/body/solid_mesh.h>

#include <limits>
#include <numeric>
#include <set>
#include <sstream>

namespace contrecoup::solid
{
namespace
{
  /// Spreads the lower 21 bits of @p x with two zeros between them.
  std::uint64_t spread(std::uint64_t x)
  {
    x &= 0x1fffff;
    x = (x | x << 32) & 0x1f00000000ffffULL;
    x = (x | x << 16) & 0x1f0000ff0000ffULL;
    x = (x | x << 8) & 0x100f00f00f00f00fULL;
    x = (x | x << 4) & 0x10c30c30c30c30c3ULL;
    return (x | x << 2) & 0x1249249249249249ULL;
  }

  /// Cell numbers, sorted along a Morton curve through cell centres.
  std::vector<std::uint32_t> curve(const HexMesh &mesh)
  {
    dealii::Point<3> lower = mesh.nodes.front(), upper = lower;
    for (const auto &node : mesh.nodes)
      for (unsigned int d = 0; d < 3; ++d)
      {
        lower[d] = std::min(lower[d], node[d]);
        upper[d] = std::max(upper[d], node[d]);
      }
    double size = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      size = std::max(size, upper[d] - lower[d]);
    std::vector<std::uint64_t> key(mesh.cells.size());
    for (std::size_t i = 0; i < mesh.cells.size(); ++i)
    {
      std::uint64_t code = 0;
      for (unsigned int d = 0; d < 3; ++d)
      {
        double centre = 0.;
        for (const auto node : mesh.cells[i])
          centre += (mesh.nodes[node][d] - lower[d]) / 8.;
        const double scaled = 2097151. * centre / size;
        code |= spread(static_cast<std::uint64_t>(scaled)) << d;
      }
      key[i] = code;
    }
    std::vector<std::uint32_t> order(mesh.cells.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
      return std::make_pair(key[a], a) < std::make_pair(key[b], b);
    });
    return order;
  }

  /// Throws InputError unless the Jacobian of an element is positive at all
  /// Gauss points. A folded corner alone is allowed.
  void refuse_inverted(const HexMesh &mesh, const std::uint32_t cell)
  {
    HexVectors<double> x;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh.nodes[mesh.cells[cell][c]][d];
    x = to_modes(x);
    if (smallest_gauss_jacobian(x) > 0. && hex_geometry(x).volume > 0.)
      return;
    std::ostringstream message;
    message << "the mesh: hexahedron " << cell << " of \""
            << mesh.parts[mesh.part[cell]].name << "\" with a corner at ("
            << mesh.nodes[mesh.cells[cell][0]]
            << ") m is inverted: its Jacobian must be above 0 at all Gauss "
               "points";
    throw InputError(message.str());
  }

  /// Builds the part of one rank.
  class Distribution
  {
  public:
    Distribution(const HexMesh &mesh,
                 const MPI_Comm communicator,
                 const SlipInterface &slip)
      : mesh_(mesh)
      , slip_(slip)
      , rank_(dealii::Utilities::MPI::this_mpi_process(communicator))
      , n_ranks_(dealii::Utilities::MPI::n_mpi_processes(communicator))
      , order_(curve(mesh))
      , hanging_(mesh.nodes.size(), no_index)
      , local_node_(mesh.nodes.size(), no_index)
    {
      for (std::size_t i = 0; i < mesh.hanging_nodes.size(); ++i)
        hanging_[mesh.hanging_nodes[i].node] = i;
      if (!slip.pairs.empty())
        partner_.assign(mesh.nodes.size(), no_index);
      for (const SlipInterface::Pair &pair : slip.pairs)
      {
        partner_[pair.sliding] = pair.held;
        partner_[pair.held] = pair.sliding;
      }
    }

    SolidMesh build()
    {
      part_.n_global_elements = mesh_.cells.size();
      part_.n_global_nodes = mesh_.nodes.size();
      find_tissues();
      take_cells();
      take_hanging_nodes();
      take_slip_pairs();
      find_local_elements();
      part_.boundary = local_facets(mesh_.boundary);
      part_.slip.facets = local_facets(slip_.facets);
      share_nodes();
      return std::move(part_);
    }

  private:
    std::size_t begin(const unsigned int rank) const
    {
      return mesh_.cells.size() * rank / n_ranks_;
    }

    void find_tissues()
    {
      std::set<unsigned char> present;
      for (const unsigned char part : mesh_.part)
        present.insert(part);
      std::set<Tissue> tissues;
      for (const unsigned char part : present)
        tissues.insert(mesh_.parts[part].tissue);
      part_.tissues.assign(tissues.begin(), tissues.end());
      tissue_of_part_.resize(mesh_.parts.size());
      for (const unsigned char part : present)
        tissue_of_part_[part] = std::distance(
          tissues.begin(), tissues.find(mesh_.parts[part].tissue));
    }

    std::uint32_t take_node(const std::uint32_t node)
    {
      if (local_node_[node] == no_index)
      {
        local_node_[node] = part_.nodes.size();
        part_.nodes.push_back(mesh_.nodes[node]);
        part_.global_node.push_back(node);
      }
      return local_node_[node];
    }

    void take_cells()
    {
      for (std::size_t tissue = 0; tissue < part_.tissues.size(); ++tissue)
        for (std::size_t i = begin(rank_); i < begin(rank_ + 1); ++i)
        {
          const std::uint32_t cell = order_[i];
          if (tissue_of_part_[mesh_.part[cell]] != tissue)
            continue;
          refuse_inverted(mesh_, cell);
          HexMesh::Cell local;
          for (unsigned int c = 0; c < 8; ++c)
            local[c] = take_node(mesh_.cells[cell][c]);
          part_.elements.push_back(local);
          part_.tissue.push_back(tissue);
          part_.global_element.push_back(cell);
        }
    }

    void take_hanging_nodes()
    {
      const std::size_t n_nodes = part_.nodes.size();
      for (std::size_t i = 0; i < n_nodes; ++i)
        if (hanging_[part_.global_node[i]] != no_index)
        {
          HexMesh::HangingNode one =
            mesh_.hanging_nodes[hanging_[part_.global_node[i]]];
          one.node = i;
          for (std::uint32_t &master : one.masters)
            master = take_node(master);
          part_.hanging_nodes.push_back(std::move(one));
        }
    }

    void take_slip_pairs()
    {
      const std::size_t n_nodes = partner_.empty() ? 0 : part_.nodes.size();
      for (std::size_t i = 0; i < n_nodes; ++i)
        if (partner_[part_.global_node[i]] != no_index)
          take_node(partner_[part_.global_node[i]]);
      for (const SlipInterface::Pair &pair : slip_.pairs)
        if (local_node_[pair.sliding] != no_index)
          part_.slip.pairs.push_back(
            {local_node_[pair.sliding], local_node_[pair.held]});
    }

    void find_local_elements()
    {
      local_element_.assign(mesh_.cells.size(), no_index);
      for (std::size_t i = 0; i < part_.elements.size(); ++i)
        local_element_[part_.global_element[i]] = i;
    }

    /// The facets of this rank's cells, with local numbers.
    std::vector<HexMesh::Facet>
    local_facets(const std::vector<HexMesh::Facet> &facets) const
    {
      std::vector<HexMesh::Facet> local;
      for (HexMesh::Facet facet : facets)
        if (local_element_[facet.cell] != no_index)
        {
          facet.cell = local_element_[facet.cell];
          for (std::uint32_t &node : facet.nodes)
            node = local_node_[node];
          local.push_back(facet);
        }
      return local;
    }

    /// The other ranks that share each local node.
    std::vector<std::set<int>> find_holders() const
    {
      std::vector<std::set<int>> holders(part_.nodes.size());
      const auto add = [&](const std::uint32_t node, const int rank) {
        if (local_node_[node] != no_index)
          holders[local_node_[node]].insert(rank);
      };
      for (unsigned int rank = 0; rank < n_ranks_; ++rank)
        if (rank != rank_)
          for (std::size_t i = begin(rank); i < begin(rank + 1); ++i)
            for (const std::uint32_t node : mesh_.cells[order_[i]])
            {
              add(node, rank);
              if (!partner_.empty() && partner_[node] != no_index)
                add(partner_[node], rank);
              if (hanging_[node] != no_index)
                for (const auto master :
                     mesh_.hanging_nodes[hanging_[node]].masters)
                  add(master, rank);
            }
      return holders;
    }

    void share_nodes()
    {
      part_.owned.assign(part_.nodes.size(), 1);
      if (n_ranks_ == 1)
        return;
      const auto holders = find_holders();
      std::map<int, std::vector<std::uint32_t>> shared;
      for (std::size_t i = 0; i < holders.size(); ++i)
        for (const int rank : holders[i])
        {
          shared[rank].push_back(i);
          if (rank < static_cast<int>(rank_))
            part_.owned[i] = 0;
        }
      for (auto &[rank, nodes] : shared)
      {
        // Sorting by global number gives both ranks the same order.
        std::sort(nodes.begin(), nodes.end(), [&](const auto a, const auto b) {
          return part_.global_node[a] < part_.global_node[b];
        });
        part_.neighbors.push_back({rank, std::move(nodes)});
      }
    }

    const HexMesh &mesh_;
    const SlipInterface &slip_;
    unsigned int rank_;
    unsigned int n_ranks_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> hanging_; ///< number in hanging_nodes, by node
    std::vector<std::uint32_t> local_node_; ///< by global node
    /// other node of the pair, by node; empty if there are no pairs
    std::vector<std::uint32_t> partner_;
    std::vector<std::uint32_t> local_element_; ///< by global cell
    std::vector<std::size_t> tissue_of_part_;
    SolidMesh part_;
  };
} // namespace


SolidMesh distribute(const HexMesh &mesh,
                     const MPI_Comm communicator,
                     const SlipInterface &slip)
{
  return Distribution(mesh, communicator, slip).build();
}


std::string extent_in_words(const SolidMesh &mesh, const MPI_Comm communicator)
{
  std::vector<double> bounds(6, -std::numeric_limits<double>::max());
  for (const dealii::Point<3> &node : mesh.nodes)
    for (unsigned int d = 0; d < 3; ++d)
    {
      bounds[d] = std::max(bounds[d], -node[d]);
      bounds[3 + d] = std::max(bounds[3 + d], node[d]);
    }
  dealii::Utilities::MPI::max(bounds, communicator, bounds);
  const auto corner = [&](const unsigned int first, const double sign) {
    std::vector<std::string> numbers;
    for (unsigned int d = 0; d < 3; ++d)
      numbers.push_back(brief(sign * bounds[first + d] + 0.));
    return "(" + join(numbers, ", ") + ")";
  };
  return "the body lies from " + corner(0, -1.) + " to " + corner(3, 1.) + " m";
}


double cell_volume(const SolidMesh &mesh, const std::uint32_t cell)
{
  HexVectors<double> x;
  for (unsigned int c = 0; c < 8; ++c)
    for (unsigned int d = 0; d < 3; ++d)
      x[c][d] = mesh.nodes[mesh.elements[cell][c]][d];
  return hex_geometry(to_modes(x)).volume;
}
} // namespace contrecoup::solid
