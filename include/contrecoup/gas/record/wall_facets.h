// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>

namespace contrecoup::gas
{
/**
 * The facets of a rigid body: the pieces of its surface in the cells that it
 * cuts. The pressure on one is that of the Riemann problem between the gas in
 * its cell and the mirror image.
 */
template <int dim>
class WallFacets
{
public:
  static constexpr unsigned int n_geometry = 6; ///< numbers of a facet

  /// A facet in the leaves of this rank.
  struct Facet
  {
    unsigned int leaf;
    unsigned int point;
    std::size_t number;          ///< among those of all ranks
    dealii::Tensor<1, dim> area; ///< vector, into the body [m^(dim-1)]
  };

  /// Finds the facets. Returns whether they are others than before. Collective.
  bool mesh_changed(const GasSnapshot<dim> &gas);

  /// The facets of this rank.
  const std::vector<Facet> &owned() const
  {
    return facets_;
  }

  /// Number of the facets of all ranks.
  std::size_t n_global() const
  {
    return keys_.size();
  }

  /// Of the facets of all ranks: centroid [m] and area vector, into the body
  /// [m^2, in 2-D m], n_geometry numbers each.
  const std::vector<double> &geometry() const
  {
    return geometry_;
  }

  /// Pressures on the facets of this rank above @p ambient; zero where the gas
  /// is quiet [Pa].
  std::vector<double> overpressures(const GasSnapshot<dim> &gas,
                                    const double ambient) const;

private:
  /// Facets of this rank by key and geometry.
  struct Found
  {
    std::vector<std::uint64_t> keys;
    std::vector<double> geometry;
  };

  void add_facets(const unsigned int leaf,
                  const GasSnapshot<dim> &gas,
                  Found &found);
  bool number_facets(const Found &found, const MPI_Comm communicator);

  std::vector<std::uint64_t> keys_; ///< places of all facets, in order
  std::vector<double> geometry_;
  std::vector<Facet> facets_;
};
} // namespace contrecoup::gas
