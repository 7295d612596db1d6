// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/galerkin/galerkin_faces.h>
#include <contrecoup/gas/stage/kernel_instances.h>

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::hanging_fluxes()
{
  const unsigned int fine = batch_->interior;
  for (unsigned int q = 0; q < n_points_; ++q)
    near_[fine][q] = along_axes(
      q,
      to_primitive<dim>(
        gas_, conserved(fine, layout_.face_point(batch_->face[fine], q, 0))));
  interpolate_coarse_side();
  for (unsigned int q = 0; q < n_points_; ++q)
    flux_[q] = flux(near_[0][q], near_[1][q]);
  store_flux();
  project_onto_coarse_side();
}


// Differences are interpolated, so that equal values stay what they are, to
// the last bit.
template <int dim, typename Gas, typename Real>
std::array<typename GalerkinFaces<dim, Gas, Real>::Values, 2>
GalerkinFaces<dim, Gas, Real>::load_face(const unsigned int side,
                                         Trace &trace) const
{
  const unsigned int face = batch_->face[side];
  const Values base = conserved(side, layout_.face_point(face, 0, 0));
  Values mean = base;
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const Values u = conserved(side, layout_.face_point(face, q, 0));
    for (unsigned int c = 0; c < nc; ++c)
    {
      trace[q][c] = u[c] - base[c];
      mean[c] += trace[q][c] * (1. / n_points_);
    }
  }
  return {{base, mean}};
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::interpolate_coarse_side()
{
  Trace &trace = near_[1 - batch_->interior];
  const auto [base, mean] = load_face(1 - batch_->interior, trace);
  apply_along_face({{&basis_.to_child(0), &basis_.to_child(1)}}, trace);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    Values u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = base[c] + trace[q][c];
    trace[q] = along_axes(q, admissible_primitive(u, mean));
  }
}


// A coarse node takes the mean flux around it. Areas that grow with the radius
// have equal sums on both sides, and an even flux keeps its value. Each finer
// neighbour brings an equal part of the coarse leaf's reference pressure.
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::project_onto_coarse_side()
{
  const unsigned int coarse = 1 - batch_->interior;
  const bool is_along_radius = !fine_radius_.is_plane() && batch_->face[0] >= 2;
  const Values at_first =
    conserved(coarse, layout_.face_point(batch_->face[coarse], 0, 0));
  reference_pressure_[coarse] =
    to_primitive<dim>(gas_, conserved(coarse, 0))[C::pressure];
  Values even;
  even.fill(Number(0.));
  even[C::momentum] = reference_pressure_[coarse];
  if (is_along_radius)
  {
    bind_radius();
    const Values state = along_axes(0, to_primitive<dim>(gas_, at_first));
    even = flux(state, state);
  }
  for (unsigned int q = 0; q < n_points_; ++q)
    for (unsigned int c = 0; c < nc; ++c)
    {
      flux_[q][c] -= even[c];
      if (is_along_radius)
        flux_[q][c] *= fine_radius_.jacobian(q);
    }
  apply_along_face({{&basis_.from_child(0), &basis_.from_child(1)}}, flux_);
  Real *const to = record(coarse);
  for (unsigned int q = 0; q < n_points_; ++q)
    for (unsigned int c = 0; c < nc; ++c)
    {
      Number value = flux_[q][c];
      if (is_along_radius)
        value = value / coarse_radius_.jacobian(q);
      value += even[c] * (1. / HangingFace<dim>::n_fine);
      value.store(to + (component(c) * n_points_ + q) * width);
    }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::apply_along_face(
  const MatrixOfHalf &matrix_of_half,
  Trace &trace)
{
  const unsigned int n = layout_.n;
  unsigned int quarter = batch_->quarter;
  for (unsigned int stride = 1; stride < n_points_; stride *= n, quarter /= 2)
  {
    const auto &matrix = *matrix_of_half[quarter % 2];
    for (unsigned int line = 0; line < n_points_ / n; ++line)
    {
      Values *const first =
        trace.data() + line % stride + line / stride * stride * n;
      for (unsigned int i = 0; i < n; ++i)
        line_[i] = first[i * stride];
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int c = 0; c < nc; ++c)
        {
          Number sum(0.);
          for (unsigned int j = 0; j < n; ++j)
            sum += line_[j][c] * matrix(i, j);
          first[i * stride][c] = sum;
        }
    }
  }
}


// Lanes whose coarse leaf another rank owns may have any radius.
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::bind_radius()
{
  Number inner(0.), extent(1.);
  for (unsigned int lane = 0; lane < batch_->n_filled; ++lane)
  {
    const unsigned int leaf = batch_->leaf[1 - batch_->interior][lane];
    if (leaf >= space_.mesh().n_owned())
      continue;
    const auto box = leaf_box(space_.mesh(), leaf);
    inner[lane] = box.origin[0];
    extent[lane] = box.extents[0];
  }
  coarse_radius_.reinit(inner, extent);
  fine_radius_.reinit(Number(inner + extent * (0.5 * batch_->quarter)),
                      Number(extent * 0.5));
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real)                           \
  template void GalerkinFaces<dim, Gas, Real>::hanging_fluxes();         \
  template void GalerkinFaces<dim, Gas, Real>::apply_along_face(         \
    const MatrixOfHalf &, Trace &);                                      \
  template std::array<std::array<Lanes<Real>, n_conserved<dim, Gas>>, 2> \
  GalerkinFaces<dim, Gas, Real>::load_face(const unsigned int, Trace &) const

CONTRECOUP_FOR_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
