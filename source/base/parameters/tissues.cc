// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>

namespace contrecoup
{
const std::vector<std::string> &tissue_names()
{
  static const std::vector<std::string> names{"none",
                                              "soft tissue",
                                              "skin",
                                              "skeleton",
                                              "brain",
                                              "spinal cord",
                                              "cerebrospinal fluid",
                                              "lung",
                                              "heart",
                                              "liver",
                                              "water",
                                              "gelatin",
                                              "polycarbonate"};
  return names;
}

const std::string &name_of(const Tissue tissue)
{
  return tissue_names()[static_cast<std::size_t>(tissue)];
}

Tissue find_tissue(const std::string &name)
{
  const std::vector<std::string> &names = tissue_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("\"" + name + "\" is not a tissue" +
                     suggestion(name, names));
  return static_cast<Tissue>(found - names.begin());
}
} // namespace contrecoup
