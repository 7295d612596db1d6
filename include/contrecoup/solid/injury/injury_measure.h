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
} // namespace contrecoup::solid
