// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/embedded_operator.h>
#include <contrecoup/gas/finite_volume/finite_volume_operator.h>
#include <contrecoup/gas/finite_volume/make_finite_volume_operator.h>
#include <contrecoup/gas/finite_volume/mapped_finite_volume_operator.h>

namespace contrecoup::gas
{
template <int dim>
std::unique_ptr<GasOperator<dim>>
make_finite_volume_operator(const LeafMesh<dim> &mesh,
                            const LeafLayout &layout,
                            const Scheme &scheme,
                            const GasMaterial &material,
                            const Boundary<dim> &boundary,
                            const CutLeaves<dim> *cut_leaves)
{
  return std::visit(
    [&](const auto &gas) -> std::unique_ptr<GasOperator<dim>> {
      using Gas = std::decay_t<decltype(gas)>;
      return visit_precision(
        layout.precision,
        [&](const auto real) -> std::unique_ptr<GasOperator<dim>> {
          using Real = kernel_number<dim, std::decay_t<decltype(real)>>;
          if constexpr (dim > 1)
            if (!mesh.coarse_mesh().is_axis_aligned())
              return std::make_unique<
                MappedFiniteVolumeOperator<dim, Gas, Real>>(
                mesh, layout, scheme, gas, boundary);
          if constexpr (dim > 1)
            if (cut_leaves != nullptr)
              return std::make_unique<EmbeddedOperator<dim, Gas, Real>>(
                mesh, layout, scheme, gas, boundary, *cut_leaves);
          return std::make_unique<FiniteVolumeOperator<dim, Gas, Real>>(
            mesh, layout, scheme, gas, boundary);
        });
    },
    material.model());
}


template std::unique_ptr<GasOperator<1>>
make_finite_volume_operator(const LeafMesh<1> &,
                            const LeafLayout &,
                            const Scheme &,
                            const GasMaterial &,
                            const Boundary<1> &,
                            const CutLeaves<1> *);
template std::unique_ptr<GasOperator<2>>
make_finite_volume_operator(const LeafMesh<2> &,
                            const LeafLayout &,
                            const Scheme &,
                            const GasMaterial &,
                            const Boundary<2> &,
                            const CutLeaves<2> *);
template std::unique_ptr<GasOperator<3>>
make_finite_volume_operator(const LeafMesh<3> &,
                            const LeafLayout &,
                            const Scheme &,
                            const GasMaterial &,
                            const Boundary<3> &,
                            const CutLeaves<3> *);
} // namespace contrecoup::gas
