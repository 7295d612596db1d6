// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/geometry/image/body_part.h>

#include <vector>

namespace contrecoup
{
BodyPart parse_body_part(const std::string &text, const std::string &where)
{
  const std::vector<std::string> names = split(text, '=');
  if (names.empty() || names.size() > 2)
    throw InputError(where + ": \"" + text +
                     "\" must read \"tissue\" or \"name = tissue\"");
  return {names.front(),
          resolve_name(names.back(), {name_of(Tissue::none)}).empty()
            ? find_one_tissue(names.back(), where)
            : Tissue::none};
}
} // namespace contrecoup
