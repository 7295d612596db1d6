// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/galerkin_kernel.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
// Fluxes carry the area r^m; the pressure acts by its differences alone, as
// r^m dp/dr, so that at rest every term vanishes.
template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::bind_radial()
{
  if constexpr (dim < 3)
    radial_.reinit(mesh_.origins(batch_)[0], mesh_.extents(batch_)[0]);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Number &volume = Base::volume_[q];
    volume = radial_.jacobian(q % n) * weight_[q % n];
    unsigned int rest = q / n;
    for (unsigned int d = 1; d < dim; ++d)
    {
      volume = volume * weight_[rest % n];
      rest /= n;
    }
  }
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::radial_volume_terms()
{
  Line flux;
  std::array<Number, n> pressure;
  for (unsigned int i = 0; i < n; ++i)
  {
    const Values &p = line_[i];
    const Number through = p[C::momentum] * radial_.power(i);
    for (unsigned int c = 0; c < nc; ++c)
      flux[i][c] = line_conserved_[i][c] * through;
    flux[i][C::energy] += p[C::energy] * through;
    pressure[i] = p[C::energy] - reference_pressure_;
  }
  for (unsigned int i = 0; i < n; ++i)
  {
    Number force(0.);
    for (unsigned int j = 0; j < n; ++j)
      force += pressure[j] * weak_derivative_[i][j];
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number sum(0.);
      for (unsigned int j = 0; j < n; ++j)
        sum += flux[j][c] * weak_derivative_[i][j];
      if (i == 0)
        sum += low_flux_[c] * radial_.area(0) * (1. / weight_[0]);
      if (i == n - 1)
        sum -= high_flux_[c] * radial_.area(n) * (1. / weight_[n - 1]);
      if (c == C::momentum)
        sum += force * radial_.power(i);
      line_residual_[i][c] = sum * radial_.inverse_jacobian(i);
    }
  }
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::radial_subcell_terms(
  const std::array<Values, n + 1> &flux)
{
  const Number blending =
    std::max(any_blending_ ? blending_ : Number(0.), radial_.near_axis());
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
    {
      // The pressure of the subcell itself exerts no net force on it.
      const Number base = c == C::momentum
                            ? line_[i][C::energy] - reference_pressure_
                            : Number(0.);
      const Number difference = (flux[i][c] - base) * radial_.area(i) -
                                (flux[i + 1][c] - base) * radial_.area(i + 1);
      Number &residual = line_residual_[i][c];
      residual += blending * (difference * (1. / weight_[i]) *
                                radial_.inverse_jacobian(i) -
                              residual);
    }
}


#define CONTRECOUP_INSTANTIATE(n)                       \
  template class GalerkinKernel<1, n, IdealGas>;        \
  template class GalerkinKernel<2, n, IdealGas>;        \
  template class GalerkinKernel<3, n, IdealGas>;        \
  template class GalerkinKernel<3, n, IdealGas, float>; \
  template class GalerkinKernel<1, n, MieGrueneisen>;   \
  template class GalerkinKernel<2, n, MieGrueneisen>;   \
  template class GalerkinKernel<3, n, MieGrueneisen>;   \
  template class GalerkinKernel<3, n, MieGrueneisen, float>

CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
CONTRECOUP_INSTANTIATE(4);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
