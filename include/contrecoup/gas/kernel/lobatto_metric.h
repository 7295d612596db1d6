// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_metric.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

namespace contrecoup::gas
{
/**
 * Metric terms at the Gauss-Lobatto nodes of one batch of leaves of any
 * shape, and the areas and volumes of the subcells around the nodes.
 *
 * The contravariant vectors are curls of interpolated vectors (Kopriva 2006,
 * J. Sci. Comput. 26, eq. 37), so that their discrete divergence vanishes at
 * every node: what flows uniformly goes on so. The areas telescope along each
 * line of nodes, from those of one leaf face to those of the other, in steps
 * of that divergence's terms (Hennemann, Rueda-Ramirez, Hindenlang and
 * Gassner 2021, eq. 28), so that finite volumes keep uniform flow likewise.
 */
template <int dim>
class LobattoMetric : public LeafMetric<dim>
{
public:
  using Base = LeafMetric<dim>;
  using Number = typename Base::Number;
  using Vector = typename Base::Vector;

  /// @param n nodes a side
  explicit LobattoMetric(const unsigned int n);

  /// Computes everything for the leaves of @p batch; padding lanes repeat
  /// the last leaf. face_center() is a node, and exists for leaf faces only.
  void reinit(const LeafMesh<dim> &mesh, const unsigned int batch);

  /// Jacobian times contravariant vector across @p direction at node
  /// @p point, times the quadrature weights of the other directions
  /// [m^(dim-1)]; on leaf faces it is the area vector.
  const Vector &normal(const unsigned int direction,
                       const unsigned int point) const
  {
    return normals_[direction * Base::volumes_.size() + point];
  }

private:
  /// Derivative of nodal @p values along @p direction at node @p point.
  template <typename Values>
  auto derivative(const Values &values,
                  const unsigned int direction,
                  const unsigned int point) const;
  void differentiate_places();
  void set_normals();
  void set_curl(const unsigned int direction);
  void set_volumes();
  void set_areas(const unsigned int direction);

  const LobattoBasis basis_;
  dealii::AlignedVector<Vector> places_;   ///< of nodes, from vertex 0
  dealii::AlignedVector<Vector> tangents_; ///< their derivatives, by direction
  dealii::AlignedVector<Vector> normals_;  ///< see normal()
  dealii::AlignedVector<Number> potential_;
};
} // namespace contrecoup::gas
