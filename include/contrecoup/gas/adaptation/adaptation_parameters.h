// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/size_limits.h>

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace contrecoup::gas
{
/// Criteria for refining and coarsening leaves, read from subsection
/// "Adaptation".
struct AdaptationParameters
{
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @throws InputError when smallest and largest level contradict each other,
  /// and for a mesh that adapts unless @p is_axis_aligned.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const unsigned int dim,
                        const unsigned int initial_refinement,
                        const unsigned int n_points,
                        const bool is_finite_volume,
                        const bool is_axis_aligned);

  /**
   * Computes the number of steps in which no shock into gas at rest crosses the
   * AMR buffer.
   * @param courant_number step size times signal rate sum_d (|u_d| + c) / h_d
   * [-]
   */
  void find_buffer_steps(const double courant_number,
                         const unsigned int dim,
                         const unsigned int n_points);

  enum class Sensor
  {
    jump,          ///< jump_sensor(): curvature of density and pressure
    pressure_jump, ///< the same of pressure only; ignores contacts
    blast          ///< front_sensor(): pressure fronts
  };

  bool active = false;
  Sensor sensor = Sensor::jump;
  unsigned int interval = 5;  ///< most steps between adaptations; 0: no limit
  double buffer_steps = 1.;   ///< steps to cross the AMR buffer [-]
  unsigned int min_level = 0; ///< refinements of the coarse mesh
  unsigned int max_level = 0;
  double refine = 0.3;     ///< sensor above which leaves are refined
  double coarsen = 0.1;    ///< sensor below which leaves are coarsened
  double noise = 0.02;     ///< relative jump that is treated as noise
  unsigned int buffer = 1; ///< AMR buffer width, layers of leaves
  /// Whether the AMR buffer is only ahead of fronts.
  bool buffer_only_ahead = false;
  /// Smallest level of leaves in the fine box; 0: no such box.
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
