// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/galerkin_kernel.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
template <int dim, int n, typename Gas, typename Real>
GalerkinKernel<dim, n, Gas, Real>::GalerkinKernel(const LeafMesh<dim> &mesh,
                                                  const LeafLayout &layout,
                                                  const Scheme &scheme,
                                                  const Gas &gas,
                                                  const Boundary<dim> &boundary)
  : Base(mesh, layout, scheme, gas, boundary, LobattoBasis(n).nodes())
  , radial_(radial_exponent(mesh.coarse_mesh().geometry()), n)
{
  Base::has_volumes_ = !radial_.is_plane();
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      weak_derivative_[i][j] =
        weight_[j] * Base::basis_.derivative()(j, i) / weight_[i];
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::update(
  const unsigned int batch,
  const BasicStage<Real> &stage,
  const HangingData<dim, Real> &hanging)
{
  Base::bind(batch, stage);
  Base::load(stage.in);
  Base::set_blending();
  if (!radial_.is_plane())
    bind_radial();
  for (unsigned int c = 0; c < nc; ++c)
    residual_[c].fill(Number(0.));
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction, hanging);
  Base::finish(stage);
  analyse(batch, stage);
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::analyse(const unsigned int batch,
                                                const BasicStage<Real> &stage)
{
  batch_ = batch;
  Base::load(stage.out);
  Base::blending_factor().store(stage.sensor_out + batch * Base::width);
  if (stage.signal_rate == nullptr)
    return;
  Number rate(0.);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values p;
    for (unsigned int c = 0; c < nc; ++c)
      p[c] = primitive_[c][q];
    rate = std::max(
      rate, signal_rate<dim>(gas_, p, mesh_.template extents<Real>(batch)));
  }
  rate.store(stage.signal_rate + batch * Base::width);
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::sweep(
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  const bool is_radial = direction == 0 && !radial_.is_plane();
  for (unsigned int line = 0; line < n_lines; ++line)
  {
    load_line(direction, line);
    end_fluxes(direction, line, hanging);
    if (is_radial)
      radial_volume_terms();
    else
      volume_terms();
    if (any_blending_ || (is_radial && radial_.any_near_axis()))
      subcell_terms(direction, line);
    add_line(direction, line);
  }
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::load_line(const unsigned int direction,
                                                  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
    {
      const unsigned int from = rotated_component<dim>(c, direction);
      line_[i][c] = primitive_[from][first + i * stride];
      line_conserved_[i][c] = conserved_[from][first + i * stride];
    }
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::end_fluxes(
  const unsigned int direction,
  const unsigned int line,
  const HangingData<dim, Real> &hanging)
{
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int face = 2 * direction + side;
    const Values p =
      Base::neighbor_primitive(face, layout_.face_point(face ^ 1U, line, 0));
    for (unsigned int c = 0; c < nc; ++c)
      beyond_[side][c] = p[rotated_component<dim>(c, direction)];
  }
  inside_ = {{line_[0], line_[n - 1]}};
  outside_ = beyond_;
  if (any_blending_ || radial_.any_near_axis())
  {
    find_slopes(direction);
    reconstruct_end(direction, line, false);
    reconstruct_end(direction, line, true);
  }
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->face / 2 == direction && s->kind == SpecialFace::Kind::boundary)
      fill_boundary_lane(*s, line);
  low_flux_ = end_flux(direction, line, false);
  high_flux_ = end_flux(direction, line, true);
  Base::replace_hanging_fluxes(direction, line, hanging, low_flux_, high_flux_);
  low_flux_[C::momentum] -= reference_pressure_;
  high_flux_[C::momentum] -= reference_pressure_;
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::fill_boundary_lane(
  const SpecialFace &special,
  const unsigned int line)
{
  const unsigned int side = special.face % 2;
  Values given = inside_[side];
  // Beyond an open end the gas is that of the leaf's other end: what comes in
  // with the state at the end itself would make a polynomial grow. A jump
  // that leaves is cut off at the end, not at a leaf's distance (with two
  // subcells not wholly, as in finite volumes).
  if (Base::boundary_.kind(special.index) == Boundary<dim>::Kind::open)
  {
    const Number share = Base::sensor_ * (n == 2 ? 0.7 : 1.);
    const Values &other = line_[side == 0 ? n - 1 : 0];
    for (unsigned int c = 0; c < nc; ++c)
      given[c] = other[c] + share * (given[c] - other[c]);
  }
  Base::fill_boundary(special, line, given, outside_[side]);
  for (unsigned int c = 0; c < nc; ++c)
    beyond_[side][c][special.lane] = outside_[side][c][special.lane];
}


template <int dim, int n, typename Gas, typename Real>
typename GalerkinKernel<dim, n, Gas, Real>::Values
GalerkinKernel<dim, n, Gas, Real>::end_flux(const unsigned int direction,
                                            const unsigned int line,
                                            const bool high)
{
  const auto here = to_face_state<dim>(gas_, inside_[high]);
  const auto there = to_face_state<dim>(gas_, outside_[high]);
  Number theta(1.);
  if (Base::needs_shear_factor())
  {
    const unsigned int face = 2 * direction + high;
    const unsigned int point = layout_.face_point(face, line, 0);
    const Number jump =
      (beyond_[high][C::momentum] - line_[high ? n - 1 : 0][C::momentum]) *
      (high ? 1. : -1.);
    theta = Base::gated_shear_factor(
      std::max(Base::sensor_, Base::neighbor_sensor_[face]),
      std::max(here.sound_speed, there.sound_speed),
      jump,
      std::min(compression(direction, point),
               Base::neighbor_compression(face, line)));
  }
  return to_array<dim, Gas>(
    high ? numerical_flux(scheme_.flux, here, there, theta)
         : numerical_flux(scheme_.flux, there, here, theta));
}


template <int dim, int n, typename Gas, typename Real>
typename GalerkinKernel<dim, n, Gas, Real>::Number
GalerkinKernel<dim, n, Gas, Real>::compression(const unsigned int direction,
                                               const unsigned int point) const
{
  return Base::transverse_compression(
    direction, point, [this](const unsigned int t, const unsigned int q) {
      return primitive_[C::momentum + t][q];
    });
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::volume_terms()
{
  Line flux;
  for (unsigned int i = 0; i < n; ++i)
  {
    const Values &p = line_[i];
    for (unsigned int c = 0; c < nc; ++c)
      flux[i][c] = line_conserved_[i][c] * p[C::momentum];
    flux[i][C::momentum] += p[C::energy] - reference_pressure_;
    flux[i][C::energy] += p[C::energy] * p[C::momentum];
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number sum = flux[0][c] * weak_derivative_[i][0];
      for (unsigned int j = 1; j < n; ++j)
        sum += flux[j][c] * weak_derivative_[i][j];
      line_residual_[i][c] = sum;
    }
  for (unsigned int c = 0; c < nc; ++c)
  {
    line_residual_[0][c] += low_flux_[c] * (1. / weight_[0]);
    line_residual_[n - 1][c] -= high_flux_[c] * (1. / weight_[n - 1]);
  }
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::add_line(const unsigned int direction,
                                                 const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  const Number inverse =
    Number(1.) / mesh_.template extents<Real>(batch_)[direction];
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
      residual_[rotated_component<dim>(c, direction)][first + i * stride] +=
        line_residual_[i][c] * inverse;
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
