// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/materials/gas_material.h>

#include <functional>
#include <vector>

namespace contrecoup::gas
{
/**
 * The gas at given places, interpolated within the leaf that holds each:
 * the result depends neither on the number of ranks nor on when the mesh
 * was adapted. A place that leaves share belongs to the upper one in a box,
 * in other meshes to the one whose cell's name comes first.
 */
template <int dim>
class PointSampler
{
public:
  /// Finds the leaves of @p places. Call again when the mesh changed.
  /// Collective. @throws InputError for a place outside of the mesh.
  void reinit(const std::vector<dealii::Point<dim>> &places,
              const LeafMesh<dim> &mesh,
              const LeafPoints<dim> &points);

  /// The primitive states at all places, on every rank. Collective.
  std::vector<GasState<dim>> sample(const GasField &field,
                                    const GasMaterial &material) const;

  /// Calls @p take with the number and the primitive state of each place on
  /// a leaf of this rank.
  void for_each(
    const GasField &field,
    const GasMaterial &material,
    const std::function<void(unsigned int, const GasState<dim> &)> &take) const;

  /// Values of the points that are nearest to each place, @p n_values for
  /// each on every rank; @p read gives those of a leaf's point. Collective.
  std::vector<double> nearest(
    const unsigned int n_values,
    const std::function<
      void(unsigned int leaf, unsigned int point, double *values)> &read) const;

  /// Numbers of the places on leaves of this rank, by leaf.
  std::vector<unsigned int> local_places() const;

private:
  /// Takes @p place, at relative coordinates @p x of the leaf @p cell.
  void add_place(const unsigned int index,
                 const typename LeafMesh<dim>::CellIterator &cell,
                 const dealii::Point<dim> &x,
                 const LeafMesh<dim> &mesh,
                 const LeafPoints<dim> &points);
  void find_in_box(const std::vector<dealii::Point<dim>> &places,
                   const LeafMesh<dim> &mesh,
                   const LeafPoints<dim> &points);
  void find_in_cells(const std::vector<dealii::Point<dim>> &places,
                     const LeafMesh<dim> &mesh,
                     const LeafPoints<dim> &points);

  struct Place
  {
    unsigned int index; ///< in the list of places
    unsigned int leaf;
    unsigned int nearest; ///< point of the leaf
    /// Points of the leaf that count, with their weights.
    std::vector<std::pair<unsigned int, double>> weights;
  };

  /// Conserved quantities and burned fraction at each place of this rank,
  /// [place][component].
  std::vector<double> conserved(const GasField &field) const;
  /// The primitive state of a row of these.
  static GasState<dim> state_of(const double *values,
                                const GasField &field,
                                const GasMaterial &material);

  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::size_t n_places_ = 0;
  std::vector<Place> places_; ///< on leaves of this rank
};
} // namespace contrecoup::gas
