// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/octree/radial_nodes.h>

#include <deal.II/base/numbers.h>

namespace contrecoup::gas
{
namespace
{
  double full_angle(const Geometry geometry)
  {
    switch (geometry)
    {
      case Geometry::plane:
        return 1.;
      case Geometry::cylindrical:
      case Geometry::axisymmetric:
        return 2. * dealii::numbers::PI;
      case Geometry::spherical:
        return 4. * dealii::numbers::PI;
    }
    return 1.;
  }
} // namespace


template <int dim>
LeafPoints<dim>::LeafPoints(const Scheme &scheme, const Geometry geometry)
  : exponent_(radial_exponent(geometry))
  , angle_(full_angle(geometry))
{
  const unsigned int n = scheme.n_points;
  if (scheme.kind == Scheme::Kind::discontinuous_galerkin)
  {
    basis_.emplace(n);
    positions_ = basis_->nodes();
    weights_ = basis_->weights();
  }
  else
    for (unsigned int i = 0; i < n; ++i)
    {
      positions_.push_back((i + 0.5) / n);
      weights_.push_back(1. / n);
    }
  subfaces_.push_back(0.);
  for (unsigned int i = 0; i < n; ++i)
    subfaces_.push_back(basis_ ? subfaces_.back() + weights_[i]
                               : double(i + 1) / n);
  subfaces_.back() = 1.;
}


template <int dim>
double LeafPoints<dim>::volume(const dealii::Point<dim> &origin,
                               const dealii::Tensor<1, dim> &extents,
                               const unsigned int q) const
{
  const auto index = indices(q);
  dealii::Point<dim> begin, end;
  if (exponent_ != 0 && !is_galerkin())
  {
    for (unsigned int d = 0; d < dim; ++d)
    {
      begin[d] = subcell_begin(index[d]);
      end[d] = subcell_end(index[d]);
    }
    return volume(origin, extents, begin, end);
  }
  double result = relative_volume(q);
  if (exponent_ != 0)
    result *= angle_ * radial_jacobian(exponent_,
                                       n(),
                                       origin[0],
                                       extents[0],
                                       position(index[0]),
                                       subcell_begin(index[0]),
                                       subcell_end(index[0]));
  for (unsigned int d = 0; d < dim; ++d)
    result *= extents[d];
  return result;
}


template <int dim>
double LeafPoints<dim>::volume(const dealii::Point<dim> &origin,
                               const dealii::Tensor<1, dim> &extents,
                               const dealii::Point<dim> &begin,
                               const dealii::Point<dim> &end) const
{
  double result = angle_ * radial_mean(exponent_,
                                       origin[0] + extents[0] * begin[0],
                                       origin[0] + extents[0] * end[0]);
  for (unsigned int d = 0; d < dim; ++d)
    result *= extents[d] * (end[d] - begin[d]);
  return result;
}


template <int dim>
double LeafPoints<dim>::relative_volume(const unsigned int q) const
{
  double result = 1.;
  for (const unsigned int i : indices(q))
    result *= weights_[i];
  return result;
}


template <int dim>
std::vector<double> LeafPoints<dim>::interpolation(const double x) const
{
  if (is_galerkin())
    return basis_->values(x);
  std::vector<double> values(n(), 0.);
  if (n() == 1)
  {
    values[0] = 1.;
    return values;
  }
  // Constant beyond the outermost centres: linear extrapolation could leave
  // the admissible states.
  const double place = std::min(std::max(x * n() - 0.5, 0.), n() - 1.);
  const unsigned int i = std::min(static_cast<unsigned int>(place), n() - 2);
  values[i] = 1. - (place - i);
  values[i + 1] = place - i;
  return values;
}


template class LeafPoints<1>;
template class LeafPoints<2>;
template class LeafPoints<3>;
} // namespace contrecoup::gas
