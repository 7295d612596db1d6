// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/galerkin/galerkin_faces.h>
#include <contrecoup/gas/stage/kernel_instances.h>

#include <deal.II/base/quadrature_lib.h>

// Hanging faces of mapped leaves, at Gauss points of the fine face, which are
// numbered like the coarse one.

namespace contrecoup::gas
{
template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::measure_hanging_areas(
  const unsigned int face_batch)
{
  batch_ = &space_.faces()[face_batch];
  const dealii::QGauss<1> gauss(layout_.n);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    const unsigned int own = hanging_point(0, q);
    const unsigned int i = own % layout_.n, j = own / layout_.n;
    for (unsigned int lane = 0; lane < width; ++lane)
    {
      const auto area = outward_area(space_.mesh(),
                                     batch_->leaf[0][lane],
                                     batch_->face[0],
                                     gauss.point(i)[0],
                                     gauss.point(j)[0]);
      const double weight = gauss.weight(i) * (dim == 3 ? gauss.weight(j) : 1.);
      for (unsigned int d = 0; d < dim; ++d)
        hanging_area(face_batch, q)[d][lane] = weight * area[d];
    }
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::mapped_hanging_fluxes()
{
  for (unsigned int q = 0; q < n_points_; ++q)
    axes_[q] = FaceAxes<dim, Number>(hanging_area(index_, q));
  for (unsigned int side = 0; side < 2; ++side)
    interpolate_hanging(side);
  for (unsigned int q = 0; q < n_points_; ++q)
    flux_[q] = flux(near_[0][q], near_[1][q]);
  for (unsigned int side = 0; side < 2; ++side)
    integrate_hanging(side);
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::interpolate_hanging(const unsigned int side)
{
  reference_pressure_[side] =
    to_primitive<dim>(gas_, conserved(side, 0))[C::pressure];
  Trace &differences = far_[side];
  const auto [base, mean] = load_face(side, differences);
  apply_along_face(matrix_of(to_gauss_, side), differences);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    Values u = base;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] += differences[hanging_point(side, q)][c];
    near_[side][q] = along_axes(q, admissible_primitive(u, mean));
  }
}


template <int dim, typename Gas, typename Real>
void GalerkinFaces<dim, Gas, Real>::integrate_hanging(const unsigned int side)
{
  Trace &outflows = far_[side];
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    Values &value = outflows[hanging_point(side, q)] = outflow(side, q);
    for (Number &component : value)
      component *= axes_[q].area;
  }
  apply_along_face(matrix_of(from_gauss_, side), outflows);
  Real *to = record(side);
  for (unsigned int c = 0; c < nc; ++c)
    for (unsigned int q = 0; q < n_points_; ++q, to += width)
      outflows[q][c].store(to);
}


#define CONTRECOUP_INSTANTIATE(dim, Gas, Real)                        \
  template void GalerkinFaces<dim, Gas, Real>::measure_hanging_areas( \
    const unsigned int);                                              \
  template void GalerkinFaces<dim, Gas, Real>::mapped_hanging_fluxes()

CONTRECOUP_FOR_MAPPED_KERNELS(CONTRECOUP_INSTANTIATE);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
