// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// What FEEvaluation and FEFaceEvaluation need of deal.II for the lanes of
// base/lanes.h. deal.II's own definitions compile kernels for four numbers of
// quadrature points with each degree, in three times the time; here each
// degree has a kernel for as many points as nodes.

#include <contrecoup/base/lanes/lanes.h>

// Degrees that get kernels of their own; see the entry Method/Degree.
#define FE_EVAL_FACTORY_DEGREE_MAX 5

#include <deal.II/matrix_free/evaluation_kernels.h>
#include <deal.II/matrix_free/evaluation_selector.h>
#include <deal.II/matrix_free/evaluation_template_factory.h>
#include <deal.II/matrix_free/evaluation_template_factory_internal.h>

namespace dealii::internal
{
namespace
{
  /// Runs the kernel of a degree; a slower one for all degrees where the
  /// numbers of points and nodes differ.
  template <typename Kernel, typename Evaluation, typename... Arguments>
  void run_kernel(const Evaluation &evaluation, Arguments &...arguments)
  {
    const auto &shape = evaluation.get_shape_info().data[0];
    if (shape.n_q_points_1d == shape.fe_degree + 1)
      instantiation_helper_degree_run<1, Kernel>(shape.fe_degree, arguments...);
    else
      Kernel::template run<-1, 0>(arguments...);
  }
} // namespace


template <int dim, typename Number>
void FEEvaluationFactory<dim, Number>::evaluate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  const Number *values,
  FEEvaluationData<dim, Number, false> &evaluation)
{
  run_kernel<FEEvaluationImplEvaluateSelector<dim, Number>>(
    evaluation, n_components, flags, values, evaluation);
}


template <int dim, typename Number>
void FEEvaluationFactory<dim, Number>::integrate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  Number *values,
  FEEvaluationData<dim, Number, false> &evaluation,
  const bool adds)
{
  run_kernel<FEEvaluationImplIntegrateSelector<dim, Number>>(
    evaluation, n_components, flags, values, evaluation, adds);
}


template <int dim, typename Number>
bool FEEvaluationFactory<dim, Number>::fast_evaluation_supported(
  const unsigned int degree,
  const unsigned int n_q_points)
{
  return degree >= 1 && degree <= FE_EVAL_FACTORY_DEGREE_MAX &&
         n_q_points == degree + 1;
}


template <int dim, typename Number>
void FEFaceEvaluationFactory<dim, Number>::evaluate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  const Number *values,
  FEEvaluationData<dim, Number, true> &evaluation)
{
  run_kernel<FEFaceEvaluationImplEvaluateSelector<dim, Number>>(
    evaluation, n_components, flags, values, evaluation);
}


template <int dim, typename Number>
void FEFaceEvaluationFactory<dim, Number>::integrate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  Number *values,
  FEEvaluationData<dim, Number, true> &evaluation)
{
  run_kernel<FEFaceEvaluationImplIntegrateSelector<dim, Number>>(
    evaluation, n_components, flags, values, evaluation);
}


template <int dim, typename Number>
void CellwiseInverseMassFactory<dim, Number>::apply(
  const unsigned int n_components,
  const FEEvaluationData<dim, Number, false> &evaluation,
  const Number *in,
  Number *out)
{
  instantiation_helper_degree_run<
    1,
    CellwiseInverseMassMatrixImplBasic<dim, Number>>(
    evaluation.get_shape_info().data[0].fe_degree,
    n_components,
    evaluation,
    in,
    out);
}


#define CONTRECOUP_INSTANTIATE(dim, Real)                                \
  template struct FEEvaluationFactory<dim, contrecoup::Lanes<Real>>;     \
  template struct FEFaceEvaluationFactory<dim, contrecoup::Lanes<Real>>; \
  template void                                                          \
  CellwiseInverseMassFactory<dim, contrecoup::Lanes<Real>>::apply(       \
    const unsigned int,                                                  \
    const FEEvaluationData<dim, contrecoup::Lanes<Real>, false> &,       \
    const contrecoup::Lanes<Real> *,                                     \
    contrecoup::Lanes<Real> *)

CONTRECOUP_INSTANTIATE(1, double);
CONTRECOUP_INSTANTIATE(2, double);
CONTRECOUP_INSTANTIATE(3, double);
CONTRECOUP_INSTANTIATE(3, float);
#undef CONTRECOUP_INSTANTIATE
} // namespace dealii::internal
