// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/// r^m for the radial exponents m = 0, 1, 2.
template <typename Number>
inline Number radial_power(const unsigned int exponent, const Number &r)
{
  return exponent == 0 ? Number(1.) : exponent == 1 ? r : Number(r * r);
}


/// Mean of r^m over a <= r <= b.
template <typename Number>
inline Number
radial_mean(const unsigned int exponent, const Number &a, const Number &b)
{
  return exponent == 0   ? Number(1.)
         : exponent == 1 ? Number((a + b) * 0.5)
                         : Number((a * a + a * b + b * b) * (1. / 3.));
}


/**
 * Inner radius, in radial edge lengths, above which a leaf collocates r^m at
 * its Galerkin nodes; nearer to the axis the volume of the innermost node
 * would vanish.
 */
inline constexpr double least_collocated_radius = 1. - 1e-6;


/**
 * Radial Jacobian (a mean of r^m) of node i of the n Gauss-Lobatto nodes of a
 * leaf along the radius: r^m at the node, minus the error of the trapezoidal
 * rule (n = 2) for r^2, so that the leaf's volume is exact. In leaves whose
 * inner radius is less than their edge length it is the exact mean over the
 * node's subcell.
 *
 * @param inner inner radius of the leaf [m]
 * @param extent radial edge length of the leaf [m]
 * @param node relative position of the node, from 0 to 1
 * @param begin, end boundaries of the node's subcell, from 0 to 1
 */
template <typename Number>
inline Number radial_jacobian(const unsigned int exponent,
                              const unsigned int n,
                              const Number &inner,
                              const Number &extent,
                              const double node,
                              const double begin,
                              const double end)
{
  if (exponent == 0)
    return Number(1.);
  Number collocated = radial_power(exponent, Number(inner + extent * node));
  if (exponent == 2 && n == 2)
    collocated -= extent * extent * (1. / 6.);
  return select_less(inner,
                     Number(extent * least_collocated_radius),
                     radial_mean(exponent,
                                 Number(inner + extent * begin),
                                 Number(inner + extent * end)),
                     collocated);
}


/**
 * Radial weights of the Galerkin scheme in curvilinear coordinates, per unit
 * angle: r^m at the nodes, radial_jacobian(), and face areas of the subcells.
 *
 * In a leaf that collocates, the face areas are telescoping sums: neighbouring
 * areas differ by the derivative of r^m at the node times its quadrature
 * weight, so that the divergences of the Galerkin scheme and of the subcells
 * agree. Near the axis the areas are r^m at the faces.
 */
template <typename Number>
class RadialNodes
{
public:
  RadialNodes(const unsigned int exponent, const unsigned int n)
    : exponent_(exponent)
    , n_(n)
    , basis_(n)
    , power_(n)
    , jacobian_(n)
    , inverse_jacobian_(n)
    , area_(n + 1)
  {}

  bool is_plane() const
  {
    return exponent_ == 0;
  }

  /// Computes the weights of leaves with inner radius @p inner [m] and radial
  /// edge length @p extent [m].
  void reinit(const Number &inner, const Number &extent)
  {
    const Number zero(0.), one(1.);
    near_axis_ =
      select_less(inner, Number(extent * least_collocated_radius), one, zero);
    any_near_axis_ = any_less(zero, near_axis_);
    for (unsigned int i = 0; i < n_; ++i)
      power_[i] =
        radial_power(exponent_, Number(inner + extent * basis_.nodes()[i]));
    area_[0] = radial_power(exponent_, inner);
    double begin = 0.;
    for (unsigned int i = 0; i < n_; ++i)
    {
      const double end = i + 1 < n_ ? begin + basis_.weights()[i] : 1.;
      const double node = basis_.nodes()[i];
      jacobian_[i] =
        radial_jacobian(exponent_, n_, inner, extent, node, begin, end);
      inverse_jacobian_[i] = one / jacobian_[i];
      Number telescoped = area_[i];
      for (unsigned int j = 0; j < n_; ++j)
        telescoped +=
          power_[j] * (basis_.weights()[i] * basis_.derivative()(i, j));
      const Number exact =
        radial_power(exponent_, Number(inner + extent * end));
      area_[i + 1] =
        i + 1 == n_ ? exact : select_less(zero, near_axis_, exact, telescoped);
      begin = end;
    }
  }

  /// r^m at a node; zero near the axis.
  Number collocated_power(const unsigned int node) const
  {
    return power_[node] * collocated();
  }

  /// See radial_jacobian().
  const Number &jacobian(const unsigned int node) const
  {
    return jacobian_[node];
  }
  const Number &inverse_jacobian(const unsigned int node) const
  {
    return inverse_jacobian_[node];
  }

  /// Area per unit angle of subcell face @p face, from 0 to n.
  const Number &area(const unsigned int face) const
  {
    return area_[face];
  }

  /// One in lanes of leaves near the axis (inner radius below the edge
  /// length), which use subcell volumes; zero in others.
  const Number &near_axis() const
  {
    return near_axis_;
  }
  /// One where near_axis() is zero and the other way round.
  Number collocated() const
  {
    return Number(1.) - near_axis_;
  }
  bool any_near_axis() const
  {
    return any_near_axis_;
  }

private:
  unsigned int exponent_;
  unsigned int n_;
  LobattoBasis basis_;
  bool any_near_axis_ = false;
  Number near_axis_;
  dealii::AlignedVector<Number> power_;
  dealii::AlignedVector<Number> jacobian_;
  dealii::AlignedVector<Number> inverse_jacobian_;
  dealii::AlignedVector<Number> area_;
};
} // namespace contrecoup::gas
