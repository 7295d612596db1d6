// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/gas_operator.h>
#include <contrecoup/materials/gas_material.h>

#include <memory>
#include <tuple>

namespace contrecoup::gas
{
/// Makes the operator of a scheme for the equation of state of a material.
template <int dim, typename Real>
using OperatorMaker =
  std::unique_ptr<GasOperator<dim, Real>> (*)(const OperatorContext<dim> &,
                                              const GasMaterial &);

/// Makers of the discontinuous Galerkin scheme, by dimension and precision.
using GalerkinMakers = std::tuple<OperatorMaker<1, double>,
                                  OperatorMaker<2, double>,
                                  OperatorMaker<3, double>,
                                  OperatorMaker<3, float>>;

/**
 * Those of the library contrecoup_galerkin, which is looked for beside this one
 * and loaded by the first call: its kernels take a third of the time to compile
 * all that a scene with finite volumes needs.
 *
 * @throws InputError if that library is not there or cannot be loaded
 */
const GalerkinMakers &galerkin_makers();
} // namespace contrecoup::gas
