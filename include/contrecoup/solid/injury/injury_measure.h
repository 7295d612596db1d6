// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>

#include <string>

namespace contrecoup::solid
{
/// A measure of injury with what it is compared to.
struct InjuryMeasure
{
  NamedValue value;
  std::string threshold; ///< with its source
  std::string limits;    ///< of what it says
};
} // namespace contrecoup::solid
