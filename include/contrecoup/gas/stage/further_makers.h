// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/gas_operator.h>
#include <contrecoup/materials/gas_material.h>

#include <memory>
#include <string>
#include <tuple>

namespace contrecoup::gas
{
/// Makes the operator of a scheme for the equation of state of a material.
template <int dim, typename Real>
using OperatorMaker =
  std::unique_ptr<GasOperator<dim, Real>> (*)(const OperatorContext<dim> &,
                                              const GasMaterial &);

/// Makers of the operators of a scheme, by dimension and precision; null where
/// it has none.
using OperatorMakers = std::tuple<OperatorMaker<1, double>,
                                  OperatorMaker<2, double>,
                                  OperatorMaker<3, double>,
                                  OperatorMaker<3, float>>;

/// Makers of the schemes of the library contrecoup_further_schemes.
extern "C" const OperatorMakers contrecoup_galerkin_makers,
  contrecoup_mapped_makers;

/**
 * The makers of a scheme in that library, which is looked for beside this one
 * and loaded by the first call: the kernels of these schemes take more than a
 * third of the time to compile all that a scene needs.
 *
 * @param scheme "galerkin" or "mapped"
 * @param choice what asks for it, for the message
 * @throws InputError if that library is not there or cannot be loaded
 */
const OperatorMakers &further_makers(const std::string &scheme,
                                     const std::string &choice);
} // namespace contrecoup::gas
