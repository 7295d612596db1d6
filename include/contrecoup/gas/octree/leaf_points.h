// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <vector>

namespace contrecoup::gas
{
/**
 * Positions and volumes of the points of a leaf: subcells of the finite-volume
 * scheme, nodes and quadrature weights of the Galerkin scheme. Volumes of
 * curvilinear coordinates include the full angle (2 pi in cylindrical and
 * axisymmetric, 4 pi in spherical geometry), so that sums are totals of the
 * whole body of revolution.
 */
template <int dim>
class LeafPoints
{
public:
  LeafPoints() = default;
  LeafPoints(const Scheme &scheme, const Geometry geometry);

  unsigned int n() const
  {
    return static_cast<unsigned int>(weights_.size());
  }

  bool is_galerkin() const
  {
    return basis_.has_value();
  }

  /// Lagrange basis of the Galerkin scheme.
  const LobattoBasis &basis() const
  {
    return *basis_;
  }

  /// Boundaries of the subcell of point @p i along an edge, from 0 to 1; the
  /// subcell of a Galerkin node is as wide as its quadrature weight.
  double subcell_begin(const unsigned int i) const
  {
    return subfaces_[i];
  }
  double subcell_end(const unsigned int i) const
  {
    return subfaces_[i + 1];
  }

  /// Position of point i along an edge, from 0 to 1.
  double position(const unsigned int i) const
  {
    return positions_[i];
  }

  /// Volume of point @p q of the leaf with lower corner @p origin and edge
  /// lengths @p extents [m^dim; m^2 in cylindrical, m^3 in axisymmetric and
  /// spherical geometry].
  double volume(const dealii::Point<dim> &origin,
                const dealii::Tensor<1, dim> &extents,
                const unsigned int q) const;

  /// Volume of the part of the leaf between the relative coordinates @p begin
  /// and @p end, in the same units.
  double volume(const dealii::Point<dim> &origin,
                const dealii::Tensor<1, dim> &extents,
                const dealii::Point<dim> &begin,
                const dealii::Point<dim> &end) const;

  /// Fraction of the leaf's volume that belongs to point @p q in plane
  /// geometry [-].
  double relative_volume(const unsigned int q) const;

  /// Interpolation weights l_i(x), i < n, of the points at relative position
  /// @p x: Lagrange polynomials of the nodes, or piecewise linear between
  /// centres of subcells.
  std::vector<double> interpolation(const double x) const;

  /// Index of point q along each direction.
  std::array<unsigned int, dim> indices(unsigned int q) const
  {
    std::array<unsigned int, dim> result;
    for (unsigned int d = 0; d < dim; ++d)
    {
      result[d] = q % n();
      q /= n();
    }
    return result;
  }

  /// Exponent of the radius in volumes: 0 in plane, 1 in cylindrical and
  /// axisymmetric, 2 in spherical geometry.
  unsigned int exponent() const
  {
    return exponent_;
  }

private:
  unsigned int exponent_ = 0;
  double angle_ = 1.;
  std::vector<double> positions_;
  std::vector<double> weights_;
  std::vector<double> subfaces_;
  std::optional<LobattoBasis> basis_;
};
} // namespace contrecoup::gas
