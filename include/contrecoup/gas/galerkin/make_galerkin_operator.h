// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/further_makers.h>

namespace contrecoup::gas
{
/// Makes the discontinuous Galerkin operator for the equation of state of @p
/// material.
template <int dim, typename Real>
std::unique_ptr<GasOperator<dim, Real>>
make_galerkin_operator(const OperatorContext<dim> &context,
                       const GasMaterial &material);
} // namespace contrecoup::gas
