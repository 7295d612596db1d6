// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/galerkin_nodes.h>
#include <contrecoup/gas/kernel/mapped_leaf_kernel.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::load(const Real *state)
{
  const Real *values = state + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
    {
      u[c].load(values + (c * n_points + q) * LeafBase::width);
      conserved_[c][q] = u[c];
    }
    const Values p = to_primitive<dim>(gas_, u);
    for (unsigned int c = 0; c < nc; ++c)
      primitive_[c][q] = p[c];
  }
  // Only differences of the pressure act inside a leaf; measured from one
  // of its nodes they vanish exactly in gas at rest.
  reference_pressure_ = primitive_[C::energy][0];
}


template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::set_blending(const Number &least)
{
  // Half of a neighbour's blending spreads, so that a shock that enters a
  // leaf finds it prepared (Hennemann et al. 2021, eq. 48).
  Number neighbor(0.);
  for (unsigned int face = 0; face < 2 * dim; ++face)
    neighbor = std::max(neighbor, LeafBase::neighbor_sensor_[face]);
  blending_ =
    std::max(std::max(LeafBase::sensor_, Number(neighbor * 0.5)), least);
  any_blending_ = scheme_.blending && largest_lane(blending_) > 0.;
}


template <int dim, int n, typename Gas, typename LeafBase>
typename GalerkinNodes<dim, n, Gas, LeafBase>::Line
GalerkinNodes<dim, n, Gas, LeafBase>::subcell_slopes(
  const Line &line,
  const std::array<Values, 2> &beyond) const
{
  Line slope;
  for (unsigned int c = 0; c < nc; ++c)
  {
    Number backward = (line[0][c] - beyond[0][c]) * inverse_distance_[0];
    for (unsigned int i = 0; i < n; ++i)
    {
      const Number next = i + 1 < n ? line[i + 1][c] : beyond[1][c];
      const Number forward = (next - line[i][c]) * inverse_distance_[i + 1];
      slope[i][c] =
        limited_slope(scheme_.limiter, backward, forward, slope_weights_[i]);
      backward = forward;
    }
  }
  return slope;
}


template <int dim, int n, typename Gas, typename LeafBase>
std::array<typename GalerkinNodes<dim, n, Gas, LeafBase>::Values, 2>
GalerkinNodes<dim, n, Gas, LeafBase>::subcell_traces(const unsigned int f,
                                                     const Line &line,
                                                     const Line &slope) const
{
  std::array<Values, 2> traces;
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int i = f - 1 + side;
    for (unsigned int c = 0; c < nc; ++c)
      traces[side][c] = line[i][c] + slope[i][c] * (subface_[f] - center_[i]);
    restore_if_inadmissible<dim>(gas_, line[i], traces[side]);
  }
  return traces;
}


template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::finish(const BasicStage<Real> &stage)
{
  const Real *start = stage.start + batch_ * layout_.batch_size();
  Real *out = stage.out + batch_ * layout_.batch_size();
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points; ++q)
    {
      Number &u = conserved_[c][q];
      u += residual_[c][q] * stage.step;
      if (stage.a != 0.)
      {
        // Written so that a state at rest keeps every bit.
        Number old;
        old.load(start + (c * n_points + q) * LeafBase::width);
        u += (old - u) * stage.a;
      }
    }
  restore_positivity(stage);
  if constexpr (Gas::has_products)
    bound_products();
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points; ++q)
      conserved_[c][q].store(out + (c * n_points + q) * LeafBase::width);

  // Padding lanes copy the first, so that they never overflow.
  for (unsigned int lane = mesh_.n_filled_lanes(batch_); lane < LeafBase::width;
       ++lane)
    for (std::size_t i = 0; i < layout_.batch_size(); i += LeafBase::width)
      out[i + lane] = out[i];
}


template <int dim, int n, typename Gas, typename LeafBase>
typename GalerkinNodes<dim, n, Gas, LeafBase>::Values
GalerkinNodes<dim, n, Gas, LeafBase>::mean() const
{
  Values sum;
  sum.fill(Number(0.));
  if (has_volumes_)
  {
    Number volume(0.);
    for (unsigned int q = 0; q < n_points; ++q)
    {
      volume += volume_[q];
      for (unsigned int c = 0; c < nc; ++c)
        sum[c] += conserved_[c][q] * volume_[q];
    }
    for (unsigned int c = 0; c < nc; ++c)
      sum[c] = sum[c] / volume;
    return sum;
  }
  for (unsigned int q = 0; q < n_points; ++q)
  {
    double weight = 1.;
    unsigned int rest = q;
    for (unsigned int d = 0; d < dim; ++d)
    {
      weight *= weight_[rest % n];
      rest /= n;
    }
    for (unsigned int c = 0; c < nc; ++c)
      sum[c] += conserved_[c][q] * weight;
  }
  return sum;
}


