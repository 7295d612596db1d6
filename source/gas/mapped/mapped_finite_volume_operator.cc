// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/mapped/mapped_finite_volume_operator.h>
#include <contrecoup/gas/stage/further_makers.h>

namespace contrecoup::gas
{
namespace
{
  template <int dim, typename Real>
  std::unique_ptr<GasOperator<dim, Real>>
  make_mapped_operator(const OperatorContext<dim> &context,
                       const GasMaterial &material)
  {
    return std::visit(
      [&](const auto &gas) -> std::unique_ptr<GasOperator<dim, Real>> {
        using Gas = std::decay_t<decltype(gas)>;
        return std::make_unique<MappedFiniteVolumeOperator<dim, Gas, Real>>(
          context, gas);
      },
      material.model());
  }
} // namespace


// A line has boxes alone.
const OperatorMakers contrecoup_mapped_makers = {
  nullptr,
  make_mapped_operator<2, double>,
  make_mapped_operator<3, double>,
  make_mapped_operator<3, float>};
} // namespace contrecoup::gas
