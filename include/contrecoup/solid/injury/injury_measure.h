// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>

#include <string>

namespace contrecoup::solid
{
/// An injury measure with its threshold from the literature.
struct InjuryMeasure
{
  NamedValue value;
  std::string threshold; ///< including its source
  std::string limits;    ///< limits of its validity
};

/// A measure with what injury_criterion() knows of its name.
InjuryMeasure known_measure(const std::string &name,
                            const std::string &unit,
                            const double value);
} // namespace contrecoup::solid
