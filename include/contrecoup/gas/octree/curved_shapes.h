// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/polynomial.h>
#include <deal.II/base/tensor.h>
#include <deal.II/fe/mapping_fe.h>
#include <deal.II/grid/tria.h>

#include <memory>
#include <vector>

namespace contrecoup::gas
{
/**
 * Shapes of the leaves of an octree with curved manifolds: a leaf is the image
 * of the unit cube under a polynomial of one degree along each direction,
 * through Gauss-Lobatto nodes that deal.II's MappingQ places on the manifolds.
 *
 * A node in an edge or a face that hangs on a coarser leaf lies on the
 * polynomial of that leaf: deal.II's hanging node constraints hold for
 * positions as well. Fine faces make up the coarse one exactly then, and the
 * area vectors of a leaf sum to zero.
 */
template <int dim>
class CurvedShapes
{
public:
  /// @param triangulation must outlive this object
  /// @param degree polynomial degree of the leaves [-], from 1
  CurvedShapes(const dealii::Triangulation<dim> &triangulation,
               const unsigned int degree);

  /// Renews the nodes of owned and ghost leaves after a change of the
  /// triangulation. Collective.
  void reinit();

  /// Checks the determinant of the Jacobian at the nodes of owned leaves.
  /// @throws InputError for the first leaf that is inverted or flat
  void check(const std::string &mesh_name) const;

  /// The same shapes for deal.II; refers to this object.
  const dealii::Mapping<dim> &mapping() const
  {
    return *mapping_;
  }

  /// Position of the reference coordinates @p x, from 0 to 1, of the active
  /// cell @p index [m].
  dealii::Point<dim> place(const unsigned int index,
                           const dealii::Point<dim> &x) const
  {
    return position(index, x).place;
  }

  /// Derivatives of that position: of component i along reference direction j
  /// [m].
  dealii::Tensor<2, dim> derivative(const unsigned int index,
                                    const dealii::Point<dim> &x) const
  {
    return position(index, x).derivative;
  }

  /// Area vector out of a cell at a place of its face; see outward_area() in
  /// leaf_face.h.
  dealii::Tensor<1, dim> outward_area(const unsigned int index,
                                      const unsigned int face,
                                      const double a,
                                      const double b) const;

  std::size_t memory() const
  {
    return nodes_.capacity() * sizeof(nodes_[0]);
  }

private:
  /// Position and its derivatives; see place() and derivative().
  struct Position
  {
    dealii::Point<dim> place;
    dealii::Tensor<2, dim> derivative;
  };
  Position position(const unsigned int index,
                    const dealii::Point<dim> &x) const;
  /// Reference coordinates of a place in a cell or near it.
  /// @throws dealii::Mapping::ExcTransformationFailed for a place far outside
  dealii::Point<dim> reference_place(
    const typename dealii::Triangulation<dim>::cell_iterator &cell,
    const dealii::Point<dim> &place) const;
  const dealii::Point<dim> *first_node(const unsigned int index) const
  {
    return &nodes_[std::size_t(index) * n_nodes_];
  }

  /// Hands the nodes to deal.II in the order of FE_Q.
  class Mapping;

  const dealii::Triangulation<dim> &triangulation_;
  const unsigned int degree_;
  const unsigned int n_nodes_;
  std::vector<dealii::Polynomials::Polynomial<double>> basis_;
  std::vector<unsigned int> lexicographic_; ///< of the nodes of FE_Q
  std::vector<dealii::Point<dim>> nodes_;   ///< [active cell][node, x fastest]
  std::unique_ptr<dealii::Mapping<dim>> mapping_;
};

/// Whether deal.II would place a vertex of a finer cell elsewhere than in the
/// middle of those around it.
template <int dim>
bool has_curved_manifold(const dealii::Triangulation<dim> &triangulation);
} // namespace contrecoup::gas
