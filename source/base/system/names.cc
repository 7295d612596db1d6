// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/names.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>

namespace contrecoup
{
std::size_t position_of(const std::string &name,
                        const std::vector<std::string> &names,
                        const std::string &kind)
{
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("\"" + name + "\" is no " + kind +
                     suggestion(name, names));
  return found - names.begin();
}
} // namespace contrecoup
