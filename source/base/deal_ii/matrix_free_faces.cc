// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// As matrix_free_cells.cc, for evaluations at faces.

#include <contrecoup/base/deal_ii/lane_width.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0

#  define FE_EVAL_FACTORY_DEGREE_MAX 1

#  include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>

template <typename Real>
using Lanes =
  dealii::VectorizedArray<Real, CONTRECOUP_LANE_BITS / (8 * sizeof(Real))>;

template struct dealii::internal::FEFaceEvaluationFactory<1, Lanes<double>>;
template struct dealii::internal::FEFaceEvaluationFactory<2, Lanes<double>>;
template struct dealii::internal::FEFaceEvaluationFactory<3, Lanes<double>>;
template struct dealii::internal::FEFaceEvaluationFactory<3, Lanes<float>>;

#endif
