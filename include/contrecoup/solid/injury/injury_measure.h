// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/numerics/injury/own_thresholds.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/// An injury measure with its threshold, of the literature or of the user.
struct InjuryMeasure
{
  NamedValue value;
  std::string threshold; ///< including its source
  std::string limits;    ///< limits of its validity
  /// A lower limit, of the magnitude: the run ends too early.
  bool is_cut = false;
};

/// A measure with what injury_criterion() knows of its name.
InjuryMeasure known_measure(const std::string &name, double value);

/// The measure for the screen, with >= or <= where it is a lower limit of its
/// magnitude.
std::string in_words(const InjuryMeasure &measure);

/// Values for a summary; of each lower limit also "NAME_cut_off", which is 1.
std::vector<NamedValue> values_of(const std::vector<InjuryMeasure> &measures);

/// Replaces the published thresholds of @p measures by the user's own.
void apply(const OwnThresholds &own, std::vector<InjuryMeasure> &measures);

/// Says the limits of a blunt impact in place of those of a blast.
void limit_to_impact(std::vector<InjuryMeasure> &measures);

/// The probabilities of injury_criterion() by a measure, as measures
/// "injury_CURVE"; empty for most.
std::vector<InjuryMeasure> probabilities_of(const InjuryMeasure &measure);
} // namespace contrecoup::solid
