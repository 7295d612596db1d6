// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// What FEEvaluation and FEFaceEvaluation need of deal.II for the lanes of
// base/lanes.h. deal.II's selectors compile kernels of each degree for elements
// without symmetry and for derivatives on faces as well: with these, and one
// number of quadrature points for each degree, this file took 192 s to compile
// instead of 51 s. Here each degree has kernels for as many points as nodes
// and, on faces, for values alone. deal.II's kernel for any degree does the
// rest, which only the set-up of MatrixFree needs.

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
  template <int dim, typename Number>
  using CellData = FEEvaluationData<dim, Number, false>;
  template <int dim, typename Number>
  using FaceData = FEEvaluationData<dim, Number, true>;
  using Flags = EvaluationFlags::EvaluationFlags;

  /// Whether the element is a tensor product of symmetric polynomials with as
  /// many quadrature points as nodes.
  template <typename Evaluation>
  bool has_kernel(const Evaluation &evaluation)
  {
    const auto &shape = evaluation.get_shape_info();
    return shape.element_type <= MatrixFreeFunctions::tensor_symmetric &&
           shape.data[0].n_q_points_1d == shape.data[0].fe_degree + 1;
  }

  /// Whether has_kernel(), and values on faces between cells of equal size are
  /// asked for.
  template <typename Evaluation>
  bool has_face_kernel(const Evaluation &evaluation, const Flags flags)
  {
    return has_kernel(evaluation) && flags == EvaluationFlags::values &&
           evaluation.get_subface_index() >=
             GeometryInfo<Evaluation::dimension>::max_children_per_cell &&
           (evaluation.is_interior_face() ||
            evaluation.get_dof_access_index() !=
              MatrixFreeFunctions::DoFInfo::dof_access_cell);
  }

  /// Calls Kernel::run<degree, degree + 1>() or, for other degrees or if not
  /// @p is_fixed, Kernel::run<-1, 0>().
  template <typename Kernel, typename Evaluation, typename... Arguments>
  void run_kernel(const bool is_fixed,
                  const Evaluation &evaluation,
                  Arguments &...arguments)
  {
    instantiation_helper_degree_run<1, Kernel>(
      is_fixed ? evaluation.get_shape_info().data[0].fe_degree
               : numbers::invalid_unsigned_int,
      arguments...);
  }

  /// Values and derivatives of functions at the quadrature points of a cell.
  template <int dim, typename Number>
  struct CellEvaluation
  {
    template <int degree, int n_points>
    static bool run(const unsigned int n_components,
                    const Flags flags,
                    const Number *values,
                    CellData<dim, Number> &evaluation)
    {
      if constexpr (degree == -1)
        FEEvaluationImplEvaluateSelector<dim, Number>::template run<-1, 0>(
          n_components, flags, values, evaluation);
      else if (evaluation.get_shape_info().element_type ==
               MatrixFreeFunctions::tensor_symmetric_collocation)
        FEEvaluationImplCollocation<dim, degree, Number>::evaluate(
          n_components, flags, values, evaluation);
      else
        FEEvaluationImplTransformToCollocation<dim, degree, n_points, Number>::
          evaluate(n_components, flags, values, evaluation);
      return false;
    }
  };

  /// Integrals of values and derivatives over a cell, times test functions.
  template <int dim, typename Number>
  struct CellIntegration
  {
    template <int degree, int n_points>
    static bool run(const unsigned int n_components,
                    const Flags flags,
                    Number *values,
                    CellData<dim, Number> &evaluation,
                    const bool adds)
    {
      if constexpr (degree == -1)
        FEEvaluationImplIntegrateSelector<dim, Number>::template run<-1, 0>(
          n_components, flags, values, evaluation, adds);
      else if (evaluation.get_shape_info().element_type ==
               MatrixFreeFunctions::tensor_symmetric_collocation)
        FEEvaluationImplCollocation<dim, degree, Number>::integrate(
          n_components, flags, values, evaluation, adds);
      else
        FEEvaluationImplTransformToCollocation<dim, degree, n_points, Number>::
          integrate(n_components, flags, values, evaluation, adds);
      return false;
    }
  };

  /// Brings values on a face into the numbering of the quadrature points, or
  /// with @p integrates back.
  template <int dim, typename Number>
  void turn_face_values(const unsigned int n_components,
                        const bool integrates,
                        Number *scratch,
                        FaceData<dim, Number> &evaluation)
  {
    const auto &shape = evaluation.get_shape_info();
    const unsigned int orientation = evaluation.get_face_orientation();
    if (orientation != 0)
      adjust_for_face_orientation(dim,
                                  n_components,
                                  EvaluationFlags::values,
                                  &shape.face_orientations_quad(orientation, 0),
                                  integrates,
                                  shape.n_q_points_face,
                                  scratch,
                                  evaluation.begin_values(),
                                  evaluation.begin_gradients(),
                                  evaluation.begin_hessians());
  }

  /// Values of functions at the quadrature points of a face.
  template <int dim, typename Number>
  struct FaceEvaluation
  {
    template <int degree, int n_points>
    static bool run(const unsigned int n_components,
                    const Flags flags,
                    const Number *values,
                    FaceData<dim, Number> &evaluation)
    {
      if constexpr (degree == -1)
        return FEFaceEvaluationImplEvaluateSelector<dim, Number>::
          template run<-1, 0>(n_components, flags, values, evaluation);
      else
      {
        const auto &shape = evaluation.get_shape_info();
        Number *scratch = evaluation.get_scratch_data().begin();
        FEFaceNormalEvaluationImpl<dim, degree, Number>::
          template interpolate<true, false>(n_components,
                                            EvaluationFlags::values,
                                            shape,
                                            values,
                                            scratch,
                                            evaluation.get_face_no());
        FEFaceEvaluationImpl<true, dim, degree, n_points, Number>::
          evaluate_in_face(n_components,
                           EvaluationFlags::values,
                           shape.data[0],
                           scratch,
                           evaluation.begin_values(),
                           evaluation.begin_gradients(),
                           evaluation.begin_hessians(),
                           nullptr,
                           evaluation.get_subface_index());
        turn_face_values(n_components, false, scratch, evaluation);
        return false;
      }
    }
  };

  /// Integrals of values over a face, times test functions.
  template <int dim, typename Number>
  struct FaceIntegration
  {
    template <int degree, int n_points>
    static bool run(const unsigned int n_components,
                    const Flags flags,
                    Number *values,
                    FaceData<dim, Number> &evaluation)
    {
      if constexpr (degree == -1)
        return FEFaceEvaluationImplIntegrateSelector<dim, Number>::
          template run<-1, 0>(n_components, flags, values, evaluation);
      else
      {
        const auto &shape = evaluation.get_shape_info();
        Number *scratch = evaluation.get_scratch_data().begin();
        turn_face_values(n_components, true, scratch, evaluation);
        FEFaceEvaluationImpl<true, dim, degree, n_points, Number>::
          integrate_in_face(n_components,
                            EvaluationFlags::values,
                            shape.data[0],
                            scratch,
                            evaluation.begin_values(),
                            evaluation.begin_gradients(),
                            evaluation.begin_hessians(),
                            nullptr,
                            evaluation.get_subface_index());
        FEFaceNormalEvaluationImpl<dim, degree, Number>::
          template interpolate<false, false>(n_components,
                                             EvaluationFlags::values,
                                             shape,
                                             scratch,
                                             values,
                                             evaluation.get_face_no());
        return false;
      }
    }
  };
} // namespace


