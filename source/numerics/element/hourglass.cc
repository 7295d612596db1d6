// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
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
  const auto &names = hourglass_names();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == name)
      return static_cast<HourglassKind>(i);
  throw InputError("\"" + name + "\" is no hourglass control" +
                   suggestion(name, names));
}
} // namespace contrecoup
