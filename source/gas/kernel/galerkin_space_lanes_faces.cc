// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// What FEFaceEvaluation needs of deal.II for the lanes of base/lanes.h; its
// header shares a guard with that for cells.

#include <contrecoup/base/lanes/lanes.h>

#define FE_EVAL_FACTORY_DEGREE_MAX 5

#include <deal.II/matrix_free/evaluation_template_face_factory.templates.h>

using contrecoup::Lanes;

template struct dealii::internal::FEFaceEvaluationFactory<1, Lanes<double>>;
template struct dealii::internal::FEFaceEvaluationFactory<2, Lanes<double>>;
template struct dealii::internal::FEFaceEvaluationFactory<3, Lanes<double>>;
template struct dealii::internal::FEFaceEvaluationFactory<3, Lanes<float>>;
