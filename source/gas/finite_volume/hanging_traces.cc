// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/hanging_traces.h>
#include <contrecoup/gas/finite_volume/velocity_slope.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
HangingTraces<dim, Gas, Real>::HangingTraces(
  const OperatorContext<dim> &context,
  const Gas &gas,
  PrimitiveField<dim, Gas, Real> &primitives)
  : layout_(context.layout)
  , scheme_(context.scheme)
  , gas_(gas)
  , primitives_(primitives)
  , coarse_progress_(layout_.n_face_points)
  , coarse_flux_(layout_.n_face_points)
  , open_sum_(layout_.n_face_points)
  , open_mean_(layout_.n_face_points)
  , coarse_halo_(layout_.n_face_points)
  , writer_(layout_.n_face_points)
{
  for (auto &slope : coarse_slope_)
    slope.resize(layout_.n_face_points);
  for (unsigned int layer = 0; layer < 2; ++layer)
  {
    coarse_[layer].resize(layout_.n_face_points);
    for (unsigned int part = 0; part < n_fine; ++part)
      fine_[part][layer].resize(layout_.n_face_points);
  }
  for (unsigned int part = 0; part < n_fine; ++part)
  {
    fine_progress_[part].resize(layout_.n_face_points);
    fine_halo_[part].resize(layout_.n_face_points);
    fine_flux_[part].resize(layout_.n_face_points);
  }
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::prepare(
  const HangingGroup<dim> &group,
  const BasicStage<Real> &stage,
  const HangingOpenings<dim, Real> *openings)
{
  bounds_velocity_slopes_ = stage.bound_velocity_slopes;
  openings_ = openings;
  load(group);
  load_progress(group, stage);
  average_fine_side();
  if (openings_ != nullptr)
    average_open_fine_side();
  if (scheme_.linear_reconstruction)
    limit_coarse_slopes();
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::load(const HangingGroup<dim> &group)
{
  load_leaves(
    group.coarse_leaf.data(),
    group.coarse_face,
    [](const unsigned int q) { return q; },
    coarse_);
  for (unsigned int part = 0; part < n_fine; ++part)
    load_leaves(
      group.fine_leaf[part].data(),
      group.match.face,
      [&](const unsigned int q) { return fine_point(group, q); },
      fine_[part]);
}


template <int dim, typename Gas, typename Real>
template <typename PointAt>
void HangingTraces<dim, Gas, Real>::load_leaves(
  const unsigned int *leaves,
  const unsigned int face,
  const PointAt &point_at,
  std::array<dealii::AlignedVector<Values>, 2> &layers)
{
  reader_.reinit(leaves, layout_);
  for (unsigned int s = 0; s < reader_.n_sources(); ++s)
    primitives_.batch(reader_.source(s) / layout_.batch_size());
  for (unsigned int layer = 0; layer < 2; ++layer)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    {
      const unsigned int point =
        layout_.face_point(face, point_at(q), std::min(layer, layout_.n - 1));
      reader_.read(primitives_.data() +
                     PrimitiveField<dim, Gas, Real>::index(0, point),
                   n_lanes<Real>,
                   layers[layer][q]);
    }
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::load_progress(
  const HangingGroup<dim> &group,
  const BasicStage<Real> &stage)
{
  burn_ = nullptr;
  if (stage.burn == nullptr)
    return;
  bool any = false;
  for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
  {
    any = any || stage.burn->burns[group.coarse_leaf[lane]];
    for (const auto &leaves : group.fine_leaf)
      any = any || stage.burn->burns[leaves[lane]];
  }
  if (!any)
    return;
  burn_ = stage.burn;
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    const unsigned int coarse = layout_.face_point(group.coarse_face, q, 0);
    const unsigned int fine =
      layout_.face_point(group.match.face, fine_point(group, q), 0);
    for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
    {
      coarse_progress_[q][lane] =
        burn_->progress(group.coarse_leaf[lane], coarse, stage.time);
      for (unsigned int part = 0; part < n_fine; ++part)
        fine_progress_[part][q][lane] =
          burn_->progress(group.fine_leaf[part][lane], fine, stage.time);
    }
  }
}


template <int dim, typename Gas, typename Real>
unsigned int
HangingTraces<dim, Gas, Real>::fine_point(const HangingGroup<dim> &group,
                                          const unsigned int point) const
{
  if (dim == 1)
    return 0;
  return matched_face_point(group.match.orientation,
                            point % layout_.n,
                            dim == 3 ? point / layout_.n : 0,
                            layout_.n);
}


template <int dim, typename Gas, typename Real>
unsigned int HangingTraces<dim, Gas, Real>::coarse_point(
  const unsigned int part,
  const unsigned int fine_point,
  std::array<double, dim == 1 ? 1 : dim - 1> &distance) const
{
  const unsigned int n = layout_.n;
  unsigned int result = 0, factor = 1, q = fine_point;
  for (unsigned int t = 0; t + 1 < dim; ++t)
  {
    const unsigned int position = ((part >> t) % 2) * n + q % n;
    distance[t] = position % 2 ? 0.25 : -0.25;
    result += position / 2 * factor;
    factor *= n;
    q /= n;
  }
  return result;
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::average_fine_side()
{
  // A coarse subcell beyond the face holds 2^(dim-1) fine ones in each of
  // two layers, or of one where a leaf is a single cell deep.
  const unsigned int n_layers = std::min(2U, layout_.n);
  const double weight = 1. / (n_fine * n_layers);
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
    coarse_halo_[q].fill(Number(0.));
  std::array<double, dim == 1 ? 1 : dim - 1> distance;
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
      for (unsigned int layer = 0; layer < n_layers; ++layer)
        for (unsigned int c = 0; c < nc; ++c)
          coarse_halo_[coarse_point(part, q, distance)][c] +=
            fine_[part][layer][q][c] * weight;
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::average_open_fine_side()
{
  // Differences from the coarse value, so that equal ones keep every bit.
  dealii::AlignedVector<Values> &halo = open_mean_;
  halo = coarse_[0];
  open_sum_.fill(Number(0.));
  std::array<double, dim == 1 ? 1 : dim - 1> distance;
  for (unsigned int part = 0; part < n_fine; ++part)
    for (unsigned int q = 0; q < layout_.n_face_points; ++q)
      for (unsigned int layer = 0; layer < 2; ++layer)
      {
        const unsigned int at = coarse_point(part, q, distance);
        const Number &volume = openings_->fraction[part][layer][q];
        open_sum_[at] += volume;
        const Number share = select_less(
          Number(0.), volume, Number(volume / open_sum_[at]), Number(0.));
        for (unsigned int c = 0; c < nc; ++c)
          halo[at][c] += (fine_[part][layer][q][c] - halo[at][c]) * share;
      }
  take_in_cut_lanes(coarse_halo_);
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::take_in_cut_lanes(
  dealii::AlignedVector<Values> &means) const
{
  for (unsigned int q = 0; q < means.size(); ++q)
    for (unsigned int c = 0; c < nc; ++c)
      means[q][c] = select_less(
        Number(0.), openings_->is_cut, open_mean_[q][c], means[q][c]);
}


template <int dim, typename Gas, typename Real>
typename HangingTraces<dim, Gas, Real>::Values
HangingTraces<dim, Gas, Real>::tangential_slope(const unsigned int point,
                                                const unsigned int t) const
{
  const unsigned int n = layout_.n;
  Values slope;
  slope.fill(Number(0.));
  if (n < 2)
    return slope;
  // The two differences next to the point; at the rim of the leaf those on
  // its inner side.
  const unsigned int s = t == 0 ? 1 : n;
  const unsigned int index = (point / s) % n;
  const unsigned int first =
    n == 2 ? 0 : std::min(index > 0 ? index - 1 : 0, n - 3);
  const unsigned int second = n == 2 ? 0 : first + 1;
  const unsigned int begin = point - index * s;
  const Values *line = &coarse_[0][begin];
  for (unsigned int c = 0; c < nc; ++c)
  {
    Number one = line[(first + 1) * s][c] - line[first * s][c];
    Number other = line[(second + 1) * s][c] - line[second * s][c];
    if (openings_ != nullptr)
    {
      one *= openings_->along[t][begin + first * s];
      other *= openings_->along[t][begin + second * s];
    }
    slope[c] = limited_slope(scheme_.limiter, one, other);
  }
  return slope;
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::limit_coarse_slopes()
{
  const Number zero(0.);
  for (unsigned int q = 0; q < layout_.n_face_points; ++q)
  {
    const Values &coarse = coarse_[0][q];
    for (unsigned int t = 0; t + 1 < dim; ++t)
      coarse_slope_[t][q] = tangential_slope(q, t);
    for (unsigned int c = 0; c < nc; ++c)
    {
      // Beyond what is closed, the halo is the coarse value.
      Number inner = coarse[c] - coarse_[1][q][c];
      if (openings_ != nullptr)
        inner *= openings_->below[q];
      coarse_slope_[dim - 1][q][c] = limited_slope(
        scheme_.limiter, inner, Number(coarse_halo_[q][c] - coarse[c]));
    }
    Number square(0.);
    for (unsigned int d = 0; d < dim; ++d)
    {
      Number largest(0.);
      for (unsigned int t = 0; t < dim; ++t)
        largest += std::abs(coarse_slope_[t][q][C::velocity + d]) *
                   (t + 1 == dim ? 0.5 : 0.25);
      square += largest * largest;
    }
    Number good(1.);
    if (bounds_velocity_slopes_)
      good = energy_left<dim>(gas_, coarse, square);
    for (unsigned int corner = 0; corner < (1U << dim); ++corner)
    {
      Values part = coarse;
      for (unsigned int d = 0; d < dim; ++d)
      {
        const double distance = d + 1 == dim ? 0.5 : 0.25;
        for (unsigned int c = 0; c < nc; ++c)
          part[c] += coarse_slope_[d][q][c] *
                     ((corner >> d) & 1U ? distance : -distance);
      }
      Number products(0.);
      if constexpr (Gas::has_products)
        products = part[C::products];
      good = std::min(
        good,
        select_less(
          zero,
          part[C::density],
          Number(gas_.internal_energy_density(
                   part[C::density], part[C::pressure], products) -
                 gas_.least_energy_density(part[C::density], products)),
          zero));
    }
    for (auto &slope : coarse_slope_)
      for (unsigned int c = 0; c < nc; ++c)
        slope[q][c] = select_less(zero, good, slope[q][c], zero);
  }
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::reconstruct(const unsigned int part,
                                                const unsigned int point,
                                                Values &inside,
                                                Values &outside)
{
  std::array<double, dim == 1 ? 1 : dim - 1> distance;
  const unsigned int at = coarse_point(part, point, distance);
  const Values &fine = fine_[part][0][point];
  Values &halo = fine_halo_[part][point];
  inside = halo = coarse_[0][at];
  outside = fine;
  if (!scheme_.linear_reconstruction)
    return;
  for (unsigned int t = 0; t + 1 < dim; ++t)
    for (unsigned int c = 0; c < nc; ++c)
      inside[c] += coarse_slope_[t][at][c] * distance[t];
  halo = inside;
  // The fine subcell next to the face is a quarter of a coarse one away
  // from the coarse centre.
  for (unsigned int c = 0; c < nc; ++c)
  {
    inside[c] += coarse_slope_[dim - 1][at][c] * 0.5;
    halo[c] += coarse_slope_[dim - 1][at][c] * 0.25;
  }
  restore_if_inadmissible<dim>(gas_, coarse_[0][at], halo);
  Values half;
  for (unsigned int c = 0; c < nc; ++c)
  {
    Number inner = fine[c] - fine_[part][1][point][c];
    if (openings_ != nullptr)
      inner *= openings_->fine_below[part][point];
    half[c] =
      limited_slope(scheme_.limiter, inner, Number(halo[c] - fine[c])) * 0.5;
  }
  if (bounds_velocity_slopes_)
    limit_velocity_slope<dim>(gas_, fine, half);
  for (unsigned int c = 0; c < nc; ++c)
    outside[c] += half[c];
  restore_if_inadmissible<dim>(gas_, fine, outside);
}


template <int dim, typename Gas, typename Real>
void HangingTraces<dim, Gas, Real>::store(const HangingGroup<dim> &group,
                                          HangingData<dim, Real> &hanging)
{
  const auto same_point = [](const unsigned int q) { return q; };
  const auto own_point = [&](const unsigned int q) {
    return fine_point(group, q);
  };
  writer_.write(group, 0, coarse_flux_, coarse_halo_, same_point, hanging);
  for (unsigned int part = 0; part < n_fine; ++part)
    writer_.write(
      group, 1 + part, fine_flux_[part], fine_halo_[part], own_point, hanging);
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real) \
  template class HangingTraces<dim, Gas, Real>
CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
