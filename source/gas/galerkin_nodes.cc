// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lane_math.h>
#include <contrecoup/gas/galerkin_nodes.h>
#include <contrecoup/gas/mapped_leaf_kernel.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::load(const double *state)
{
  const double *values = state + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
    {
      u[c].load(values + (c * n_points + q) * W);
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
void GalerkinNodes<dim, n, Gas, LeafBase>::set_blending()
{
  // Half of a neighbour's blending spreads, so that a shock that enters a
  // leaf finds it prepared (Hennemann et al. 2021, eq. 48).
  Number neighbor(0.);
  for (unsigned int face = 0; face < 2 * dim; ++face)
    neighbor = std::max(neighbor, LeafBase::neighbor_sensor_[face]);
  blending_ = std::max(LeafBase::sensor_, neighbor * 0.5);
  // At open ends finite volumes: an extrapolated polynomial would grow.
  for (unsigned int d = 0; d < dim; ++d)
    blending_ = std::max(blending_, LeafBase::open_[d]);
  any_blending_ = scheme_.blending && largest_lane(blending_) > 0.;
}


template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::finish(const Stage &stage)
{
  const double *start = stage.start + batch_ * layout_.batch_size();
  double *out = stage.out + batch_ * layout_.batch_size();
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points; ++q)
    {
      Number &u = conserved_[c][q];
      u += residual_[c][q] * stage.step;
      if (stage.a != 0.)
      {
        // Written so that a state at rest keeps every bit.
        Number old;
        old.load(start + (c * n_points + q) * W);
        u += (old - u) * stage.a;
      }
    }
  restore_positivity(stage);
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points; ++q)
      conserved_[c][q].store(out + (c * n_points + q) * W);

  // Padding lanes copy the first, so that they never overflow.
  for (unsigned int lane = mesh_.n_filled_lanes(batch_); lane < W; ++lane)
    for (std::size_t i = 0; i < layout_.batch_size(); i += W)
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
        conserved_[c][q] = mean[c] + theta * (conserved_[c][q] - mean[c]);
}


template <int dim, int n, typename Gas, typename LeafBase>
void GalerkinNodes<dim, n, Gas, LeafBase>::restore_positivity(
  const Stage &stage)
{
  // How close to the boundary of the admissible set a node may come,
  // relative to the mean.
  const double margin = 1e-8;
  const Number one(1.), zero(0.);

  Number density(std::numeric_limits<double>::max());
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
      *stage.unphysical_leaf = batch_ * W + lane;

  const Number least = average[C::density] * margin;
  Number theta = (average[C::density] - least) /
                 std::max(average[C::density] - density, least);
  theta = select_less(density, least, std::min(theta, one), one);
  scale_to_mean(average, theta, true);

  const Number spare = spare_energy<dim>(gas_, average);
  theta = one;
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = conserved_[c][q];
    const Number here = spare_energy<dim>(gas_, u);
    const Number goal = spare * (1. - margin);
    theta = std::min(
      theta, select_less(here, spare * margin, goal / (spare - here), one));
  }
  scale_to_mean(average, std::max(theta, zero), false);
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
  return std::min(indicator_.blending_factor(values),
                  Number(scheme_.largest_blending));
}


template class GalerkinNodes<2, 2, IdealGas, MappedLeafKernel<2, IdealGas>>;
template class GalerkinNodes<2, 3, IdealGas, MappedLeafKernel<2, IdealGas>>;
template class GalerkinNodes<2, 4, IdealGas, MappedLeafKernel<2, IdealGas>>;
template class GalerkinNodes<2,
                             2,
                             MieGrueneisen,
                             MappedLeafKernel<2, MieGrueneisen>>;
template class GalerkinNodes<2,
                             3,
                             MieGrueneisen,
                             MappedLeafKernel<2, MieGrueneisen>>;
template class GalerkinNodes<2,
                             4,
                             MieGrueneisen,
                             MappedLeafKernel<2, MieGrueneisen>>;
template class GalerkinNodes<3, 2, IdealGas, MappedLeafKernel<3, IdealGas>>;
template class GalerkinNodes<3, 3, IdealGas, MappedLeafKernel<3, IdealGas>>;
template class GalerkinNodes<3, 4, IdealGas, MappedLeafKernel<3, IdealGas>>;
template class GalerkinNodes<3,
                             2,
                             MieGrueneisen,
                             MappedLeafKernel<3, MieGrueneisen>>;
template class GalerkinNodes<3,
                             3,
                             MieGrueneisen,
                             MappedLeafKernel<3, MieGrueneisen>>;
template class GalerkinNodes<3,
                             4,
                             MieGrueneisen,
                             MappedLeafKernel<3, MieGrueneisen>>;
} // namespace contrecoup::gas
