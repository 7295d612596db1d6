// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/size_limits.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace contrecoup::gas
{
/// Which leaves are halved or merged, as subsection "Adaptation" says.
struct AdaptationParameters
{
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @throws InputError when smallest and largest contradict each other.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const unsigned int dim,
                        const unsigned int initial_refinement,
                        const unsigned int n_points,
                        const bool is_finite_volume,
                        const bool is_axis_aligned);

  /**
   * Finds in how many steps no shock that runs into gas at rest crosses the
   * buffer.
   * @param reach step size times signal rate sum_d (|u_d| + c) / h_d [-]
   */
  void find_buffer_steps(const double courant_number,
                         const unsigned int dim,
                         const unsigned int n_points);

  enum class Sensor
  {
    jump,          ///< jump_sensor(): bends of density and pressure
    pressure_jump, ///< the same of pressure alone, blind to contacts
    blast          ///< front_sensor(): pressure fronts
  };

  bool active = false;
  Sensor sensor = Sensor::jump;
  unsigned int interval = 5;  ///< most steps in between; 0: no such limit
  double buffer_steps = 1.;   ///< for fronts in leaves that set the step
  unsigned int min_level = 0; ///< refinements of the coarse mesh
  unsigned int max_level = 0;
  double refine = 0.3;     ///< sensor above which leaves are halved
  double coarsen = 0.1;    ///< sensor below which they are merged
  double noise = 0.02;     ///< relative jump that counts as noise
  unsigned int buffer = 1; ///< layers of leaves around marked ones
  /// Whether these layers are only ahead of fronts.
  bool buffer_only_ahead = false;
  /// A box whose leaves stay at this level at least; level 0: none.
  unsigned int fine_level = 0;
  std::vector<double> fine_lower; ///< [m]
  std::vector<double> fine_upper; ///< [m]
  SizeLimits limits;

private:
  void check(const unsigned int dim,
             const unsigned int n_points,
             const bool is_finite_volume,
             const bool is_axis_aligned) const;
};
} // namespace contrecoup::gas
