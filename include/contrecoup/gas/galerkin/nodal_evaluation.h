// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/matrix_free/fe_evaluation.h>

#include <memory>
#include <type_traits>

namespace contrecoup::gas
{
/**
 * deal.II's FEEvaluation or FEFaceEvaluation of @p n_components components,
 * with kernels compiled for each degree from one to five and as many points
 * along an edge as nodes.
 *
 * With degree -1, FEEvaluation would choose among such kernels by itself, but
 * would have them compiled for four further numbers of points, too.
 */
template <int dim, int n_components, typename Real, bool is_face>
class NodalEvaluation
{
public:
  using Number = Lanes<Real>;
  /// Reads and writes values at nodes and points.
  using Access = typename std::conditional_t<
    is_face,
    dealii::FEFaceEvaluation<dim, -1, 0, n_components, Real, Number>,
    dealii::FEEvaluation<dim, -1, 0, n_components, Real, Number>>::BaseClass;

  /// The evaluation for a space of @p degree; of a face, the interior or the
  /// exterior side.
  static std::unique_ptr<NodalEvaluation>
  make(const dealii::MatrixFree<dim, Real, Number> &matrix_free,
       const unsigned int degree,
       const bool is_interior = true);

  virtual ~NodalEvaluation() = default;

  virtual void reinit(const unsigned int batch) = 0;
  virtual void
  evaluate(const dealii::EvaluationFlags::EvaluationFlags what) = 0;
  virtual void
  integrate(const dealii::EvaluationFlags::EvaluationFlags what) = 0;
  /// Applies the inverse of the mass matrix to the values at the nodes; not on
  /// faces.
  virtual void apply_inverse_mass(Number *result) const = 0;

  Access &access()
  {
    return access_;
  }
  const Access &access() const
  {
    return access_;
  }

protected:
  explicit NodalEvaluation(Access &access)
    : access_(access)
  {}

private:
  Access &access_;
};
} // namespace contrecoup::gas
