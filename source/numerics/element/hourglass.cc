// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/names.h>
#include <contrecoup/numerics/element/hourglass.h>

namespace contrecoup
{
const std::vector<std::string> &hourglass_names()
{
  static const std::vector<std::string> names{
    "none", "viscous", "stiffness", "assumed strain"};
  return names;
}


HourglassKind find_hourglass(const std::string &name)
{
  return static_cast<HourglassKind>(
    position_of(name, hourglass_names(), "hourglass control"));
}
} // namespace contrecoup
