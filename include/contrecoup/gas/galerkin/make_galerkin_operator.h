// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/stage/gas_operator.h>

namespace contrecoup::gas
{
/// Makes discontinuous Galerkin operators; see make_gas_operator().
template <int dim>
std::unique_ptr<GasOperator<dim>>
make_galerkin_operator(const LeafMesh<dim> &mesh,
                       const LeafLayout &layout,
                       const Scheme &scheme,
                       const GasMaterial &material,
                       const Boundary<dim> &boundary);
} // namespace contrecoup::gas
