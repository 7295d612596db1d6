// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// What FEEvaluation needs of deal.II for the lanes of base/lanes.h.

#include <contrecoup/base/lanes/lanes.h>

// Degrees that get kernels of their own; see the entry Method/Degree.
#define FE_EVAL_FACTORY_DEGREE_MAX 5

#include <deal.II/matrix_free/evaluation_template_factory.templates.h>

using contrecoup::Lanes;

#define CONTRECOUP_INSTANTIATE(dim, Real)                                  \
  template struct dealii::internal::FEEvaluationFactory<dim, Lanes<Real>>; \
  template struct dealii::internal::CellwiseInverseMassFactory<dim, Lanes<Real>>

CONTRECOUP_INSTANTIATE(1, double);
CONTRECOUP_INSTANTIATE(2, double);
CONTRECOUP_INSTANTIATE(3, double);
CONTRECOUP_INSTANTIATE(3, float);
#undef CONTRECOUP_INSTANTIATE
