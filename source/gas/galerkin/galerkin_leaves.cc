// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/galerkin/galerkin_leaves.h>
#include <contrecoup/gas/galerkin/scaling_to_mean.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
namespace EvaluationFlags = dealii::EvaluationFlags;


template <int dim, typename Gas, typename Real>
GalerkinLeaves<dim, Gas, Real>::GalerkinLeaves(
  const Space &space,
  const Faces &faces,
  const OperatorContext<dim> &context,
  const Gas &gas)
  : mesh_(context.mesh)
  , space_(space)
  , faces_(faces)
  , layout_(context.layout)
  , scheme_(context.scheme)
  , gas_(gas)
  , boundary_(context.boundary)
  , subcells_(layout_.n)
  , indicator_(layout_.n, context.scheme.indicator_threshold)
  , radial_(space.radial_exponent(), layout_.n)
  , n_points_(layout_.n_points)
  , conserved_(nc * n_points_)
  , primitive_(nc * n_points_)
  , rate_(nc * n_points_)
  , subcell_rate_(nc * n_points_)
  , volume_(n_points_)
  , outflow_(2 * dim * nc * layout_.n_face_points)
  , signal_(n_points_)
  , line_(layout_.n + 2)
  , slope_(layout_.n + 2)
  , flux_(layout_.n + 1)
{
  for (auto &area : area_)
    area.resize(dim * n_points_);
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::reinit()
{
  phi_ = Evaluation::make(space_.matrix_free(), layout_.n - 1);
  metric_ = NodalEvaluation<dim, dim, Real, false>::make(space_.matrix_free(),
                                                         layout_.n - 1);
  if (space_.is_collocated())
    return;
  volumes_.resize(space_.cells().size() * n_points_);
  dealii::FEEvaluation<dim, -1, 0, 1, Real, Number> one(space_.matrix_free());
  for (unsigned int b = 0; b < space_.cells().size(); ++b)
  {
    one.reinit(b);
    for (unsigned int q = 0; q < one.n_q_points; ++q)
      one.submit_value(Number(1.), q);
    one.integrate(EvaluationFlags::values);
    std::copy_n(one.begin_dof_values(), n_points_, &volumes_[b * n_points_]);
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::update(
  const unsigned int cell_batch,
  const BasicStage<Real> &stage,
  const QuietLeaves<dim> &quiet_leaves)
{
  bind(cell_batch);
  load(stage.in);
  set_volumes();
  set_blending(stage.sensor);
  volume_terms();
  add_face_fluxes();
  divide_by_mass();
  if (needs_subcells())
    add_subcell_terms(stage.in);
  if (!radial_.is_plane())
    add_radial_pressure();
  advance(stage);
  store(stage, quiet_leaves);
  store_sensors(stage, &quiet_leaves);
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::analyse(const unsigned int cell_batch,
                                             const BasicStage<Real> &stage)
{
  bind(cell_batch);
  load(stage.results.state);
  store_sensors(stage, nullptr);
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::bind(const unsigned int cell_batch)
{
  index_ = cell_batch;
  batch_ = &space_.cells()[cell_batch];
  phi_->reinit(cell_batch);
  reader_.reinit(batch_->leaf.data(), layout_);
  if (space_.is_collocated())
  {
    const auto inverse = phi_->access().inverse_jacobian(0);
    for (unsigned int d = 0; d < dim; ++d)
    {
      extents_[d] = Number(1.) / inverse[d][d];
      to_area_[2 * d + 1] = inverse[d][d] * (1. / subcells_.weight[0]);
      to_area_[2 * d] = -to_area_[2 * d + 1];
    }
    if (!radial_.is_plane())
      radial_.reinit(phi_->access().quadrature_point(0)[0], extents_[0]);
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::load(const Real *state)
{
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
    {
      u[c] = reader_.read(state + layout_.value(c, q));
      conserved_[c * n_points_ + q] = u[c];
    }
    const Values p = to_primitive<dim>(gas_, u);
    for (unsigned int c = 0; c < nc; ++c)
      primitive_[c * n_points_ + q] = p[c];
  }
  // Only differences of the pressure act inside a leaf; measured from one
  // of its nodes they vanish exactly in gas at rest.
  reference_pressure_ = primitive_[C::pressure * n_points_];
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::set_volumes()
{
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    volume_[q] = space_.is_collocated() ? phi_->access().JxW(q)
                                        : volumes_[index_ * n_points_ + q];
    if (!radial_.is_plane())
      volume_[q] *= radial_.jacobian(q % layout_.n);
  }
}


template <int dim, typename Gas, typename Real>
unsigned int
GalerkinLeaves<dim, Gas, Real>::neighbor(const unsigned int face,
                                         const unsigned int lane) const
{
  const unsigned int leaf = batch_->leaf[lane];
  return mesh_.neighbors(leaf / width, face)[leaf % width];
}


// Half of a neighbour's blending spreads, so that a shock that enters a leaf
// finds it prepared (Hennemann et al. 2021, eq. 48). Leaves of other shapes are
// finite volumes at open ends, where a polynomial would grow.
template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::set_blending(const Real *sensors)
{
  for (unsigned int lane = 0; lane < width; ++lane)
  {
    Real beside = 0.;
    for (unsigned int face = 0; face < 2 * dim; ++face)
      beside = std::max(beside, sensors[neighbor(face, lane)]);
    blending_[lane] = std::max(sensors[batch_->leaf[lane]], Real(0.5) * beside);
    if (!space_.is_collocated() && is_open(batch_->leaf[lane]))
      blending_[lane] = 1.;
  }
  any_blending_ = scheme_.blending && any_less(Number(0.), blending_);
}


template <int dim, typename Gas, typename Real>
bool GalerkinLeaves<dim, Gas, Real>::is_open(const unsigned int leaf) const
{
  const unsigned int batch = leaf / width;
  return std::any_of(mesh_.special_begin(batch),
                     mesh_.special_end(batch),
                     [&](const SpecialFace &special) {
                       return special.lane == leaf % width &&
                              is_boundary(special, Boundary<dim>::Kind::open);
                     });
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::volume_terms()
{
  if (space_.is_collocated())
    for (unsigned int q = 0; q < n_points_; ++q)
      submit_flux(q, node(conserved_, q), node(primitive_, q));
  else
    evaluate_state();
  phi_->integrate(EvaluationFlags::gradients);
}


// Interpolates differences, so that equal values stay what they are; a state
// that is not admissible is replaced by the nearest node's.
template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::evaluate_state()
{
  const Values base = node(conserved_, 0);
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points_; ++q)
      phi_->access().begin_dof_values()[c * n_points_ + q] =
        conserved_[c * n_points_ + q] - base[c];
  phi_->evaluate(EvaluationFlags::values);
  const Number one(1.);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const auto difference = phi_->access().get_value(q);
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = base[c] + difference[c];
    const Number good = is_admissible<dim>(gas_, u);
    if (any_less(good, one))
      for (unsigned int c = 0; c < nc; ++c)
        u[c] = select_less(good, one, conserved_[c * n_points_ + q], u[c]);
    submit_flux(q, u, to_primitive<dim>(gas_, u));
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::submit_flux(const unsigned int q,
                                                 const Values &u,
                                                 const Values &p)
{
  dealii::Tensor<1, nc, Vector> flux;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const Number &velocity = p[C::velocity + d];
    for (unsigned int c = 0; c < nc; ++c)
      flux[c][d] = u[c] * velocity;
    flux[C::momentum + d][d] += p[C::pressure] - reference_pressure_;
    flux[C::energy][d] += p[C::pressure] * velocity;
  }
  if (!radial_.is_plane())
    for (unsigned int c = 0; c < nc; ++c)
    {
      flux[c][0] *= radial_.collocated_power(q % layout_.n);
      for (unsigned int d = 1; d < dim; ++d)
        flux[c][d] *= radial_.jacobian(q % layout_.n);
    }
  phi_->access().submit_gradient(flux, q);
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::add_face_fluxes()
{
  const LeafLayout &records = space_.record_layout();
  const unsigned int n_values = nc * records.n_points;
  for (unsigned int face = 0; face < 2 * dim; ++face)
  {
    Number *const outflow = &outflow_[needs_subcells() ? face * n_values : 0];
    NeighborReader<Real> reader;
    reader.reinit(batch_->record[face].data(), records);
    for (unsigned int i = 0; i < n_values; ++i)
      outflow[i] = reader.read(faces_.fluxes() + i * width);
    for (const auto &neighbor : batch_->finer_neighbors)
      if (neighbor.face == face)
      {
        const Real *from = faces_.fluxes() + records.offset(neighbor.record);
        for (unsigned int i = 0; i < n_values; ++i)
          outflow[i][neighbor.lane] += from[i * width];
      }
    for (unsigned int q = 0; q < records.n_points; ++q)
    {
      const unsigned int point = layout_.face_point(face, q, 0);
      if (space_.is_collocated())
      {
        const Number area =
          face < 2 && !radial_.is_plane()
            ? Number(radial_area(q, face * layout_.n) * (face == 0 ? -1. : 1.))
            : Number(volume_[point] * to_area_[face]);
        outflow[(C::momentum + face / 2) * records.n_points + q] -=
          reference_pressure_;
        for (unsigned int c = 0; c < nc; ++c)
          outflow[c * records.n_points + q] *= area;
      }
      for (unsigned int c = 0; c < nc; ++c)
        phi_->access().begin_dof_values()[c * n_points_ + point] -=
          face < 2 && radial_.any_near_axis()
            ? Number(outflow[c * records.n_points + q] * radial_.collocated())
            : outflow[c * records.n_points + q];
    }
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::divide_by_mass()
{
  if (!space_.is_collocated())
  {
    phi_->apply_inverse_mass(rate_.data());
    return;
  }
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Number inverse = Number(1.) / volume_[q];
    for (unsigned int c = 0; c < nc; ++c)
      rate_[c * n_points_ + q] =
        phi_->access().begin_dof_values()[c * n_points_ + q] * inverse;
  }
}


template <int dim, typename Gas, typename Real>
typename GalerkinLeaves<dim, Gas, Real>::Number
GalerkinLeaves<dim, Gas, Real>::radial_area(const unsigned int line,
                                            const unsigned int f) const
{
  const Number width_of_first = extents_[0] * subcells_.weight[0];
  return phi_->access().JxW(layout_.face_point(0, line, 0)) / width_of_first *
         radial_.area(f);
}


// Pressure on the growth of area around a node: without it, uniform pressure
// would push outwards.
template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::add_radial_pressure()
{
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
    for (unsigned int i = 0; i < layout_.n; ++i)
    {
      const unsigned int q = layout_.face_point(0, line, i);
      rate_[C::momentum * n_points_ + q] +=
        (primitive_[C::pressure * n_points_ + q] - reference_pressure_) *
        (radial_area(line, i + 1) - radial_area(line, i)) / volume_[q];
    }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::advance(const BasicStage<Real> &stage)
{
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points_; ++q)
    {
      Number &u = conserved_[c * n_points_ + q];
      u += rate_[c * n_points_ + q] * stage.step;
      // Written so that a state at rest keeps every bit.
      if (stage.a != 0.)
        u += (reader_.read(stage.start + layout_.value(c, q)) - u) * stage.a;
    }
  ScalingToMean<dim, Gas, Number> scaling(gas_, conserved_, volume_);
  const Number good = scaling.restore_positivity(scheme_.positivity);
  if (any_less(good, Number(1.)))
    for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
      if (good[lane] < 1.)
        *stage.results.unphysical_leaf = batch_->leaf[lane];
  if constexpr (Gas::has_products)
    scaling.bound_products();
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::store(
  const BasicStage<Real> &stage,
  const QuietLeaves<dim> &quiet_leaves) const
{
  if (batch_->is_leaf_batch)
  {
    Real *to = stage.results.state + layout_.offset(batch_->leaf[0]);
    for (unsigned int i = 0; i < nc * n_points_; ++i)
      conserved_[i].store(to + i * width);
    return;
  }
  for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
    if (quiet_leaves.is_active(batch_->leaf[lane] / width))
    {
      Real *to = stage.results.state + layout_.offset(batch_->leaf[lane]);
      for (unsigned int i = 0; i < nc * n_points_; ++i)
        to[i * width] = conserved_[i][lane];
    }
}


template <int dim, typename Gas, typename Real>
void GalerkinLeaves<dim, Gas, Real>::store_sensors(
  const BasicStage<Real> &stage,
  const QuietLeaves<dim> *quiet_leaves)
{
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Values p = to_primitive<dim>(gas_, node(conserved_, q));
    for (unsigned int c = 0; c < nc; ++c)
      primitive_[c * n_points_ + q] = p[c];
    signal_[q] = p[C::density] * p[C::pressure];
  }
  // In single precision the squares of density times pressure may overflow.
  Number largest(std::numeric_limits<float>::min());
  for (const Number &value : signal_)
    largest = std::max(largest, std::abs(value));
  const Number scale = Number(1.) / largest;
  for (Number &value : signal_)
    value *= scale;
  Number sensor(0.), rate(0.);
  if (scheme_.blending)
    sensor = indicator_.blending_factor(signal_);
  if (stage.results.signal_rate != nullptr)
    rate = largest_signal_rate();
  for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
  {
    const unsigned int leaf = batch_->leaf[lane];
    if (quiet_leaves != nullptr && !quiet_leaves->is_active(leaf / width))
      continue;
    stage.results.sensor[leaf] = sensor[lane];
    if (stage.results.signal_rate != nullptr)
      stage.results.signal_rate[leaf] = rate[lane];
  }
}


// The contravariant velocities and sound speeds, sum_d (|u_d| + c) / h_d of
// a box.
template <int dim, typename Gas, typename Real>
typename GalerkinLeaves<dim, Gas, Real>::Number
GalerkinLeaves<dim, Gas, Real>::largest_signal_rate() const
{
  Number largest(0.);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Values p = node(primitive_, q);
    if (space_.is_collocated())
    {
      largest = std::max(largest, signal_rate<dim>(gas_, p, extents_));
      continue;
    }
    Number products(0.);
    if constexpr (Gas::has_products)
      products = p[C::products];
    const Number sound_speed = std::sqrt(std::max(
      gas_.sound_speed_squared(p[C::density], p[C::pressure], products),
      Number(0.)));
    const auto inverse = phi_->access().inverse_jacobian(q);
    Number sum(0.);
    for (unsigned int d = 0; d < dim; ++d)
    {
      Number speed(0.), square(0.);
      for (unsigned int e = 0; e < dim; ++e)
      {
        speed += p[C::velocity + e] * inverse[e][d];
        square += inverse[e][d] * inverse[e][d];
      }
      sum += std::abs(speed) + sound_speed * std::sqrt(square);
    }
    largest = std::max(largest, sum);
  }
  return largest;
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class GalerkinLeaves<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
