// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Scaling of a leaf's nodes towards their mean, where one of them would leave
 * the admissible states (Zhang and Shu 2010, J. Comput. Phys. 229, 8918). It
 * conserves, and moves nothing where all nodes are admissible.
 */
template <int dim, typename Gas, typename Number>
class ScalingToMean
{
public:
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  using C = Component<dim>;

  /// @param values conserved, [component][node]
  /// @param volume what each node stands for
  ScalingToMean(const Gas &gas,
                dealii::AlignedVector<Number> &values,
                const dealii::AlignedVector<Number> &volume)
    : gas_(gas)
    , values_(values)
    , volume_(volume)
    , n_points_(volume.size())
  {}

  /// Scales in lanes where density or energy are not positive.
  /// @param positivity false: such lanes count as unphysical all the same
  /// @returns zero in unphysical lanes, else one
  Number restore_positivity(const bool positivity)
  {
    const Number one(1.), zero(0.);
    Number density(std::numeric_limits<Real>::max());
    Number good(1.);
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      const Values u = node(q);
      density = std::min(density, u[C::density]);
      good = std::min(good, is_admissible<dim>(gas_, u));
    }
    if (!any_less(good, one))
      return one;
    const Values average = mean();
    const Number valid = is_admissible<dim>(gas_, average);
    const Number result = positivity ? valid : std::min(valid, good);

    const Number least = average[C::density] * margin;
    Number theta = (average[C::density] - least) /
                   std::max(average[C::density] - density, least);
    theta = select_less(density, least, std::min(theta, one), one);
    // Which leaves share a batch must not change what a leaf becomes.
    scale(average, select_less(good, one, theta, one), true);

    const Number spare = spare_energy<dim>(gas_, average);
    theta = one;
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      const Number here = spare_energy<dim>(gas_, node(q));
      const Number goal = spare * (1. - margin);
      theta = std::min(
        theta, select_less(here, spare * margin, goal / (spare - here), one));
    }
    theta = std::max(theta, zero);
    scale(average, select_less(good, one, theta, one), false);
    return result;
  }

  /// Scales the densities of products where a node's mass fraction leaves
  /// [0, 1], with the densities as weights.
  void bound_products()
  {
    const Number zero(0.), one(1.);
    Number smallest(1.), largest(0.);
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      const Number fraction = value(C::products, q) / value(C::density, q);
      smallest = std::min(smallest, fraction);
      largest = std::max(largest, fraction);
    }
    if (!any_less(smallest, zero) && !any_less(one, largest))
      return;
    const Values average = mean();
    // Not clipped: a mean just outside is kept, for the mass is.
    const Number fraction = average[C::products] / average[C::density];
    const auto factor = [&](const Number &room, const Number &distance) {
      return Number(
        room / std::max(distance, Number(std::numeric_limits<float>::min())));
    };
    Number theta =
      select_less(smallest, zero, factor(fraction, fraction - smallest), one);
    theta = std::min(
      theta,
      select_less(
        one, largest, factor(one - fraction, largest - fraction), one));
    theta = std::max(theta, zero);
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      const Number even = fraction * value(C::density, q);
      Number &products = value(C::products, q);
      products = select_less(
        theta, one, Number(even + theta * (products - even)), products);
    }
  }

private:
  using Real = typename Number::value_type;
  /// How close to the boundary of the admissible states a node may come,
  /// relative to the mean.
  static constexpr double margin = std::is_same_v<Real, float> ? 1e-5 : 1e-8;

  Number &value(const unsigned int c, const unsigned int q)
  {
    return values_[c * n_points_ + q];
  }

  Values node(const unsigned int q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = value(c, q);
    return u;
  }

  Values mean()
  {
    Number volume(0.);
    Values sum;
    sum.fill(Number(0.));
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      volume += volume_[q];
      for (unsigned int c = 0; c < nc; ++c)
        sum[c] += value(c, q) * volume_[q];
    }
    for (Number &component : sum)
      component = component / volume;
    return sum;
  }

  void scale(const Values &mean, const Number &theta, const bool densities_only)
  {
    for (unsigned int c = 0; c < nc; ++c)
      if (!densities_only || c == C::density || c == C::products)
        for (unsigned int q = 0; q < n_points_; ++q)
          value(c, q) =
            select_less(theta,
                        Number(1.),
                        Number(mean[c] + theta * (value(c, q) - mean[c])),
                        value(c, q));
  }

  const Gas &gas_;
  dealii::AlignedVector<Number> &values_;
  const dealii::AlignedVector<Number> &volume_;
  const unsigned int n_points_;
};
} // namespace contrecoup::gas
