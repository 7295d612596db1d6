// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Parts of deal.II for lanes that the library does not hold, as the set-up of
// MatrixFree and cell evaluations of degree -1 need them, in the way that
// FEEvaluation documents. Time steps use evaluations with compiled degrees.

#include <contrecoup/base/deal_ii/lane_width.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0

// Higher degrees share the kernels that loop over any number of nodes.
#  define FE_EVAL_FACTORY_DEGREE_MAX 1

#  include <deal.II/matrix_free/evaluation_template_factory.templates.h>

template <typename Real>
using Lanes =
  dealii::VectorizedArray<Real, CONTRECOUP_LANE_BITS / (8 * sizeof(Real))>;

template struct dealii::internal::FEEvaluationFactory<1, Lanes<double>>;
template struct dealii::internal::FEEvaluationFactory<2, Lanes<double>>;
template struct dealii::internal::FEEvaluationFactory<3, Lanes<double>>;
template struct dealii::internal::FEEvaluationFactory<3, Lanes<float>>;

#endif
