// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/numerics/exact/exact_riemann.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
ExactRiemann::ExactRiemann(const RiemannState &left,
                           const RiemannState &right,
                           const GasMaterial &gas)
  : ExactRiemann(left, gas, right, gas)
{}


ExactRiemann::ExactRiemann(const RiemannState &left,
                           const GasMaterial &left_gas,
                           const RiemannState &right,
                           const GasMaterial &right_gas)
  : left_wave_(left, left_gas, RiemannWave::Direction::left)
  , right_wave_(right, right_gas, RiemannWave::Direction::right)
{
  has_vacuum_ = left_wave_.escape_velocity() <= right_wave_.escape_velocity();
  if (has_vacuum_)
  {
    star_pressure_ =
      std::max(left_wave_.lowest_pressure(), right_wave_.lowest_pressure());
    left_tail_ = left_wave_.escape_velocity();
    right_tail_ = right_wave_.escape_velocity();
    star_velocity_ = 0.5 * (left_tail_ + right_tail_);
    left_head_ = left_wave_.head_speed(left_wave_.lowest_pressure());
    right_head_ = right_wave_.head_speed(right_wave_.lowest_pressure());
    return;
  }

  find_star_pressure();
  left_star_ = left_wave_.behind(star_pressure_);
  right_star_ = right_wave_.behind(star_pressure_);
  star_velocity_ = 0.5 * (left_star_.velocity + right_star_.velocity);
  left_head_ = left_wave_.head_speed(star_pressure_);
  left_tail_ = left_wave_.tail_speed(star_pressure_);
  right_tail_ = right_wave_.tail_speed(star_pressure_);
  right_head_ = right_wave_.head_speed(star_pressure_);
}


double ExactRiemann::velocity_excess(const double pressure) const
{
  return left_wave_.behind(pressure).velocity -
         right_wave_.behind(pressure).velocity;
}


void ExactRiemann::find_star_pressure()
{
  // The excess decreases with pressure. Search in the logarithm of pressure
  // above the lowest one, starting from the given pressures.
  const double floor =
    std::max(left_wave_.lowest_pressure(), right_wave_.lowest_pressure());
  const auto excess = [&](const double logarithm) {
    return velocity_excess(floor + std::exp(logarithm));
  };
  const double p_left = left_wave_.ahead().pressure;
  const double p_right = right_wave_.ahead().pressure;
  if (p_left == p_right &&
      left_wave_.ahead().velocity == right_wave_.ahead().velocity)
  {
    star_pressure_ = p_left;
    return;
  }

  constexpr double stride = 1.;
  constexpr unsigned int most_strides = 500;
  double low = std::log(std::min(p_left, p_right) - floor);
  double high = std::log(std::max(p_left, p_right) - floor);
  unsigned int n = 0;
  for (; excess(low) < 0. && n < most_strides; ++n)
    low -= stride;
  for (; excess(high) > 0. && n < most_strides; ++n)
    high += stride;
  if (n == most_strides)
    throw NumericsError("The Riemann problem has no solution between vacuum "
                        "and the highest pressure that a shock can make");

  std::uintmax_t iterations = 200;
  const double f_low = excess(low), f_high = excess(high);
  double solution = f_low == 0. ? low : high;
  if (f_low > 0. && f_high < 0.)
  {
    const auto bracket = boost::math::tools::toms748_solve(
      excess,
      low,
      high,
      f_low,
      f_high,
      boost::math::tools::eps_tolerance<double>(52),
      iterations);
    solution = 0.5 * (bracket.first + bracket.second);
  }
  star_pressure_ = floor + std::exp(solution);
}


bool ExactRiemann::has_vacuum() const
{
  return has_vacuum_;
}


double ExactRiemann::star_pressure() const
{
  return star_pressure_;
}


double ExactRiemann::star_velocity() const
{
  return star_velocity_;
}


double ExactRiemann::left_star_density() const
{
  return left_star_.density;
}


double ExactRiemann::right_star_density() const
{
  return right_star_.density;
}


double ExactRiemann::left_head_speed() const
{
  return left_head_;
}


double ExactRiemann::left_tail_speed() const
{
  return left_tail_;
}


double ExactRiemann::right_tail_speed() const
{
  return right_tail_;
}


double ExactRiemann::right_head_speed() const
{
  return right_head_;
}


RiemannState ExactRiemann::value(const double speed) const
{
  if (has_vacuum_ && speed > left_tail_ && speed < right_tail_)
    return {0.,
            speed,
            star_pressure_,
            speed < star_velocity_ ? left_wave_.ahead().products
                                   : right_wave_.ahead().products};

  const bool is_left = speed < star_velocity_;
  const RiemannWave &wave = is_left ? left_wave_ : right_wave_;
  const double sign = is_left ? -1. : 1.;
  if (sign * speed >= sign * (is_left ? left_head_ : right_head_))
    return wave.ahead();
  if (sign * speed > sign * (is_left ? left_tail_ : right_tail_))
    return wave.in_fan(speed);
  return {is_left ? left_star_.density : right_star_.density,
          star_velocity_,
          star_pressure_,
          wave.ahead().products};
}
} // namespace contrecoup
