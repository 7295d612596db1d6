// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/kernel/galerkin_hanging.h>
#include <contrecoup/gas/kernel/galerkin_kernel.h>
#include <contrecoup/gas/kernel/leaf_operator.h>
#include <contrecoup/gas/kernel/mapped_galerkin_kernel.h>

namespace contrecoup::gas
{
namespace
{
  template <int dim, int n, typename Gas>
  std::unique_ptr<GasOperator<dim>> make(const LeafMesh<dim> &mesh,
                                         const LeafLayout &layout,
                                         const Scheme &scheme,
                                         const Gas &gas,
                                         const Boundary<dim> &boundary)
  {
    if constexpr (dim > 1)
      if (!mesh.coarse_mesh().is_axis_aligned())
        return std::make_unique<LeafOperator<dim,
                                             Gas,
                                             MappedGalerkinKernel<dim, n, Gas>,
                                             GalerkinHanging<dim, Gas>>>(
          mesh, layout, scheme, gas, boundary);
    return visit_precision(
      layout.precision,
      [&](const auto real) -> std::unique_ptr<GasOperator<dim>> {
        using Real = kernel_number<dim, std::decay_t<decltype(real)>>;
        return std::make_unique<LeafOperator<dim,
                                             Gas,
                                             GalerkinKernel<dim, n, Gas, Real>,
                                             GalerkinHanging<dim, Gas, Real>,
                                             Real>>(
          mesh, layout, scheme, gas, boundary);
      });
  }
} // namespace


template <int dim>
std::unique_ptr<GasOperator<dim>>
make_galerkin_operator(const LeafMesh<dim> &mesh,
                       const LeafLayout &layout,
                       const Scheme &scheme,
                       const GasMaterial &material,
                       const Boundary<dim> &boundary)
{
  return std::visit(
    [&](const auto &gas) -> std::unique_ptr<GasOperator<dim>> {
      using Gas = std::decay_t<decltype(gas)>;
      switch (layout.n)
      {
        case 2:
          return make<dim, 2, Gas>(mesh, layout, scheme, gas, boundary);
        case 3:
          return make<dim, 3, Gas>(mesh, layout, scheme, gas, boundary);
        case 4:
          return make<dim, 4, Gas>(mesh, layout, scheme, gas, boundary);
        default:
          throw InputError("Method/Degree: 1, 2 and 3 are available");
      }
    },
    material.model());
}


template std::unique_ptr<GasOperator<1>>
make_galerkin_operator(const LeafMesh<1> &,
                       const LeafLayout &,
                       const Scheme &,
                       const GasMaterial &,
                       const Boundary<1> &);
template std::unique_ptr<GasOperator<2>>
make_galerkin_operator(const LeafMesh<2> &,
                       const LeafLayout &,
                       const Scheme &,
                       const GasMaterial &,
                       const Boundary<2> &);
template std::unique_ptr<GasOperator<3>>
make_galerkin_operator(const LeafMesh<3> &,
                       const LeafLayout &,
                       const Scheme &,
                       const GasMaterial &,
                       const Boundary<3> &);
} // namespace contrecoup::gas