template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::scale_to_mean(
  const Values &mean,
  const Number &theta,
  const bool densities_only)
{
  for (unsigned int c = 0; c < nc; ++c)
    if (!densities_only || c == C::density || c == C::products)
      for (unsigned int q = 0; q < n_points; ++q)
        conserved_[c][q] =
          select_less(theta,
                      Number(1.),
                      Number(mean[c] + theta * (conserved_[c][q] - mean[c])),
                      conserved_[c][q]);
}


template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::restore_positivity(
  const BasicStage<Real> &stage)
{
  // How close to the boundary of the admissible set a node may come,
  // relative to the mean.
  const double margin = std::is_same_v<Real, float> ? 1e-5 : 1e-8;
  const Number one(1.), zero(0.);

  Number density(std::numeric_limits<Real>::max());
  Number good(1.);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = conserved_[c][q];
    density = std::min(density, u[C::density]);
    good = std::min(good, is_admissible<dim>(gas_, u));
  }
  if (!any_less(good, one))
    return;

  const Values average = mean();
  const Number valid = is_admissible<dim>(gas_, average);
  for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch_); ++lane)
    if (valid[lane] < 1. || (!scheme_.positivity && good[lane] < 1.))
      *stage.unphysical_leaf = batch_ * LeafBase::width + lane;

  const Number least = average[C::density] * margin;
  Number theta = (average[C::density] - least) /
                 std::max(average[C::density] - density, least);
  theta = select_less(density, least, std::min(theta, one), one);
  scale_to_mean(average, theta, true);

  const Number spare = energy_above_cold_curve<dim>(gas_, average);
  theta = one;
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = conserved_[c][q];
    const Number here = energy_above_cold_curve<dim>(gas_, u);
    const Number goal = spare * (1. - margin);
    theta = std::min(
      theta, select_less(here, spare * margin, goal / (spare - here), one));
  }
  scale_to_mean(average, std::max(theta, zero), false);
}


// Where a node's mass fraction leaves [0, 1], those of all nodes are scaled
// towards the leaf's mean, with the densities as weights.
template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::bound_products()
{
  const Number zero(0.), one(1.);
  Number smallest(1.), largest(0.);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const Number fraction =
      conserved_[C::products][q] / conserved_[C::density][q];
    smallest = std::min(smallest, fraction);
    largest = std::max(largest, fraction);
  }
  if (!any_less(smallest, zero) && !any_less(one, largest))
    return;
  const Values average = mean();
  // Not clipped: a mean just outside is kept, for the mass is.
  const Number fraction = average[C::products] / average[C::density];
  const Number tiny(std::numeric_limits<float>::min());
  Number theta =
    select_less(smallest,
                zero,
                Number(fraction / std::max(Number(fraction - smallest), tiny)),
                one);
  theta =
    std::min(theta,
             select_less(one,
                         largest,
                         Number((one - fraction) /
                                std::max(Number(largest - fraction), tiny)),
                         one));
  theta = std::max(theta, zero);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const Number even = fraction * conserved_[C::density][q];
    conserved_[C::products][q] =
      select_less(theta,
                  one,
                  Number(even + theta * (conserved_[C::products][q] - even)),
                  conserved_[C::products][q]);
  }
}


template <int dim, int n, typename Gas, typename LeafBase>
typename GalerkinNodes<dim, n, Gas, LeafBase>::Number
GalerkinNodes<dim, n, Gas, LeafBase>::blending_factor() const
{
  if (!scheme_.blending)
    return Number(0.);
  std::array<Number, n_points> values;
  for (unsigned int q = 0; q < n_points; ++q)
    values[q] = primitive_[C::density][q] * primitive_[C::energy][q];
  if constexpr (std::is_same_v<Real, float>)
  {
    // Their squares would not fit.
    Number largest(std::numeric_limits<Real>::min());
    for (const Number &value : values)
      largest = std::max(largest, std::abs(value));
    const Number scale = Number(1.) / largest;
    for (Number &value : values)
      value *= scale;
  }
  return std::min(indicator_.blending_factor(values),
                  Number(scheme_.largest_blending));
}


#define CONTRECOUP_INSTANTIATE(n, Gas)                                \
  template class GalerkinNodes<1, n, Gas, LeafKernel<1, Gas>>;        \
  template class GalerkinNodes<2, n, Gas, LeafKernel<2, Gas>>;        \
  template class GalerkinNodes<3, n, Gas, LeafKernel<3, Gas>>;        \
  template class GalerkinNodes<3, n, Gas, LeafKernel<3, Gas, float>>; \
  template class GalerkinNodes<2, n, Gas, MappedLeafKernel<2, Gas>>;  \
  template class GalerkinNodes<3, n, Gas, MappedLeafKernel<3, Gas>>

CONTRECOUP_INSTANTIATE(2, IdealGas);
CONTRECOUP_INSTANTIATE(3, IdealGas);
CONTRECOUP_INSTANTIATE(4, IdealGas);
CONTRECOUP_INSTANTIATE(2, MieGrueneisen);
CONTRECOUP_INSTANTIATE(3, MieGrueneisen);
CONTRECOUP_INSTANTIATE(4, MieGrueneisen);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
