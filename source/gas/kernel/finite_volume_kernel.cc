// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/finite_volume_kernel.h>
#include <contrecoup/gas/kernel/products_slope.h>
#include <contrecoup/gas/kernel/velocity_slope.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
namespace
{
  std::vector<double> subcell_centers(const unsigned int n)
  {
    std::vector<double> centers(n);
    for (unsigned int i = 0; i < n; ++i)
      centers[i] = (i + 0.5) / n;
    return centers;
  }
} // namespace


template <int dim, typename Gas, typename Real>
FiniteVolumeKernel<dim, Gas, Real>::FiniteVolumeKernel(
  const LeafMesh<dim> &mesh,
  const LeafLayout &layout,
  const Scheme &scheme,
  const Gas &gas,
  const Boundary<dim> &boundary)
  : Base(mesh, layout, scheme, gas, boundary, subcell_centers(layout.n))
  , radial_(radial_exponent(mesh.coarse_mesh().geometry()), layout.n)
  , primitive_(nc * layout.n_points)
  , residual_(nc * layout.n_points)
  , line_(layout.n + 2 * ghosts)
  , left_(layout.n + 1)
  , right_(layout.n + 1)
  , flux_(layout.n + 1)
  , compression_(layout.n + 2)
  , touch_(layout.n + 3)
{}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::update(
  const unsigned int batch,
  const BasicStage<Real> &stage,
  const HangingData<dim, Real> &hanging)
{
  Base::bind(batch, stage);
  load(stage.in);
  residual_.fill(Number(0.));
  bind_radii();
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction, hanging);
  finish(stage);
  // The sensor of the last stage serves a whole step.
  if (stage.signal_rate != nullptr)
    analyse(batch, stage);
  else
    Base::sensor_.store(stage.sensor_out + batch * Base::width);
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::load(const Real *state)
{
  const Real *values = state + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c].load(values + layout_.value(c, q));
    const Values p = to_primitive<dim>(gas_, u);
    for (unsigned int c = 0; c < nc; ++c)
      primitive_[c * layout_.n_points + q] = p[c];
  }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::sweep(
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    fill_line(direction, line);
    fill_line_ends(direction, line, hanging);
    if (Base::burn_ != nullptr)
      Base::fill_progress(direction, line);
    if (Base::needs_shear_factor())
      fill_compression(direction, line);
    reconstruct<false>();
    line_fluxes(direction);
    Base::replace_hanging_fluxes(
      direction, line, hanging, flux_[0], flux_[layout_.n]);
    add_flux_differences(direction, line);
  }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::fill_line(const unsigned int direction,
                                                   const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int c = 0; c < nc; ++c)
  {
    const Number *values =
      &primitive_[rotated_component<dim>(c, direction) * layout_.n_points +
                  first];
    for (unsigned int i = 0; i < layout_.n; ++i)
      cell(i)[c] = values[i * stride];
  }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::fill_line_ends(
  const unsigned int direction,
  const unsigned int line,
  const HangingData<dim, Real> &hanging)
{
  const int n = layout_.n;
  const unsigned int depth = std::min(1U, layout_.n - 1);
  for (unsigned int side = 0; side < 2; ++side)
  {
    const unsigned int face = 2 * direction + side;
    const int near = side == 0 ? -1 : n;
    const int far = side == 0 ? -2 : n + 1;
    const Values p =
      Base::neighbor_primitive(face, layout_.face_point(face ^ 1U, line, 0));
    const Values q = Base::neighbor_primitive(
      face, layout_.face_point(face ^ 1U, line, depth));
    for (unsigned int c = 0; c < nc; ++c)
    {
      const unsigned int from = rotated_component<dim>(c, direction);
      cell(near)[c] = p[from];
      cell(far)[c] = q[from];
    }
  }
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->face / 2 == direction)
      fill_ghost_lane(*s, line, hanging);
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::fill_ghost_lane(
  const SpecialFace &special,
  const unsigned int line,
  const HangingData<dim, Real> &hanging)
{
  const int n = layout_.n;
  const bool high = special.face % 2;
  if (special.kind == SpecialFace::Kind::boundary)
  {
    // A wall mirrors layer by layer; other boundaries repeat the first.
    const bool is_wall =
      Base::boundary_.kind(special.index) == Boundary<dim>::Kind::wall;
    for (int layer = 0; layer < ghosts; ++layer)
    {
      const int depth = is_wall ? std::min(layer, n - 1) : 0;
      Values inside = cell(high ? n - 1 - depth : depth);
      // A fifth of the next subcell: then hardly anything of a shock that
      // leaves comes back (found by trials at Mach 1.1 to 1.9).
      if (Base::leaving_[special.face / 2][special.lane] > 0. && n > 1)
        for (unsigned int c = 0; c < nc; ++c)
          inside[c] += (cell(high ? n - 2 : 1)[c] - inside[c]) * 0.2;
      Base::fill_boundary(
        special, line, inside, cell(high ? n + layer : -1 - layer));
    }
    return;
  }
  for (unsigned int c = 0; c < nc; ++c)
  {
    const double value =
      hanging.halo(special.index,
                   Base::slot_of(special),
                   rotated_component<dim>(c, special.face / 2))[line];
    cell(high ? n : -1)[c][special.lane] = value;
    cell(high ? n + 1 : -2)[c][special.lane] = value;
  }
}


