// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/galerkin/nodal_evaluation.h>

#include <deal.II/matrix_free/operators.h>

namespace contrecoup::gas
{
namespace
{
  template <int dim, int n_components, typename Real, bool is_face, int degree>
  class EvaluationOfDegree
    : public NodalEvaluation<dim, n_components, Real, is_face>
  {
  public:
    using Base = NodalEvaluation<dim, n_components, Real, is_face>;
    using typename Base::Number;
    using Evaluation = std::conditional_t<
      is_face,
      dealii::
        FEFaceEvaluation<dim, degree, degree + 1, n_components, Real, Number>,
      dealii::
        FEEvaluation<dim, degree, degree + 1, n_components, Real, Number>>;

    explicit EvaluationOfDegree(std::unique_ptr<Evaluation> evaluation)
      : Base(*evaluation)
      , evaluation_(std::move(evaluation))
    {}

    void reinit(const unsigned int batch) override
    {
      evaluation_->reinit(batch);
    }

    void evaluate(const dealii::EvaluationFlags::EvaluationFlags what) override
    {
      evaluation_->evaluate(what);
    }

    void integrate(const dealii::EvaluationFlags::EvaluationFlags what) override
    {
      evaluation_->integrate(what);
    }

    void apply_inverse_mass(Number *result) const override
    {
      AssertThrow(!is_face, dealii::ExcNotImplemented());
      if constexpr (!is_face)
        dealii::MatrixFreeOperators::
          CellwiseInverseMassMatrix<dim, degree, n_components, Real, Number>(
            *evaluation_)
            .apply(evaluation_->begin_dof_values(), result);
    }

  private:
    std::unique_ptr<Evaluation> evaluation_;
  };
} // namespace


template <int dim, int n_components, typename Real, bool is_face>
std::unique_ptr<NodalEvaluation<dim, n_components, Real, is_face>>
NodalEvaluation<dim, n_components, Real, is_face>::make(
  const dealii::MatrixFree<dim, Real, Number> &matrix_free,
  const unsigned int degree,
  [[maybe_unused]] const bool is_interior)
{
  const auto make_degree =
    [&](const auto number) -> std::unique_ptr<NodalEvaluation> {
    using Kind =
      EvaluationOfDegree<dim, n_components, Real, is_face, number.value>;
    using Evaluation = typename Kind::Evaluation;
    if constexpr (is_face)
      return std::make_unique<Kind>(
        std::make_unique<Evaluation>(matrix_free, is_interior));
    else
      return std::make_unique<Kind>(std::make_unique<Evaluation>(matrix_free));
  };
  switch (degree)
  {
    case 1:
      return make_degree(std::integral_constant<int, 1>());
    case 2:
      return make_degree(std::integral_constant<int, 2>());
    case 3:
      return make_degree(std::integral_constant<int, 3>());
    case 4:
      return make_degree(std::integral_constant<int, 4>());
    case 5:
      return make_degree(std::integral_constant<int, 5>());
    default:
      AssertThrow(false, dealii::ExcNotImplemented());
      return nullptr;
  }
}


// The leaves' metric terms, ideal gases, and gases with products.
#define CONTRECOUP_INSTANTIATE(dim, Real)                    \
  template class NodalEvaluation<dim, dim, Real, false>;     \
  template class NodalEvaluation<dim, dim + 2, Real, false>; \
  template class NodalEvaluation<dim, dim + 3, Real, false>; \
  template class NodalEvaluation<dim, dim + 2, Real, true>;  \
  template class NodalEvaluation<dim, dim + 3, Real, true>

CONTRECOUP_INSTANTIATE(1, double);
CONTRECOUP_INSTANTIATE(2, double);
CONTRECOUP_INSTANTIATE(3, double);
CONTRECOUP_INSTANTIATE(3, float);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
