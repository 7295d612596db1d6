// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/hex8_full.h>
#include <contrecoup/solid/solid_operator.h>

namespace contrecoup::solid
{
namespace
{
  template <typename Lane>
  double sum_of(const Lane &values)
  {
    double sum = 0.;
    for (unsigned int lane = 0; lane < Lane::size(); ++lane)
      sum += static_cast<double>(values[lane]);
    return sum;
  }
} // namespace


template <typename Real>
template <SolidKinematics kinematics, bool viscoelastic>
void SolidOperator<Real>::add_full_range(const Range &range,
                                         NodeFields<Real> &nodes,
                                         const HexModel<Lane> &model,
                                         TissueEnergies &losses)
{
  double &least = least_dilatations_[range.tissue];
  const bool has_gas = model.law.gas.exists();
  HexModel<Lane> stiffened = model;
  for (unsigned int batch = range.begin; batch < range.end; ++batch)
  {
    if (!batches_.is_awake(batch, nodes))
      continue;
    if (has_gas)
      stiffened.law.bulk = secant_bulk(model.law, nodes, batch);
    const unsigned int *offsets = batches_.offsets(batch, 0);
    HexVectors<Lane> x, u;
    load_corners(nodes.place.data(), offsets, x, u);
    HexState<Lane> state;
    batches_.template load_state<false>(range, batch, state);
    std::array<Symmetric3<Lane>, 8> relaxed;
    if constexpr (viscoelastic)
      for (unsigned int k = 0; k < 48; ++k)
        relaxed[k / 6][k % 6] = batches_.relaxed_of(range, batch)[k];
    HexHeat<Lane> heat;
    const HexVectors<Lane> forces = full_forces<kinematics, viscoelastic>(
      has_gas ? stiffened : model, x, u, state, relaxed, heat);
    batches_.template store_state<false>(range, batch, state);
    if constexpr (viscoelastic)
      for (unsigned int k = 0; k < 48; ++k)
        batches_.relaxed_of(range, batch)[k] = relaxed[k / 6][k % 6];
    for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
      least = std::min(least, double(state.dilatation[lane]));
    subtract_forces(nodes.force.data(), offsets, forces);
    losses.bulk_viscosity += sum_of(heat.bulk_viscosity);
    losses.relaxation += sum_of(heat.relaxation);
  }
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
