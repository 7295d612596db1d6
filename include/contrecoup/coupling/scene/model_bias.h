// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/scene_parameters.h>

#include <limits>
#include <string>

namespace contrecoup::coupling
{
/// In place of a number that nothing gives.
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

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
 * The difference at a distance [m] from a charge, measured for 1 kg of each
 * explosive of the library with its usual afterburn in 1-D
 * (parameter_files/study/explosive_bias.prm) at scaled distances of 1 to 6
 * m/kg^(1/3), and linear between their logarithms. Unknown for explosives and
 * afterburn of the user, for charges on the ground, and elsewhere.
 */
ModelBias model_bias(const SceneParameters &scene,
                     double distance,
                     bool is_surface_burst = false);

/// "peak -3 %, impulse +12 %, duration -5 %", or "unknown: " and why.
std::string in_words(const ModelBias &bias);
} // namespace contrecoup::coupling
