// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/make_finite_volume_operator.h>
#include <contrecoup/gas/galerkin/make_galerkin_operator.h>
#include <contrecoup/gas/stepping/make_gas_operator.h>

namespace contrecoup::gas
{
template <int dim>
std::unique_ptr<GasOperator<dim>>
make_gas_operator(const LeafMesh<dim> &mesh,
                  const LeafLayout &layout,
                  const Scheme &scheme,
                  const GasMaterial &material,
                  const Boundary<dim> &boundary,
                  const CutLeaves<dim> *cut_leaves)
{
  if (scheme.kind == Scheme::Kind::finite_volume)
    return make_finite_volume_operator(
      mesh, layout, scheme, material, boundary, cut_leaves);
  return make_galerkin_operator(mesh, layout, scheme, material, boundary);
}


template std::unique_ptr<GasOperator<1>>
make_gas_operator(const LeafMesh<1> &,
                  const LeafLayout &,
                  const Scheme &,
                  const GasMaterial &,
                  const Boundary<1> &,
                  const CutLeaves<1> *);
template std::unique_ptr<GasOperator<2>>
make_gas_operator(const LeafMesh<2> &,
                  const LeafLayout &,
                  const Scheme &,
                  const GasMaterial &,
                  const Boundary<2> &,
                  const CutLeaves<2> *);
template std::unique_ptr<GasOperator<3>>
make_gas_operator(const LeafMesh<3> &,
                  const LeafLayout &,
                  const Scheme &,
                  const GasMaterial &,
                  const Boundary<3> &,
                  const CutLeaves<3> *);
} // namespace contrecoup::gas
