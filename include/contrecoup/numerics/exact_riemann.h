// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/riemann_wave.h>

namespace contrecoup
{
/**
 * Exact solution of the Riemann problem between two gases, each with an
 * equation of state of its own: two waves (RiemannWave) with equal pressure
 * and velocity at the contact between them, or with a vacuum between them.
 */
class ExactRiemann
{
public:
  /// @throws NumericsError when a shock would be needed that the equation of
  /// state does not have.
  ExactRiemann(const RiemannState &left,
               const GasMaterial &left_gas,
               const RiemannState &right,
               const GasMaterial &right_gas);

  /// Both sides of one material (which may differ by their products).
  ExactRiemann(const RiemannState &left,
               const RiemannState &right,
               const GasMaterial &gas);

  /// Whether the gases part and leave a vacuum between them.
  bool has_vacuum() const;

  /// Pressure between the waves [Pa]; in a vacuum the lowest one.
  double star_pressure() const;

  /// Velocity of the contact [m/s].
  double star_velocity() const;

  /// Densities beside the contact [kg/m^3]; 0 beside a vacuum.
  double left_star_density() const;
  double right_star_density() const;

  /// Speeds of the waves' edges [m/s], from left to right. Head and tail of a
  /// shock are the same; beside a vacuum the tails are its edges.
  double left_head_speed() const;
  double left_tail_speed() const;
  double right_tail_speed() const;
  double right_head_speed() const;

  /// The solution on the ray x/t = @p speed [m/s]. In a vacuum the velocity is
  /// the ray's own.
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
