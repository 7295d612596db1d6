// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/galerkin_kernel.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::find_slopes(
  const unsigned int direction)
{
  std::array<Values, 2> beyond = beyond_;
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->face / 2 == direction)
    {
      // A wall mirrors; at other ends without an equal neighbour the end
      // subcell has no slope.
      const bool is_wall =
        s->kind == SpecialFace::Kind::boundary &&
        Base::boundary_.kind(s->index) == Boundary<dim>::Kind::wall;
      for (unsigned int c = 0; c < nc; ++c)
      {
        const double end = line_[s->face % 2 ? n - 1 : 0][c][s->lane];
        beyond[s->face % 2][c][s->lane] =
          is_wall && c == C::momentum ? -end : end;
      }
    }
  slope_ = Base::subcell_slopes(line_, beyond);
}


// Both leaves at a face compute the same two states, from the sensors and two
// subcells of each.
template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::reconstruct_end(
  const unsigned int direction,
  const unsigned int line,
  const bool high)
{
  const unsigned int face = 2 * direction + high;
  const Number share = std::max(Base::sensor_, Base::neighbor_sensor_[face]);
  if (!any_less(Number(0.), share))
    return;
  const Values further =
    Base::neighbor_primitive(face, layout_.face_point(face ^ 1U, line, 1));
  const unsigned int end = high ? n - 1 : 0;
  const double sign = high ? 1. : -1.;
  const double to_face = sign * Base::center_[0];
  Values here, there;
  for (unsigned int c = 0; c < nc; ++c)
  {
    const Number &own = line_[end][c];
    const Number &other = beyond_[high][c];
    const Number near = (other - own) * (sign * Base::inverse_distance_[0]);
    const Number far = (further[rotated_component<dim>(c, direction)] - other) *
                       (sign * Base::inverse_distance_[1]);
    const Number slope =
      high ? limited_slope(scheme_.limiter, near, far, Base::slope_weights_[0])
           : limited_slope(
               scheme_.limiter, far, near, Base::slope_weights_[n - 1]);
    here[c] = own + slope_[end][c] * to_face;
    there[c] = other - slope * to_face;
  }
  restore_if_inadmissible<dim>(gas_, line_[end], here);
  restore_if_inadmissible<dim>(gas_, beyond_[high], there);
  for (unsigned int c = 0; c < nc; ++c)
  {
    inside_[high][c] += share * (here[c] - inside_[high][c]);
    outside_[high][c] += share * (there[c] - outside_[high][c]);
  }
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::subcell_terms(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  std::array<Values, n + 1> flux;
  flux[0] = low_flux_;
  flux[n] = high_flux_;
  for (unsigned int f = 1; f < n; ++f)
  {
    const std::array<Values, 2> traces = Base::subcell_traces(f, line_, slope_);
    const auto a = to_face_state<dim>(gas_, traces[0]);
    const auto b = to_face_state<dim>(gas_, traces[1]);
    Number theta(1.);
    if (Base::needs_shear_factor())
      theta = Base::gated_shear_factor(
        blending_,
        std::max(a.sound_speed, b.sound_speed),
        line_[f][C::momentum] - line_[f - 1][C::momentum],
        std::min(compression(direction, first + (f - 1) * stride),
                 compression(direction, first + f * stride)));
    flux[f] = to_array<dim, Gas>(numerical_flux(scheme_.flux, a, b, theta));
    flux[f][C::momentum] -= reference_pressure_;
  }
  if (direction == 0 && !radial_.is_plane())
  {
    radial_subcell_terms(flux);
    return;
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
      line_residual_[i][c] +=
        blending_ * ((flux[i][c] - flux[i + 1][c]) * (1. / weight_[i]) -
                     line_residual_[i][c]);
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
