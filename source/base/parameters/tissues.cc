// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/base/system/names.h>

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
  return static_cast<Tissue>(position_of(name, tissue_names(), "tissue"));
}
} // namespace contrecoup
