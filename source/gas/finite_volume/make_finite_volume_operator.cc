// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/finite_volume/embedded_operator.h>
#include <contrecoup/gas/finite_volume/finite_volume_operator.h>
#include <contrecoup/gas/finite_volume/make_finite_volume_operator.h>
#include <contrecoup/gas/stage/further_makers.h>

namespace contrecoup::gas
{
template <int dim, typename Real>
std::unique_ptr<GasOperator<dim, Real>>
make_finite_volume_operator(const OperatorContext<dim> &context,
                            const GasMaterial &material)
{
  if (!context.mesh.coarse_mesh().is_axis_aligned())
    return std::get<OperatorMaker<dim, Real>>(further_makers(
      "mapped", "A mesh of cells that are no boxes"))(context, material);
  return std::visit(
    [&](const auto &gas) -> std::unique_ptr<GasOperator<dim, Real>> {
      using Gas = std::decay_t<decltype(gas)>;
      if constexpr (dim > 1)
        if (context.cut_leaves != nullptr)
          return std::make_unique<EmbeddedOperator<dim, Gas, Real>>(context,
                                                                    gas);
      return std::make_unique<FiniteVolumeOperator<dim, Gas, Real>>(context,
                                                                    gas);
    },
    material.model());
}


#define CONTRECOUP_INSTANTIATE(dim, Real)                   \
  template std::unique_ptr<GasOperator<dim, Real>>          \
  make_finite_volume_operator(const OperatorContext<dim> &, \
                              const GasMaterial &)

CONTRECOUP_INSTANTIATE(1, double);
CONTRECOUP_INSTANTIATE(2, double);
CONTRECOUP_INSTANTIATE(3, double);
CONTRECOUP_INSTANTIATE(3, float);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
