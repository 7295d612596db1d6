// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// What FEEvaluation and CellwiseInverseMassMatrix need of deal.II for lanes
// that the library does not hold, in the way that FEEvaluation documents.

#include <contrecoup/base/deal_ii/lane_width.h>

#if DEAL_II_VECTORIZATION_WIDTH_IN_BITS == 0

// Degrees that get kernels of their own; see the entry Method/Degree.
#  define FE_EVAL_FACTORY_DEGREE_MAX 5

#  include <deal.II/matrix_free/evaluation_template_factory.templates.h>

template <typename Real>
using Lanes =
  dealii::VectorizedArray<Real, CONTRECOUP_LANE_BITS / (8 * sizeof(Real))>;

#  define CONTRECOUP_INSTANTIATE(dim, Real)                                  \
    template struct dealii::internal::FEEvaluationFactory<dim, Lanes<Real>>; \
    template void                                                            \
    dealii::internal::CellwiseInverseMassFactory<dim, Lanes<Real>>::apply(   \
      const unsigned int,                                                    \
      const dealii::FEEvaluationData<dim, Lanes<Real>, false> &,             \
      const Lanes<Real> *,                                                   \
      Lanes<Real> *)

CONTRECOUP_INSTANTIATE(1, double);
CONTRECOUP_INSTANTIATE(2, double);
CONTRECOUP_INSTANTIATE(3, double);
CONTRECOUP_INSTANTIATE(3, float);
#  undef CONTRECOUP_INSTANTIATE

#endif