template <int dim, typename Number>
void FEEvaluationFactory<dim, Number>::evaluate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  const Number *values,
  FEEvaluationData<dim, Number, false> &evaluation)
{
  run_kernel<CellEvaluation<dim, Number>>(has_kernel(evaluation),
                                          evaluation,
                                          n_components,
                                          flags,
                                          values,
                                          evaluation);
}


template <int dim, typename Number>
void FEEvaluationFactory<dim, Number>::integrate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  Number *values,
  FEEvaluationData<dim, Number, false> &evaluation,
  const bool adds)
{
  run_kernel<CellIntegration<dim, Number>>(has_kernel(evaluation),
                                           evaluation,
                                           n_components,
                                           flags,
                                           values,
                                           evaluation,
                                           adds);
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
  run_kernel<FaceEvaluation<dim, Number>>(has_face_kernel(evaluation, flags),
                                          evaluation,
                                          n_components,
                                          flags,
                                          values,
                                          evaluation);
}


template <int dim, typename Number>
void FEFaceEvaluationFactory<dim, Number>::integrate(
  const unsigned int n_components,
  const EvaluationFlags::EvaluationFlags flags,
  Number *values,
  FEEvaluationData<dim, Number, true> &evaluation)
{
  run_kernel<FaceIntegration<dim, Number>>(has_face_kernel(evaluation, flags),
                                           evaluation,
                                           n_components,
                                           flags,
                                           values,
                                           evaluation);
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
