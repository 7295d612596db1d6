// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lane_math.h>
#include <contrecoup/gas/galerkin_kernel.h>
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
  , basis_(n)
  , indicator_(basis_, scheme.indicator_threshold)
  , radial_(radial_exponent(mesh.coarse_mesh().geometry()), n)
{
  subface_[0] = 0.;
  for (unsigned int i = 0; i < n; ++i)
  {
    weight_[i] = basis_.weights()[i];
    subface_[i + 1] = subface_[i] + weight_[i];
    for (unsigned int j = 0; j < n; ++j)
      weak_derivative_[i][j] =
        basis_.weights()[j] * basis_.derivative()(j, i) / basis_.weights()[i];
    center_[i] = 0.5 * (subface_[i] + subface_[i + 1]);
  }
  for (unsigned int i = 1; i < n; ++i)
    inverse_distance_[i] = 1. / (center_[i] - center_[i - 1]);
  inverse_distance_[0] = inverse_distance_[n] = 1. / (2. * center_[0]);
  for (unsigned int i = 0; i < n; ++i)
    slope_weights_.emplace_back(1. / inverse_distance_[i],
                                1. / inverse_distance_[i + 1],
                                center_[i] - subface_[i],
                                subface_[i + 1] - center_[i]);
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::update(
  const unsigned int batch,
  const BasicStage<Real> &stage,
  const HangingData<dim, Real> &hanging)
{
  Base::bind(batch, stage);
  load(stage.in);
  set_blending();
  if constexpr (dim < 3)
    if (!radial_.is_plane())
      radial_.reinit(mesh_.origins(batch)[0], mesh_.extents(batch)[0]);
  for (unsigned int c = 0; c < nc; ++c)
    residual_[c].fill(Number(0.));
  for (unsigned int direction = 0; direction < dim; ++direction)
    sweep(direction, hanging);
  finish(stage);
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::analyse(const unsigned int batch,
                                                const BasicStage<Real> &stage)
{
  batch_ = batch;
  load(stage.out);
  blending_factor().store(stage.sensor_out + batch * Base::width);
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
void GalerkinKernel<dim, n, Gas, Real>::load(const Real *state)
{
  const Real *values = state + batch_ * layout_.batch_size();
  for (unsigned int q = 0; q < n_points; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
    {
      u[c].load(values + (c * n_points + q) * Base::width);
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


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::set_blending()
{
  // Half of a neighbour's blending spreads, so that a shock that enters a
  // leaf finds it prepared (Hennemann et al. 2021, eq. 48).
  Number neighbor(0.);
  for (unsigned int face = 0; face < 2 * dim; ++face)
    neighbor = std::max(neighbor, Base::neighbor_sensor_[face]);
  blending_ = std::max(Base::sensor_, neighbor * 0.5);
  any_blending_ = scheme_.blending && largest_lane(blending_) > 0.;
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
  inside_ = {line_[0], line_[n - 1]};
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


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::finish(const BasicStage<Real> &stage)
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
        old.load(start + (c * n_points + q) * Base::width);
        u += (old - u) * stage.a;
      }
    }
  restore_positivity(stage);
  if constexpr (Gas::has_products)
    bound_products();
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points; ++q)
      conserved_[c][q].store(out + (c * n_points + q) * Base::width);

  // Padding lanes copy the first, so that they never overflow.
  for (unsigned int lane = mesh_.n_filled_lanes(batch_); lane < Base::width;
       ++lane)
    for (std::size_t i = 0; i < layout_.batch_size(); i += Base::width)
      out[i + lane] = out[i];
  analyse(batch_, stage);
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::scale_to_mean(const Values &mean,
                                                      const Number &theta,
                                                      const bool densities_only)
{
  for (unsigned int c = 0; c < nc; ++c)
    if (!densities_only || c == C::density || c == C::products)
      for (unsigned int q = 0; q < n_points; ++q)
        conserved_[c][q] = mean[c] + theta * (conserved_[c][q] - mean[c]);
}


template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::restore_positivity(
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
      *stage.unphysical_leaf = batch_ * Base::width + lane;

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


// Where a node's mass fraction leaves [0, 1], those of all nodes are scaled
// towards the leaf's mean, with the densities as weights.
template <int dim, int n, typename Gas, typename Real>
void GalerkinKernel<dim, n, Gas, Real>::bound_products()
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
      even + theta * (conserved_[C::products][q] - even);
  }
}


template <int dim, int n, typename Gas, typename Real>
typename GalerkinKernel<dim, n, Gas, Real>::Number
GalerkinKernel<dim, n, Gas, Real>::blending_factor() const
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
