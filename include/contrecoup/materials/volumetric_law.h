// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/gas_filled.h>
#include <contrecoup/materials/solid_material.h>

/**
 * @file
 * Constants of a solid, and its pressure as a function of the volume alone.
 */

namespace contrecoup
{
/// Material constants and the data of a time step.
template <typename Number>
struct SolidLaw
{
  Number bulk;           ///< K [Pa]
  Number twice_shear;    ///< 2 G_0 [Pa]
  Number twice_relaxing; ///< 2 G_1 [Pa]
  Number decay_before{}; ///< exp(-t / tau) from the stored strain to now
  Number decay_after{};  ///< exp(-dt / (2 tau)) of the next step
  /// 1 - exp(-t / tau) for the time t between both: the fraction of a strain
  /// that relaxes.
  Number relaxing_fraction{};
  /// Energy that this dissipates, over 2 G_1 times the squared distance of the
  /// relaxed strain from the strain before.
  Number lost_fraction{};
  /// Replaces the volumetric stress K (J - 1). Elements use the secant modulus
  /// as K instead, which avoids library calls in their loops.
  GasFilling gas;
  /// Tension [Pa] and dilatation J - 1 at which cavities open.
  Number largest_tension = Number(no_cavitation);
  Number vapour_dilatation = Number(no_cavitation);
};

/// Cuts the stress -p off at the largest tension: beyond, cavities grow.
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number bounded_tension(const SolidLaw<Number> &law,
                                                    const Number &stress)
{
  using std::min;
  return min(law.largest_tension, stress);
}

/// -p at a dilatation J - 1 [Pa].
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Number
volumetric_stress(const SolidLaw<Number> &law, const Number &dilatation)
{
  const auto of_gas = [&](const double x) { return law.gas.stress(x); };
  return bounded_tension(law,
                         law.bulk * (law.gas.exists()
                                       ? apply_to_lanes(of_gas, dilatation)
                                       : dilatation));
}

/// Energy of volumetric strain [J/m^3]; cavities store work against ambient
/// pressure.
template <typename Number>
inline Number volumetric_energy(const SolidLaw<Number> &law,
                                const Number &dilatation)
{
  using std::max;
  using std::min;
  const auto of_gas = [&](const double x) { return law.gas.energy(x); };
  const Number strain = min(law.vapour_dilatation, dilatation);
  return law.bulk * (law.gas.exists() ? apply_to_lanes(of_gas, strain)
                                      : Number(0.5) * strain * strain) +
         law.largest_tension *
           max(Number(), dilatation - law.vapour_dilatation);
}
} // namespace contrecoup
