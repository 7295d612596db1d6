// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/finite_volume_kernel.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
FiniteVolumeKernel<dim, Gas, Real>::FiniteVolumeKernel(
  const OperatorContext<dim> &context,
  const Gas &gas,
  PrimitiveField<dim, Gas, Real> &primitives)
  : mesh_(context.mesh)
  , layout_(context.layout)
  , gas_(gas)
  , radial_(radial_exponent(context.mesh.coarse_mesh().geometry()), layout_.n)
  , sweep_(context, gas, primitives)
  , state_analysis_(context.mesh, context.layout, gas, sweep_.leaves())
{}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::update(
  const unsigned int batch,
  const BasicStage<Real> &stage,
  const HangingData<dim, Real> &hanging)
{
  sweep_.bind(batch, stage);
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(batch, direction, hanging);
  write(batch, stage);
  state_analysis_.conclude(batch, stage, is_open);
  // The sensor of the last stage serves a whole step.
  if (stage.results.signal_rate == nullptr)
    sweep_.leaves().sensor().store(stage.results.sensor +
                                   batch * n_lanes<Real>);
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::sweep(
  const unsigned int batch,
  const unsigned int direction,
  const HangingData<dim, Real> &hanging)
{
  if constexpr (dim < 3)
    if (direction == 0 && !radial_.is_plane())
    {
      radial_.reinit(mesh_.origins(batch)[0], mesh_.extents(batch)[0]);
      const RadialFaces<Number> faces{&radial_};
      sweep_.sweep(
        direction, hanging, [&](const unsigned int) { return faces; });
      return;
    }
  const BoxFaces<Number> faces{Number(layout_.n) /
                               mesh_.template extents<Real>(batch)[direction]};
  sweep_.sweep(direction, hanging, [&](const unsigned int) { return faces; });
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::write(const unsigned int batch,
                                               const BasicStage<Real> &stage)
{
  const std::size_t first = batch * layout_.batch_size();
  // One component after the other: those of a point lie a multiple of 2 kB
  // apart, in three states, and displace each other from the cache.
  for (unsigned int c = 0; c < Sweep::nc; ++c)
    for (unsigned int q = 0; q < layout_.n_points; ++q)
    {
      const std::size_t at = first + layout_.value(c, q);
      Number u;
      u.load(stage.in + at);
      u += sweep_.rate(c, q) * stage.step;
      if (stage.a != 0.)
      {
        // Written so that a state at rest keeps every bit.
        Number old;
        old.load(stage.start + at);
        u += (old - u) * stage.a;
      }
      u.store(stage.results.state + at);
    }
}


template <int dim, typename Gas, typename Real>
void FiniteVolumeKernel<dim, Gas, Real>::analyse(const unsigned int batch,
                                                 const BasicStage<Real> &stage)
{
  state_analysis_.analyse(batch, stage, is_open);
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class FiniteVolumeKernel<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
