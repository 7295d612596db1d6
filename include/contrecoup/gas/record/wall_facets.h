// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/io/file/skin_file.h>

namespace contrecoup::gas
{
/**
 * Facets of a rigid body: the pieces of its surface in the cut cells. The
 * pressure on a facet is that of the Riemann problem between the gas in its
 * cell and the mirror image of that gas.
 */
template <int dim>
class WallFacets
{
public:
  static constexpr unsigned int n_geometry = 6; ///< values per facet

  /// A facet in a leaf of this rank.
  struct Facet
  {
    unsigned int leaf;
    unsigned int point;
    std::size_t number;          ///< among the facets of all ranks
    dealii::Tensor<1, dim> area; ///< vector, into the body [m^(dim-1)]
  };

  /// Finds the facets. Returns whether they differ from the previous ones.
  /// Collective.
  bool mesh_changed(const GasSnapshot<dim> &gas);

  /// The facets of this rank.
  const std::vector<Facet> &owned() const
  {
    return facets_;
  }

  /// Number of facets on all ranks.
  std::size_t n_global() const
  {
    return keys_.size();
  }

  /// Centroid [m] and area vector into the body [m^2; in 2-D m] of the facets
  /// of all ranks, n_geometry values each.
  const std::vector<double> &geometry() const
  {
    return geometry_;
  }

  /// Outlines of the facets of all ranks, on the first rank alone: those of the
  /// cut cells, see cut_outline() and closed_outline(). A cell that was closed
  /// because its neighbours are too small has a square (in 2-D a line) about
  /// the centroid with the facet's area and normal.
  const io::SkinMesh &skin() const
  {
    return skin_;
  }

  /// Overpressures on the facets of this rank relative to @p ambient [Pa]; zero
  /// in quiet leaves.
  std::vector<double> overpressures(const GasSnapshot<dim> &gas,
                                    const double ambient) const;

private:
  /// Keys and geometry of the facets of this rank.
  struct Found
  {
    std::vector<std::uint64_t> keys;
    std::vector<double> geometry;
  };

  void add_facets(const unsigned int leaf,
                  const GasSnapshot<dim> &gas,
                  Found &found);
  bool number_facets(const Found &found, const MPI_Comm communicator);
  /// Finds skin(). Collective.
  void find_outlines(const GasSnapshot<dim> &gas);
  /// Corners of a facet, three numbers each [m].
  std::vector<float> outline(const Facet &facet,
                             const GasSnapshot<dim> &gas) const;

  std::vector<std::uint64_t> keys_; ///< of the facets of all ranks, ascending
  std::vector<double> geometry_;
  std::vector<Facet> facets_;
  io::SkinMesh skin_;
};
} // namespace contrecoup::gas
