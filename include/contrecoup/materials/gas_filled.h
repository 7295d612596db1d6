// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lane_math.h>

#include <cmath>
#include <limits>

/**
 * @file
 * Pressure of tissue that contains gas, such as the lung: the gas is
 * compressed as p v^gamma = const, the rest is incompressible (Wood 1941, for
 * bubbles in a much stiffer liquid). With the gas fraction phi of the
 * undeformed volume and the relative change s = (J - 1) / phi of the gas
 * volume,
 *   p = K phi / gamma ((1 + s)^-gamma - 1)
 * is the pressure above the ambient pressure K phi / gamma. K is the bulk
 * modulus at small strains, and p never falls below vacuum. Under compression
 * -dp/dJ grows until it reaches that of the tissue without gas, and is
 * constant beyond.
 */

namespace contrecoup
{
/// Gas in a solid. All stresses are relative to K.
class GasFilling
{
public:
  /// No gas.
  GasFilling() = default;

  /**
   * @param gas_fraction gas fraction phi of the undeformed volume, positive
   * @param exponent gamma: 1 isothermal, 1.4 adiabatic
   * @param max_stiffness upper bound of -dp/dJ over K, at least 1
   */
  GasFilling(const double gas_fraction,
             const double exponent,
             const double max_stiffness)
    : gas_fraction_(gas_fraction)
    , exponent_(exponent)
    , max_stiffness_(max_stiffness)
    , constant_stiffness_limit_(
        gas_fraction * std::expm1(-std::log(max_stiffness) / (exponent + 1.)))
    , stress_at_limit_(gas_stress(constant_stiffness_limit_))
    , energy_at_limit_(gas_energy(constant_stiffness_limit_))
  {}

  bool exists() const
  {
    return gas_fraction_ > 0.;
  }

  double gas_fraction() const
  {
    return gas_fraction_;
  }

  double exponent() const
  {
    return exponent_;
  }

  double max_stiffness() const
  {
    return max_stiffness_;
  }

  /// -p / K at a dilatation J - 1.
  double stress(const double dilatation) const
  {
    return dilatation < constant_stiffness_limit_
             ? stress_at_limit_ +
                 max_stiffness_ * (dilatation - constant_stiffness_limit_)
             : gas_stress(dilatation);
  }

  /// -p / K divided by the dilatation.
  double secant(const double dilatation) const
  {
    return dilatation == 0. ? 1. : stress(dilatation) / dilatation;
  }

  /// Integral of stress() from 0 to a dilatation.
  double energy(const double dilatation) const
  {
    const double excess = dilatation - constant_stiffness_limit_;
    return dilatation < constant_stiffness_limit_
             ? energy_at_limit_ +
                 excess * (stress_at_limit_ + 0.5 * max_stiffness_ * excess)
             : gas_energy(dilatation);
  }

  /// The dilatation at which stress() is @p stress, at least 0; infinite where
  /// the gas never bears that much.
  double dilatation_at(const double stress) const
  {
    const double rest = 1. - exponent_ / gas_fraction_ * stress;
    return rest > 0. ? gas_fraction_ * std::expm1(-std::log(rest) / exponent_)
                     : std::numeric_limits<double>::infinity();
  }

  /// -dp/dJ / K.
  double stiffness(const double dilatation) const
  {
    return dilatation < constant_stiffness_limit_
             ? max_stiffness_
             : std::exp(-(exponent_ + 1.) *
                        std::log1p(dilatation / gas_fraction_));
  }

private:
  double gas_stress(const double dilatation) const
  {
    return -gas_fraction_ / exponent_ *
           std::expm1(-exponent_ * std::log1p(dilatation / gas_fraction_));
  }

  double gas_energy(const double dilatation) const
  {
    const double logarithm = std::log1p(dilatation / gas_fraction_);
    const double power = exponent_ - 1.;
    const double logarithmic_mean = std::abs(power) < 1e-6
                                      ? logarithm
                                      : -std::expm1(-power * logarithm) / power;
    return gas_fraction_ / exponent_ *
           (dilatation - gas_fraction_ * logarithmic_mean);
  }

  double gas_fraction_ = 0.;
  double exponent_ = 1.;
  double max_stiffness_ = 1.;
  /// Dilatation below which stiffness is constant.
  double constant_stiffness_limit_ = 0.;
  double stress_at_limit_ = 0.;
  double energy_at_limit_ = 0.;
};

/// Applies @p function (of double) to a number, or to each lane.
template <typename Function>
inline double apply_to_lanes(const Function &function, const double x)
{
  return function(x);
}

template <typename Function>
inline float apply_to_lanes(const Function &function, const float x)
{
  return static_cast<float>(function(x));
}

template <typename Function, typename Scalar, std::size_t width>
inline LaneGroup<Scalar, width>
apply_to_lanes(const Function &function, const LaneGroup<Scalar, width> &x)
{
  LaneGroup<Scalar, width> result;
  for (std::size_t lane = 0; lane < width; ++lane)
    result[lane] = static_cast<Scalar>(function(double(x[lane])));
  return result;
}
} // namespace contrecoup
