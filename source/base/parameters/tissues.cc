// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/tissues.h>
#include <contrecoup/base/system/names.h>

namespace contrecoup
{
const std::string &name_of(const Tissue tissue)
{
  return tissue_names()[static_cast<std::size_t>(tissue)];
}

Tissue find_tissue(const std::string &name)
{
  const std::string resolved = resolve_name(name, tissue_names());
  return static_cast<Tissue>(
    position_of(resolved.empty() ? name : resolved, tissue_names(), "tissue"));
}
} // namespace contrecoup
