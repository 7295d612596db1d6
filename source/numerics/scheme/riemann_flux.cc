// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>

#include <algorithm>

namespace contrecoup
{
std::vector<std::string> riemann_flux_names()
{
  // In the order of RiemannFlux.
  return {"hllc", "hll", "rusanov", "hllc shock stable"};
}

RiemannFlux parse_riemann_flux(const std::string &name)
{
  const std::vector<std::string> names = riemann_flux_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw InputError("There is no Riemann flux named '" + name + "'" +
                     suggestion(name, names));
  return static_cast<RiemannFlux>(found - names.begin());
}
} // namespace contrecoup
