// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * The coarser run of a scene: the same blast and the same body with larger
 * cells and elements. The differences between both runs estimate the numerical
 * error of the scene's results.
 */
struct CoarserRun
{
  /// Ratio of cell sizes of the gas in three dimensions and in the
  /// axisymmetric first stage. Spherical stages keep their cells.
  static constexpr double cell_ratio = 2.;
  /// Ratio of element sizes; a coarser body costs an eighth.
  static constexpr double element_ratio = 5. / 3.;

  /**
   * Changes to the entries of `blast` that double its cells; neither fields nor
   * pictures.
   * @param prm entries of the scene's blast
   * @throws InputError if the cells at the skin are those of the coarsest level
   */
  static std::vector<Assignment> blast(const dealii::ParameterHandler &prm);

  /// Changes to the entries of `biomechanics` that enlarge its elements; no
  /// fields.
  /// @param prm entries of the scene's biomechanics
  static std::vector<Assignment>
  biomechanics(const dealii::ParameterHandler &prm);

  /// Arguments by which the coarser biomechanics makes the impulse of the loads
  /// equal to the recorded one exactly if that of the scene did: errors would
  /// else contain the jump between both.
  /// @param folder of the scene's finished biomechanics
  static std::vector<std::string>
  same_correction_of_loads(const std::string &folder);
};
} // namespace contrecoup::coupling
