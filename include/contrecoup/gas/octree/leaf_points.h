// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/octree/scheme.h>
#include <contrecoup/numerics/lobatto_basis.h>

#include <deal.II/base/point.h>

#include <array>
#include <optional>
#include <vector>

namespace contrecoup::gas
{
/**
 * Where the points of a leaf are and how much volume each stands for:
 * subcells of a finite-volume scheme, nodes and quadrature weights of a
 * Galerkin scheme. The geometry of curvilinear coordinates is included, per
 * unit angle: 2 pi in cylindrical and axisymmetric, 4 pi in spherical
 * geometry are factored in, so that volumes are those of the whole body.
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

  /// The basis of a Galerkin scheme.
  const LobattoBasis &basis() const
  {
    return *basis_;
  }

  /// Ends of the subcell of point @p i along an edge, from 0 to 1; the
  /// subcells of Galerkin nodes have the quadrature weights as widths.
  double subcell_begin(const unsigned int i) const
  {
    return subfaces_[i];
  }
  double subcell_end(const unsigned int i) const
  {
    return subfaces_[i + 1];
  }

  /// Place of point i along an edge, from 0 to 1.
  double position(const unsigned int i) const
  {
    return positions_[i];
  }

  /// Volume [m^dim, m^2 per m or m^3 as the geometry has it] of point @p q
  /// of a leaf with this lower corner and these edge lengths.
  double volume(const dealii::Point<dim> &origin,
                const dealii::Tensor<1, dim> &extents,
                const unsigned int q) const;

  /// Volume of a part of the leaf between the relative places @p begin and
  /// @p end.
  double volume(const dealii::Point<dim> &origin,
                const dealii::Tensor<1, dim> &extents,
                const dealii::Point<dim> &begin,
                const dealii::Point<dim> &end) const;

  /// The part of a leaf's volume that point @p q stands for in plane
  /// geometry.
  double relative_volume(const unsigned int q) const;

  /// Values l_i(x), i < n, that interpolate between the points at relative
  /// place @p x: polynomials, or piecewise linear between centres.
  std::vector<double> interpolation(const double x) const;

  /// Indices of point q along each direction.
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
