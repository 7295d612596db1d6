// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <limits>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// In place of a number that nothing gives.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A charge of which the bias of the model may be known.
struct BiasedBurst
{
  std::string explosive;  ///< name in the library
  double mass;            ///< [kg]
  bool is_custom = false; ///< whether constants are the user's own
  bool has_usual_afterburn = true;
  bool is_on_ground = false;
};

/// Relative difference of the incident wave of the model from the tables of
/// Kingery and Bulmash where cells are no reason, in whole per cents [-]; NaN:
/// not measured.
struct ModelBias
{
  double peak;
  double impulse;
  double duration;      ///< of the positive phase
  std::string gap = ""; ///< why it was not measured; empty: it was
};

/**
 * The difference at a distance [m] from a charge, measured for each explosive
 * of the library with its usual afterburn in 1-D
 * (parameter_files/study/explosive_bias.prm) at scaled distances of 1 to 6
 * m/kg^(1/3) and masses of 0.1 to 100 kg, since afterburn takes the same time
 * whatever the mass, and linear between their logarithms. Unknown for
 * explosives and afterburn of the user, for charges on the ground, where it
 * jumps, and elsewhere.
 */
ModelBias model_bias(const BiasedBurst &burst, double distance);

/// "peak -9 %, impulse -28 %, duration -58 %", or why it is unknown.
std::string in_words(const ModelBias &bias);

/// A warning for a run of `blast` whose probes have injuries by impulses or
/// durations with a large bias: the place where it is largest. None otherwise,
/// and where the bias is unknown.
std::vector<std::string> warn_of_bias(dealii::ParameterHandler &prm);
} // namespace contrecoup::coupling
