// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

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
    try
    {
      tissues.push_back(find_tissue(name));
      if (tissues.back() == Tissue::none)
        throw InputError("\"none\" is not a tissue");
    }
    catch (const InputError &error)
    {
      throw InputError(entry + ": " + std::string(error.what()));
    }
  return tissues;
}
} // namespace contrecoup
