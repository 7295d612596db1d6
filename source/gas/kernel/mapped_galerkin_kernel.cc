// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/kernel/mapped_galerkin_kernel.h>
#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>

namespace contrecoup::gas
{
template <int dim, int n, typename Gas>
MappedGalerkinKernel<dim, n, Gas>::MappedGalerkinKernel(
  const LeafMesh<dim> &mesh,
  const LeafLayout &layout,
  const Scheme &scheme,
  const Gas &gas,
  const Boundary<dim> &boundary)
  : Base(mesh, layout, scheme, gas, boundary, metric_)
  , metric_(n)
{
  Base::has_volumes_ = true;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      stiffness_[i][j] =
        Base::basis_.weights()[j] * Base::basis_.derivative()(j, i);
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::update(const unsigned int batch,
                                               const Stage &stage,
                                               const HangingData<dim> &)
{
  Base::bind(batch, stage);
  bind_metric(batch);
  Base::load(stage.in);
  Base::fill_ghosts(primitive_[0].data());
  // At open ends finite volumes: an extrapolated polynomial would grow.
  Number open(0.);
  for (unsigned int d = 0; d < dim; ++d)
    open = std::max(open, Base::open_[d]);
  Base::set_blending(open);
  for (unsigned int c = 0; c < nc; ++c)
    residual_[c].fill(Number(0.));
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    const Number inverse = Number(1.) / metric_.volume(q);
    for (unsigned int c = 0; c < nc; ++c)
      residual_[c][q] *= inverse;
  }
  Base::finish(stage);
  Base::load(stage.out);
  store_sensors(stage);
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::analyse(const unsigned int batch,
                                                const Stage &stage)
{
  batch_ = batch;
  bind_metric(batch);
  Base::load(stage.out);
  store_sensors(stage);
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::bind_metric(const unsigned int batch)
{
  metric_.reinit(mesh_, batch);
  for (unsigned int q = 0; q < n_points; ++q)
    Base::volume_[q] = metric_.volume(q);
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::sweep(const unsigned int direction)
{
  const unsigned int stride = layout_.stride(direction);
  for (unsigned int line = 0; line < n_lines; ++line)
  {
    load_line(direction, line);
    end_fluxes(direction, line);
    volume_terms(direction, line);
    if (any_blending_)
      subcell_terms(direction, line);
    const unsigned int first = layout_.face_point(2 * direction, line, 0);
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int c = 0; c < nc; ++c)
        residual_[c][first + i * stride] += line_residual_[i][c];
  }
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::load_line(const unsigned int direction,
                                                  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
      line_[i][c] = primitive_[c][first + i * stride];
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::end_fluxes(const unsigned int direction,
                                                   const unsigned int line)
{
  const std::array<Values, 2> low = {
    {Base::ghost(2 * direction, line, 0), line_[0]}};
  const std::array<Values, 2> high = {
    {line_[n - 1], Base::ghost(2 * direction + 1, line, 0)}};
  low_flux_ = flux_through(direction, 0, line, low, low);
  high_flux_ = flux_through(direction, n, line, high, high);
}


template <int dim, int n, typename Gas>
typename MappedGalerkinKernel<dim, n, Gas>::Values
MappedGalerkinKernel<dim, n, Gas>::flux_through(
  const unsigned int direction,
  const unsigned int layer,
  const unsigned int line,
  const std::array<Values, 2> &traces,
  const std::array<Values, 2> &points) const
{
  const FaceFrame<dim, Number> frame(metric_.area(direction, layer, line));
  Values flux =
    Base::face_flux(direction, layer, line, frame, traces, points, blending_);
  flux[C::momentum] -= reference_pressure_;
  Values result;
  for (unsigned int c = 0; c < nc; ++c)
    result[c] = flux[c] * frame.area;
  for (unsigned int d = 0; d < dim; ++d)
  {
    Number stress = flux[C::momentum] * frame.axes[0][d];
    for (unsigned int e = 1; e < dim; ++e)
      stress += flux[C::momentum + e] * frame.axes[e][d];
    result[C::momentum + d] = stress * frame.area;
  }
  return result;
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::volume_terms(
  const unsigned int direction,
  const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction);
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  Line flux;
  for (unsigned int i = 0; i < n; ++i)
  {
    const Values &p = line_[i];
    const auto &normal = metric_.normal(direction, first + i * stride);
    Number through = p[C::momentum] * normal[0];
    for (unsigned int d = 1; d < dim; ++d)
      through += p[C::momentum + d] * normal[d];
    for (unsigned int c = 0; c < nc; ++c)
      flux[i][c] = conserved_[c][first + i * stride] * through;
    const Number pressure = p[C::energy] - reference_pressure_;
    for (unsigned int d = 0; d < dim; ++d)
      flux[i][C::momentum + d] += pressure * normal[d];
    flux[i][C::energy] += p[C::energy] * through;
  }
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number sum = flux[0][c] * stiffness_[i][0];
      for (unsigned int j = 1; j < n; ++j)
        sum += flux[j][c] * stiffness_[i][j];
      line_residual_[i][c] = sum;
    }
  for (unsigned int c = 0; c < nc; ++c)
  {
    line_residual_[0][c] += low_flux_[c];
    line_residual_[n - 1][c] -= high_flux_[c];
  }
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::subcell_terms(
  const unsigned int direction,
  const unsigned int line)
{
  std::array<Values, 2> beyond = {{Base::ghost(2 * direction, line, 1),
                                   Base::ghost(2 * direction + 1, line, 1)}};
  // Beyond boundaries other than walls there is nothing to take slopes from.
  for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
       ++s)
    if (s->face / 2 == direction && !Base::is_wall(*s))
      for (unsigned int c = 0; c < nc; ++c)
        beyond[s->face % 2][c][s->lane] =
          line_[s->face % 2 ? n - 1 : 0][c][s->lane];
  const Line slope = Base::subcell_slopes(line_, beyond);
  std::array<Values, n + 1> flux;
  flux[0] = low_flux_;
  flux[n] = high_flux_;
  for (unsigned int f = 1; f < n; ++f)
    flux[f] = flux_through(direction,
                           f,
                           line,
                           Base::subcell_traces(f, line_, slope),
                           {{line_[f - 1], line_[f]}});
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int c = 0; c < nc; ++c)
      line_residual_[i][c] +=
        blending_ * (flux[i][c] - flux[i + 1][c] - line_residual_[i][c]);
}


template <int dim, int n, typename Gas>
void MappedGalerkinKernel<dim, n, Gas>::store_sensors(const Stage &stage)
{
  Base::blending_factor().store(stage.sensor_out + batch_ * double_width);
  if (stage.signal_rate != nullptr)
    largest_signal_rate().store(stage.signal_rate + batch_ * double_width);
}


// The contravariant velocities and sound speeds, sum_d (|u_d| + c) / h_d of
// a box.
template <int dim, int n, typename Gas>
typename MappedGalerkinKernel<dim, n, Gas>::Number
MappedGalerkinKernel<dim, n, Gas>::largest_signal_rate() const
{
  Number largest(0.);
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Number products(0.);
    if constexpr (Gas::has_products)
      products = primitive_[C::products][q];
    const Number sound_speed = std::sqrt(
      std::max(gas_.sound_speed_squared(
                 primitive_[C::density][q], primitive_[C::energy][q], products),
               Number(0.)));
    Number sum(0.);
    for (unsigned int d = 0; d < dim; ++d)
    {
      const auto &normal = metric_.normal(d, q);
      Number speed(0.);
      for (unsigned int e = 0; e < dim; ++e)
        speed += primitive_[C::momentum + e][q] * normal[e];
      sum += (std::abs(speed) + sound_speed * std::sqrt(normal * normal)) *
             Base::basis_.weights()[(q / layout_.stride(d)) % n];
    }
    largest = std::max(largest, Number(sum / metric_.volume(q)));
  }
  return largest;
}


template class MappedGalerkinKernel<2, 2, IdealGas>;
template class MappedGalerkinKernel<2, 3, IdealGas>;
template class MappedGalerkinKernel<2, 4, IdealGas>;
template class MappedGalerkinKernel<3, 2, IdealGas>;
template class MappedGalerkinKernel<3, 3, IdealGas>;
template class MappedGalerkinKernel<3, 4, IdealGas>;
template class MappedGalerkinKernel<2, 2, MieGrueneisen>;
template class MappedGalerkinKernel<2, 3, MieGrueneisen>;
template class MappedGalerkinKernel<2, 4, MieGrueneisen>;
template class MappedGalerkinKernel<3, 2, MieGrueneisen>;
template class MappedGalerkinKernel<3, 3, MieGrueneisen>;
template class MappedGalerkinKernel<3, 4, MieGrueneisen>;
} // namespace contrecoup::gas
