// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/principal_axes.h>
#include <contrecoup/mpm/resampling.h>

#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace contrecoup::mpm
{
namespace
{
  using Vector = dealii::Tensor<1, 3>;
  using State = std::array<double, column::n_state_columns>;

  State state_of(const ParticleBlock &particles, const std::size_t p)
  {
    State state;
    particles.copy_state(p, state.data());
    return state;
  }

  Vector vector_at(const State &state, const unsigned int first)
  {
    return Vector({state[first], state[first + 1], state[first + 2]});
  }

  void set_vector(State &state, const unsigned int first, const Vector &value)
  {
    for (unsigned int d = 0; d < 3; ++d)
      state[first + d] = value[d];
  }

  dealii::Tensor<2, 3> deformation(const State &state)
  {
    dealii::Tensor<2, 3> f;
    for (unsigned int k = 0; k < 9; ++k)
      f[k / 3][k % 3] = state[column::gradient + k] + (k % 4 == 0 ? 1. : 0.);
    return f;
  }

  /// Largest principal stretch, and the unit vector along its deformed
  /// direction.
  std::pair<double, Vector> largest_stretch(const State &state)
  {
    const auto f = deformation(state);
    const auto pairs =
      principal_axes(dealii::symmetrize(dealii::transpose(f) * f));
    const auto along = f * pairs[0].second;
    return {along.norm(), along / along.norm()};
  }

  /// Adds one half of a particle, at @p offset from its position.
  void
  add_half(const State &whole, const Vector &offset, ParticleBlock &particles)
  {
    State half = whole;
    for (const unsigned int c : {unsigned(column::mass),
                                 unsigned(column::volume),
                                 unsigned(column::energy),
                                 unsigned(column::area)})
      half[c] *= 0.5;
    set_vector(
      half, column::position, vector_at(whole, column::position) + offset);
    const Vector undeformed = dealii::invert(deformation(whole)) * offset;
    set_vector(half,
               column::initial_position,
               vector_at(whole, column::initial_position) + undeformed);
    // The surface element keeps its position.
    if (whole[column::area] > 0.)
      set_vector(
        half, column::surface, vector_at(whole, column::surface) - undeformed);
    half[column::level] += 1.;
    particles.append(half.data());
  }

  /// Sums over the particles of a group.
  struct Group
  {
    double mass = 0., volume = 0., kinetic = 0., inertia = 0.;
    Vector centre, velocity, spin;
    dealii::SymmetricTensor<2, 3> moments; ///< mass times x x^T
    State mean{}; ///< volume-weighted; energy is the sum

    explicit Group(const std::vector<State> &states)
    {
      for (const State &one : states)
      {
        mass += one[column::mass];
        volume += one[column::volume];
        centre += one[column::mass] * vector_at(one, column::position);
        velocity += one[column::mass] * vector_at(one, column::velocity);
        for (unsigned int c = 0; c < column::n_state_columns; ++c)
          mean[c] +=
            c == column::energy ? one[c] : one[column::volume] * one[c];
      }
      centre /= mass;
      velocity /= mass;
      for (unsigned int c = 0; c < column::n_state_columns; ++c)
        mean[c] /= c == column::energy ? 1. : volume;
      for (const State &one : states)
      {
        for (const unsigned int c :
             {unsigned(column::peak_strain), unsigned(column::peak_pressure)})
          mean[c] = std::max(mean[c], one[c]);
        mean[column::lowest_pressure] =
          std::min(mean[column::lowest_pressure], one[column::lowest_pressure]);
      }
      for (const State &one : states)
      {
        const Vector x = vector_at(one, column::position) - centre,
                     v = vector_at(one, column::velocity) - velocity;
        spin += one[column::mass] * dealii::cross_product_3d(x, v);
        kinetic += 0.5 * one[column::mass] * v.norm_square();
        inertia += one[column::mass] * x.norm_square();
        moments += one[column::mass] * dealii::symmetrize(outer_product(x, x));
      }
    }

    /// Vector from the centre of mass to one of the two particles: normal to
    /// the angular momentum, with the root mean square distance as length.
    Vector arm() const
    {
      const auto axes = principal_axes(moments);
      Vector best;
      for (const auto &axis : axes)
      {
        Vector across = axis.second;
        if (spin.norm() > 0.)
          across -= (across * spin) / spin.norm_square() * spin;
        // The first principal axis, which is the longest one, unless it is
        // parallel to the angular momentum.
        if (across.norm() > std::max(0.5, best.norm()))
          best = across;
        if (best.norm() > 0.5)
          break;
      }
      return std::sqrt(inertia / mass) / best.norm() * best;
    }
  };

  void add_pair(const Group &group, ParticleBlock &particles)
  {
    const Vector arm = group.arm();
    const Vector turning = dealii::cross_product_3d(group.spin, arm) /
                           (group.mass * arm.norm_square());
    const double heat =
      group.kinetic - 0.5 * group.mass * turning.norm_square();
    for (const double sign : {1., -1.})
    {
      State half = group.mean;
      half[column::mass] = 0.5 * group.mass;
      half[column::volume] = 0.5 * group.volume;
      half[column::energy] = 0.5 * (group.mean[column::energy] + heat);
      half[column::level] = std::floor(group.mean[column::level]);
      set_vector(half, column::position, group.centre + sign * arm);
      set_vector(half, column::velocity, group.velocity + sign * turning);
      particles.append(half.data());
    }
  }

  bool may_merge(const ParticleBlock &particles, const std::size_t p)
  {
    return particles[column::probe][p] == 0. &&
           !(particles[column::area][p] > 0.);
  }

  /// Indices of the particles in each cell of a tile.
  std::map<std::array<int, 3>, std::vector<std::size_t>>
  by_cell(const TileGrid &grid, const ParticleBlock &particles)
  {
    std::map<std::array<int, 3>, std::vector<std::size_t>> cells;
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const dealii::Point<3> place(particles[column::position][p],
                                   particles[column::position + 1][p],
                                   particles[column::position + 2][p]);
      if (may_merge(particles, p))
        cells[grid.cell_at(place)].push_back(p);
    }
    return cells;
  }

  /// The particles nearest to the first one, including it.
  std::vector<std::size_t> nearest(const ParticleBlock &particles,
                                   std::vector<std::size_t> numbers,
                                   const std::size_t n)
  {
    const auto distance = [&](const std::size_t p) {
      double sum = 0.;
      for (unsigned int d = 0; d < 3; ++d)
        sum += std::pow(particles[column::position + d][p] -
                          particles[column::position + d][numbers[0]],
                        2);
      return sum;
    };
    std::vector<std::pair<double, std::size_t>> order;
    for (const std::size_t p : numbers)
      order.emplace_back(distance(p), p);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < n; ++i)
      result.push_back(order[i].second);
    return result;
  }
} // namespace


