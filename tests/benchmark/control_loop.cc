// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include "control_loop.h"

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace
{
  using Values = std::array<double, 5>;
  constexpr double gamma = 1.4;

  double energy_density(const Values &p)
  {
    return p[4] / (gamma - 1.) +
           0.5 * p[0] * (p[1] * p[1] + p[2] * p[2] + p[3] * p[3]);
  }

  /// Monotonised central difference (van Leer 1977).
  double limited_slope(const double backward, const double forward)
  {
    if (backward * forward <= 0.)
      return 0.;
    const double size =
      std::min(0.5 * std::abs(backward + forward),
               2. * std::min(std::abs(backward), std::abs(forward)));
    return backward > 0. ? size : -size;
  }

  Values euler_flux(const Values &p)
  {
    const double mass = p[0] * p[1];
    return {{mass,
             mass * p[1] + p[4],
             mass * p[2],
             mass * p[3],
             (energy_density(p) + p[4]) * p[1]}};
  }

  /// HLLC (Toro, Spruce and Speares 1994), of primitive values whose first
  /// velocity component is normal to the face.
  Values hllc_flux(const Values &left, const Values &right)
  {
    const double left_sound = std::sqrt(gamma * left[4] / left[0]);
    const double right_sound = std::sqrt(gamma * right[4] / right[0]);
    const double slowest =
      std::min(left[1] - left_sound, right[1] - right_sound);
    const double fastest =
      std::max(left[1] + left_sound, right[1] + right_sound);
    if (slowest >= 0.)
      return euler_flux(left);
    if (fastest <= 0.)
      return euler_flux(right);
    const double left_rate = left[0] * (slowest - left[1]);
    const double right_rate = right[0] * (fastest - right[1]);
    const double contact =
      (right[4] - left[4] + left[1] * left_rate - right[1] * right_rate) /
      (left_rate - right_rate);
    const Values &side = contact >= 0. ? left : right;
    const double bow = contact >= 0. ? slowest : fastest;
    const double density = side[0] * (bow - side[1]) / (bow - contact);
    const double energy = energy_density(side);
    const Values middle = {
      {density,
       density * contact,
       density * side[2],
       density * side[3],
       density * (energy / side[0] +
                  (contact - side[1]) *
                    (contact + side[4] / (side[0] * (bow - side[1]))))}};
    const Values own = {{side[0],
                         side[0] * side[1],
                         side[0] * side[2],
                         side[0] * side[3],
                         energy}};
    Values flux = euler_flux(side);
    for (unsigned int c = 0; c < 5; ++c)
      flux[c] += bow * (middle[c] - own[c]);
    return flux;
  }

  /// Component that stands at place @p c in the frame of a direction.
  unsigned int rotated(const unsigned int c, const unsigned int direction)
  {
    return c == 0 || c == 4 ? c : 1 + (direction + c - 1) % 3;
  }
} // namespace


ControlLoop::ControlLoop(const unsigned int n)
  : n_(n)
  , line_(n + 4)
  , left_(n + 1)
  , right_(n + 1)
  , flux_(n + 1)
{
  const std::size_t size = std::size_t(n) * n * n;
  for (Fields *fields : {&conserved_, &primitive_, &rate_})
    for (auto &field : *fields)
      field.assign(size, 0.);
  const double wave = 2. * std::acos(-1.) / n;
  for (std::size_t i = 0; i < size; ++i)
  {
    const double density =
      1. + 0.1 * std::sin(wave * (i % n)) * std::cos(wave * (i / n % n));
    const Values p = {{density, 30., 20., 0., 1e5}};
    for (unsigned int d = 0; d < 3; ++d)
      conserved_[1 + d][i] = density * p[1 + d];
    conserved_[0][i] = density;
    conserved_[4][i] = energy_density(p);
  }
}


void ControlLoop::stage()
{
  compute_primitive();
  for (auto &rate : rate_)
    std::fill(rate.begin(), rate.end(), 0.);
  const std::size_t n = n_;
  for (unsigned int direction = 0; direction < 3; ++direction)
  {
    const std::size_t a = stride((direction + 1) % 3);
    const std::size_t b = stride((direction + 2) % 3);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
      {
        const std::size_t first = std::min(a, b) * j + std::max(a, b) * i;
        sweep_line(direction, first);
        add_line(direction, first);
      }
  }
  // Cells of edge 1/n; at a CFL number of 0.1.
  const double step = 0.1 / n / 500.;
  for (unsigned int c = 0; c < n_components; ++c)
    for (std::size_t i = 0; i < n * n * n; ++i)
      conserved_[c][i] += step * rate_[c][i];
}


void ControlLoop::compute_primitive()
{
  for (std::size_t i = 0; i < conserved_[0].size(); ++i)
  {
    const double inverse = 1. / conserved_[0][i];
    double kinetic = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      primitive_[1 + d][i] = conserved_[1 + d][i] * inverse;
      kinetic += 0.5 * primitive_[1 + d][i] * conserved_[1 + d][i];
    }
    primitive_[0][i] = conserved_[0][i];
    primitive_[4][i] = (gamma - 1.) * (conserved_[4][i] - kinetic);
  }
}


void ControlLoop::sweep_line(const unsigned int direction,
                             const std::size_t first)
{
  const std::size_t step = stride(direction);
  for (unsigned int c = 0; c < n_components; ++c)
  {
    const double *values = primitive_[rotated(c, direction)].data() + first;
    for (unsigned int i = 0; i < n_; ++i)
      line_[i + 2][c] = values[i * step];
  }
  line_[0] = line_[n_];
  line_[1] = line_[n_ + 1];
  line_[n_ + 2] = line_[2];
  line_[n_ + 3] = line_[3];
  for (unsigned int i = 0; i < n_ + 2; ++i)
    for (unsigned int c = 0; c < n_components; ++c)
    {
      const double value = line_[i + 1][c];
      const double half =
        0.5 * limited_slope(value - line_[i][c], line_[i + 2][c] - value);
      if (i > 0)
        right_[i - 1][c] = value - half;
      if (i <= n_)
        left_[i][c] = value + half;
    }
  for (unsigned int f = 0; f <= n_; ++f)
    flux_[f] = hllc_flux(left_[f], right_[f]);
}


void ControlLoop::add_line(const unsigned int direction,
                           const std::size_t first)
{
  const std::size_t step = stride(direction);
  for (unsigned int c = 0; c < n_components; ++c)
  {
    double *rate = rate_[rotated(c, direction)].data() + first;
    for (unsigned int i = 0; i < n_; ++i)
      rate[i * step] += (flux_[i][c] - flux_[i + 1][c]) * n_;
  }
}


double ControlLoop::mean_energy() const
{
  double sum = 0.;
  for (const double energy : conserved_[4])
    sum += energy;
  return sum / n_cells();
}
} // namespace contrecoup
