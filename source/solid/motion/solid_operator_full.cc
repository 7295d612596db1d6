// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_full.h>
#include <contrecoup/solid/motion/batch_loop.h>

namespace contrecoup::solid
{
template <typename Real>
template <SolidKinematics kinematics, bool viscoelastic>
void SolidOperator<Real>::add_full_range(const Range &range,
                                         NodeFields<Real> &nodes,
                                         const HexModel<Lane> &model,
                                         TissueEnergies &losses)
{
  // Each integration point has its own relaxed strains.
  add_batches<false>(
    range,
    nodes,
    model,
    losses,
    [&](const HexModel<Lane> &model_now,
        const unsigned int batch,
        const HexVectors<Lane> &x,
        const HexVectors<Lane> &u,
        HexState<Lane> &state,
        HexDissipation<Lane> &dissipation) {
      std::array<Symmetric3<Lane>, 8> relaxed;
      if constexpr (viscoelastic)
        for (unsigned int k = 0; k < 48; ++k)
          relaxed[k / 6][k % 6] = batches_.relaxed_of(range, batch)[k];
      const HexVectors<Lane> forces = full_forces<kinematics, viscoelastic>(
        model_now, x, u, state, relaxed, dissipation);
      if constexpr (viscoelastic)
        for (unsigned int k = 0; k < 48; ++k)
          batches_.relaxed_of(range, batch)[k] = relaxed[k / 6][k % 6];
      return forces;
    });
}


template <typename Real>
void SolidOperator<Real>::add_full_forces(NodeFields<Real> &nodes,
                                          const StepTimes &times)
{
  const auto add = [&](const auto kinematics) {
    constexpr SolidKinematics kind = decltype(kinematics)::value;
    for (const Range &range : batches_.ranges())
    {
      const HexModel<Lane> model = this->model(materials_[range.tissue], times);
      TissueEnergies &losses = losses_[range.tissue];
      if (range.viscoelastic)
        add_full_range<kind, true>(range, nodes, model, losses);
      else
        add_full_range<kind, false>(range, nodes, model, losses);
    }
  };
  using Kind = SolidKinematics;
  switch (options_.kinematics)
  {
    case Kind::small_strain:
      return add(std::integral_constant<Kind, Kind::small_strain>());
    case Kind::finite_rotation:
      return add(std::integral_constant<Kind, Kind::finite_rotation>());
    default:
      return add(std::integral_constant<Kind, Kind::neo_hookean>());
  }
}


template <typename Real>
void SolidOperator<Real>::add_full_linear_forces(NodeFields<Real> &nodes)
{
  TissueEnergies unused;
  for (const Range &range : batches_.ranges())
    add_full_range<SolidKinematics::small_strain, false>(
      range, nodes, linear_model(materials_[range.tissue]), unused);
}


template class SolidOperator<double>;
template class SolidOperator<float>;
} // namespace contrecoup::solid
