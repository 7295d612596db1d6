// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/mpm/particle_motion.h>

#include <cmath>
#include <limits>

namespace contrecoup::mpm
{
namespace
{
  using Lane = Lanes<double>;
  constexpr std::size_t width = n_lanes<double>;

  double sum_of_lanes(const Lane &value)
  {
    double sum = 0.;
    for (std::size_t lane = 0; lane < width; ++lane)
      sum += value[lane];
    return sum;
  }

  /// Columns of one particle, or of one particle in each lane.
  template <typename Number>
  struct Columns
  {
    ParticleBlock &particles;
    std::size_t p;

    DEAL_II_ALWAYS_INLINE Number operator[](const unsigned int column) const
    {
      const double *const value = particles[column] + p;
      if constexpr (std::is_same_v<Number, double>)
        return *value;
      else
      {
        Number lanes;
        lanes.load(value);
        return lanes;
      }
    }

    DEAL_II_ALWAYS_INLINE void set(const unsigned int column,
                                   const Number &number) const
    {
      double *const value = particles[column] + p;
      if constexpr (std::is_same_v<Number, double>)
        *value = number;
      else
        number.store(value);
    }
  };

  template <typename Number>
  inline DEAL_II_ALWAYS_INLINE void gain(const double step,
                                         const double grid_velocity_fraction,
                                         const bool is_smoothed,
                                         const Columns<Number> &columns,
                                         Number &work,
                                         Number &kinetic)
  {
    const Number half_mass = columns[column::mass] * 0.5;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const Number velocity_change = columns[column::velocity_change + d],
                   position_change = columns[column::position_change + d],
                   before = columns[column::velocity + d];
      const Number kept = before + velocity_change;
      const Number after =
        kept + (position_change / step - kept) * grid_velocity_fraction;
      work += columns[column::force + d] *
              (position_change - 0.5 * step * velocity_change);
      kinetic += half_mass * (after - before) * (after + before);
      columns.set(column::velocity + d, after);
    }
    // Rows of the symmetric tensor stored as xx, yy, zz, xy, yz, zx.
    constexpr unsigned int entry[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};
    Number power(0.);
    for (unsigned int k = 0; k < 9; ++k)
    {
      const Number rate = columns[column::mean_rate + k];
      power += columns[column::stress + entry[k]] * rate;
      work += columns[column::moment + entry[k]] * rate * step;
    }
    if (is_smoothed)
      power -= (columns[column::dilatation] + 1.) * columns[column::smoothed] *
               (columns[column::mean_rate] + columns[column::mean_rate + 4] +
                columns[column::mean_rate + 8]);
    columns.set(column::energy,
                columns[column::energy] +
                  columns[column::volume] * power * step);
  }
} // namespace


EnergyGains update_velocities(const double step,
                              const double grid_velocity_fraction,
                              const bool is_smoothed,
                              ParticleBlock &particles)
{
  Lane work(0.), kinetic(0.);
  double last_work = 0., last_kinetic = 0.;
  std::size_t p = 0;
  for (; p + width <= particles.size(); p += width)
    gain<Lane>(
      step, grid_velocity_fraction, is_smoothed, {particles, p}, work, kinetic);
  for (; p < particles.size(); ++p)
    gain<double>(step,
                 grid_velocity_fraction,
                 is_smoothed,
                 {particles, p},
                 last_work,
                 last_kinetic);
  return {sum_of_lanes(work) + last_work, sum_of_lanes(kinetic) + last_kinetic};
}


void advance_positions(ParticleBlock &particles)
{
  for (unsigned int d = 0; d < 3; ++d)
  {
    double *const x = particles[column::position + d];
    const double *const position_change =
      particles[column::position_change + d];
    for (std::size_t p = 0; p < particles.size(); ++p)
      x[p] += position_change[p];
  }
}


double largest_rate(const ParticleBlock &particles)
{
  double largest = 0., not_finite = 0.;
  for (unsigned int k = 0; k < 9; ++k)
  {
    const double *const rate = particles[column::mean_rate + k];
    Lane most(0.), check(0.);
    std::size_t p = 0;
    for (; p + width <= particles.size(); p += width)
    {
      Lane value;
      value.load(rate + p);
      most = std::max(most, std::abs(value));
      check += value * 0.; // NaN unless the value is finite
    }
    largest = std::max(largest, largest_lane(most));
    not_finite += sum_of_lanes(check);
    for (; p < particles.size(); ++p)
    {
      largest = std::max(largest, std::abs(rate[p]));
      not_finite += rate[p] * 0.;
    }
  }
  return not_finite == 0. ? largest : std::numeric_limits<double>::infinity();
}


bool are_inside(const ParticleBlock &particles,
                const double *const origin,
                const double cell_size,
                const int *const lower,
                const int *const upper)
{
  std::size_t n_inside = 0;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double *const x = particles[column::position + d];
    const double from = lower[d], to = upper[d];
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const double coordinate = (x[p] - origin[d]) / cell_size;
      n_inside += (coordinate >= from) & (coordinate < to);
    }
  }
  return n_inside == 3 * particles.size();
}
} // namespace contrecoup::mpm
