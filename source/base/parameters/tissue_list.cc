// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/tissue_list.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

namespace contrecoup
{
std::vector<Tissue> find_tissues(const std::string &text,
                                 const std::string &entry)
{
  std::vector<Tissue> tissues;
  for (const std::string &name : split(text, ','))
    tissues.push_back(find_one_tissue(name, entry));
  return tissues;
}


Tissue find_one_tissue(const std::string &name, const std::string &entry)
{
  const std::vector<std::string> known{tissue_names().begin() + 1,
                                       tissue_names().end()};
  const std::string resolved = resolve_name(name, known);
  if (!resolved.empty())
    return find_tissue(resolved);
  const std::string meant = nearest(name, known);
  throw InputError(
    entry + ": \"" + name + "\" is " +
    (name == name_of(Tissue::none) ? "not a" : "no") + " tissue; " +
    (meant.empty() ? "known are "
                   : "did you mean \"" + meant + "\"? Known are ") +
    join(known, ", "));
}
} // namespace contrecoup
