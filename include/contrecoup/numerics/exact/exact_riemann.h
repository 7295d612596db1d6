// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/exact/riemann_wave.h>

namespace contrecoup
{
/**
 * Exact solution of the Riemann problem between two gases with separate
 * equations of state: two waves (RiemannWave) with equal pressure and velocity
 * at the contact, or with a vacuum in between.
 */
class ExactRiemann
{
public:
  /// @throws NumericsError when the solution requires a shock that the
  /// equation of state does not admit
  ExactRiemann(const RiemannState &left,
               const GasMaterial &left_gas,
               const RiemannState &right,
               const GasMaterial &right_gas);

  /// Both sides of one material, with possibly different products.
  ExactRiemann(const RiemannState &left,
               const RiemannState &right,
               const GasMaterial &gas);

  /// Whether a vacuum forms between the gases.
  bool has_vacuum() const;

  /// Pressure between the waves [Pa]; the lowest one if a vacuum forms.
  double star_pressure() const;

  /// Velocity of the contact [m/s].
  double star_velocity() const;

  /// Densities on both sides of the contact [kg/m^3]; 0 next to a vacuum.
  double left_star_density() const;
  double right_star_density() const;

  /// Speeds of the edges of the waves [m/s], from left to right. Head and tail
  /// of a shock coincide; next to a vacuum, the tail is the vacuum's edge.
  double left_head_speed() const;
  double left_tail_speed() const;
  double right_tail_speed() const;
  double right_head_speed() const;

  /// Solution at x/t = @p speed [m/s]. In a vacuum the velocity is x/t.
  RiemannState value(double speed) const;

private:
  double velocity_excess(double pressure) const;
  void find_star_pressure();

  RiemannWave left_wave_;
  RiemannWave right_wave_;
  bool has_vacuum_ = false;
  double star_pressure_ = 0.;
  double star_velocity_ = 0.;
  RiemannWave::Behind left_star_{0., 0.};
  RiemannWave::Behind right_star_{0., 0.};
  double left_head_ = 0., left_tail_ = 0.;
  double right_tail_ = 0., right_head_ = 0.;
};
} // namespace contrecoup