template <int dim, typename Gas, typename Real>
template <bool masked>
void FiniteVolumeKernel<dim, Gas, Real>::reconstruct()
{
  const int n = layout_.n;
  if (!scheme_.linear)
  {
    for (int f = 0; f <= n; ++f)
    {
      left_[f] = cell(f - 1);
      right_[f] = cell(f);
    }
    return;
  }
  for (int i = -1; i <= n; ++i)
  {
    Values half, low, high;
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number backward = cell(i)[c] - cell(i - 1)[c];
      Number forward = cell(i + 1)[c] - cell(i)[c];
      if (masked)
      {
        backward *= touch(i);
        forward *= touch(i + 1);
      }
      half[c] = limited_slope(scheme_.limiter, backward, forward) * 0.5;
    }
    if (Base::careful_)
      limit_velocity_slope<dim>(gas_, cell(i), half);
    for (unsigned int c = 0; c < nc; ++c)
    {
      low[c] = cell(i)[c] - half[c];
      high[c] = cell(i)[c] + half[c];
    }
    if constexpr (Gas::has_products)
    {
      bound_products<dim, Gas>(cell(i), half, low, high);
      restore_if_inadmissible<dim>(gas_, cell(i), low);
      restore_if_inadmissible<dim>(gas_, cell(i), high);
    }
    if (i >= 0)
      right_[i] = low;
    if (i < n)
      left_[i + 1] = high;
  }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::line_fluxes(
  const unsigned int direction)
{
  for (unsigned int f = 0; f <= layout_.n; ++f)
  {
    auto left = to_face_state<dim>(gas_, left_[f]);
    auto right = to_face_state<dim>(gas_, right_[f]);
    if (Base::burn_ != nullptr)
      Base::hold_back(f, left, right);
    Number theta = 1.;
    if (Base::needs_shear_factor())
    {
      Number shock = Base::sensor_;
      if (f == 0)
        shock = std::max(shock, Base::neighbor_sensor_[2 * direction]);
      else if (f == layout_.n)
        shock = std::max(shock, Base::neighbor_sensor_[2 * direction + 1]);
      theta = Base::gated_shear_factor(
        shock,
        std::max(left.sound_speed, right.sound_speed),
        cell(f)[C::momentum] - cell(f - 1)[C::momentum],
        std::min(compression_[f], compression_[f + 1]));
    }
    flux_[f] =
      to_array<dim, Gas>(numerical_flux(scheme_.flux, left, right, theta));
    // Faces to other leaves keep the flux that the neighbour computes too.
    if (Base::any_leaving(direction) && f > 0 && f < layout_.n &&
        Base::burn_ == nullptr)
      Base::widen_open_flux(direction, cell(f - 1), cell(f), flux_[f]);
  }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::add_flux_differences(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  const bool radial = dim < 3 && direction == 0 && !radial_.is_plane();
  const Number inverse_size =
    Number(layout_.n) / mesh_.template extents<Real>(batch_)[direction];
  for (unsigned int i = 0; i < layout_.n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number &residual =
        residual_[rotated_component<dim>(c, direction) * layout_.n_points +
                  first + i * stride];
      if (!radial)
      {
        residual += (flux_[i][c] - flux_[i + 1][c]) * inverse_size;
        continue;
      }
      if constexpr (dim < 3)
      {
        // The pressure of the cell itself exerts no net force on it.
        const Number base =
          c == C::momentum ? Base::exerted_pressure(i, cell(i)) : Number(0.);
        residual += ((flux_[i][c] - base) * radial_.area(i) -
                     (flux_[i + 1][c] - base) * radial_.area(i + 1)) *
                    radial_.inverse_volume(i);
      }
    }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::finish(const BasicStage<Real> &stage)
{
  const Real *in = stage.in + batch_ * layout_.batch_size();
  const Real *start = stage.start + batch_ * layout_.batch_size();
  Real *out = stage.out + batch_ * layout_.batch_size();
  Number smallest(1.);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
    {
      u[c].load(in + layout_.value(c, q));
      u[c] += residual_[c * layout_.n_points + q] * stage.step;
      if (stage.a != 0.)
      {
        // Written so that a state at rest keeps every bit.
        Number old;
        old.load(start + layout_.value(c, q));
        u[c] += (old - u[c]) * stage.a;
      }
      u[c].store(out + layout_.value(c, q));
    }
    smallest = std::min(smallest, is_admissible<dim>(gas_, u));
  }
  report(smallest, stage);
  fill_padding(out);
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::report(
  const Number &smallest,
  const BasicStage<Real> &stage) const
{
  for (unsigned int lane = 0; lane < mesh_.n_filled_lanes(batch_); ++lane)
    if (!(smallest[lane] > 0.))
      *stage.unphysical_leaf = batch_ * Base::width + lane;
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::fill_padding(Real *out) const
{
  for (unsigned int lane = mesh_.n_filled_lanes(batch_); lane < Base::width;
       ++lane)
    for (std::size_t i = 0; i < layout_.batch_size(); i += Base::width)
      out[i + lane] = out[i];
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::fill_compression(
  const unsigned int direction,
  const unsigned int line)
{
  const auto velocity = [this](const unsigned int t, const unsigned int q) {
    return primitive_[(C::momentum + t) * layout_.n_points + q];
  };
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int i = 0; i < layout_.n; ++i)
    compression_[i + 1] =
      Base::transverse_compression(direction, first + i * stride, velocity);
  compression_[0] = Base::neighbor_compression(2 * direction, line);
  compression_[layout_.n + 1] =
    Base::neighbor_compression(2 * direction + 1, line);
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::analyse(const unsigned int batch,
                                                 const BasicStage<Real> &stage)
{
  Base::bind_burn(batch, stage);
  load(stage.out);
  const Number rate = largest_rate(stage);
  const auto everywhere = [](unsigned int, unsigned int) { return Number(1.); };
  store_sensors(rate, largest_jump(everywhere), stage);
}


template <int dim, typename Gas, typename Real>
typename FiniteVolumeKernel<dim, Gas, Real>::Number
FiniteVolumeKernel<dim, Gas, Real>::largest_rate(const BasicStage<Real> &stage)
{
  Number rate(0.);
  for (unsigned int q = 0; q < layout_.n_points; ++q)
  {
    Values p;
    for (unsigned int c = 0; c < nc; ++c)
      p[c] = primitive_[c * layout_.n_points + q];
    Number least_speed(0.);
    if (Base::burn_ != nullptr)
    {
      const Number burned =
        Base::burn_->fraction(Base::progress(q, stage.end_time), p[C::density]);
      least_speed = (Number(1.) - burned) * Base::burn_->speed;
      primitive_[C::energy * layout_.n_points + q] =
        Base::burn_->pressure(p[C::energy], burned);
    }
    rate =
      std::max(rate,
               signal_rate<dim>(
                 gas_, p, mesh_.template extents<Real>(batch_), least_speed));
  }
  return rate;
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::store_sensors(
  const Number &rate,
  const Number &jump,
  const BasicStage<Real> &stage) const
{
  const Number shock = select_less(Number(0.), jump, Number(1.), Number(0.));
  rate.store(stage.signal_rate + batch_ * Base::width);
  shock.store(stage.sensor_out + batch_ * Base::width);
}


#define CONTRECOUP_INSTANTIATE(...)               \
  template class FiniteVolumeKernel<__VA_ARGS__>; \
  template void FiniteVolumeKernel<__VA_ARGS__>::reconstruct<true>()

CONTRECOUP_INSTANTIATE(1, IdealGas);
CONTRECOUP_INSTANTIATE(2, IdealGas);
CONTRECOUP_INSTANTIATE(3, IdealGas);
CONTRECOUP_INSTANTIATE(3, IdealGas, float);
CONTRECOUP_INSTANTIATE(1, MieGrueneisen);
CONTRECOUP_INSTANTIATE(2, MieGrueneisen);
CONTRECOUP_INSTANTIATE(3, MieGrueneisen);
CONTRECOUP_INSTANTIATE(3, MieGrueneisen, float);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
