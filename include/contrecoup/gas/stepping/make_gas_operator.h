// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/gas_operator.h>

namespace contrecoup::gas
{
/// The operator that @p scheme and @p material ask for; the arguments must
/// outlive it. Finite volumes on boxes go around the body of @p cut_leaves;
/// null: there is none.
template <int dim>
std::unique_ptr<GasOperator<dim>>
make_gas_operator(const LeafMesh<dim> &mesh,
                  const LeafLayout &layout,
                  const Scheme &scheme,
                  const GasMaterial &material,
                  const Boundary<dim> &boundary,
                  const CutLeaves<dim> *cut_leaves = nullptr);
} // namespace contrecoup::gas
