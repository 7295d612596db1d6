// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>
#include <vector>

namespace contrecoup
{
/**
 * Control for the gas kernels: the second-order finite-volume
 * scheme (MC limiter, HLLC flux, ideal gas, Runge-Kutta stages) on a periodic
 * cube of n^3 cells, as one writes it first: one array of doubles per
 * conserved quantity, one line of cells after the other, no SIMD lanes by hand.
 */
class ControlLoop
{
public:
  /// A smooth flow on @p n cells a side.
  explicit ControlLoop(const unsigned int n);

  /// Does one Runge-Kutta stage on all cells.
  void stage();

  double n_cells() const
  {
    return double(n_) * n_ * n_;
  }
  /// Total energy over the number of cells [J/m^3]; stages conserve it.
  double mean_energy() const;

private:
  static constexpr unsigned int n_components = 5;
  using Values = std::array<double, n_components>;
  using Fields = std::array<std::vector<double>, n_components>;

  void compute_primitive();
  void sweep_line(const unsigned int direction, const std::size_t first);
  void add_line(const unsigned int direction, const std::size_t first);
  std::size_t stride(const unsigned int direction) const
  {
    return direction == 0 ? 1 : direction == 1 ? n_ : std::size_t(n_) * n_;
  }

  const unsigned int n_;
  Fields conserved_; ///< density, momentum, energy
  Fields primitive_; ///< density, velocity, pressure
  Fields rate_;      ///< of change
  std::vector<Values> line_, left_, right_, flux_;
};
} // namespace contrecoup