std::size_t split_stretched(const double stretch, ParticleBlock &particles)
{
  std::size_t n = 0;
  for (std::size_t p = particles.size(); p-- > 0;)
  {
    // A cheap upper bound of the largest stretch.
    double square = 0.;
    for (unsigned int k = 0; k < 9; ++k)
      square += std::pow(
        particles[column::gradient + k][p] + (k % 4 == 0 ? 1. : 0.), 2);
    const double splits = std::ldexp(1., int(particles[column::level][p]));
    if (square < std::pow(stretch * splits, 2))
      continue;
    const State whole = state_of(particles, p);
    const auto [largest, direction] = largest_stretch(whole);
    if (largest < stretch * splits)
      continue;
    const double edge = std::cbrt(whole[column::volume] * splits);
    const Vector offset = 0.25 * largest / splits * edge * direction;
    particles.remove(p);
    add_half(whole, offset, particles);
    add_half(whole, -offset, particles);
    // The probe follows only one of the halves.
    particles[column::probe][particles.size() - 1] = 0.;
    ++n;
  }
  return n;
}


std::size_t merge_crowded(const std::size_t max_per_cell,
                          const TileGrid &grid,
                          ParticleBlock &particles)
{
  constexpr std::size_t n_merged = 4;
  std::vector<std::size_t> gone;
  std::vector<Group> groups;
  for (auto &[cell, numbers] : by_cell(grid, particles))
    for (std::size_t n = numbers.size();
         n > max_per_cell && numbers.size() >= n_merged;
         n -= n_merged - 2)
    {
      const auto chosen = nearest(particles, numbers, n_merged);
      std::vector<State> states;
      for (const std::size_t p : chosen)
      {
        states.push_back(state_of(particles, p));
        numbers.erase(std::find(numbers.begin(), numbers.end(), p));
      }
      groups.emplace_back(states);
      gone.insert(gone.end(), chosen.begin(), chosen.end());
    }
  std::sort(gone.rbegin(), gone.rend());
  for (const std::size_t p : gone)
    particles.remove(p);
  for (const Group &group : groups)
    add_pair(group, particles);
  return gone.size() - 2 * groups.size();
}
} // namespace contrecoup::mpm
