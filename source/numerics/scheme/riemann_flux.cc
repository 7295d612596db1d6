// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/names.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>

namespace contrecoup
{
std::vector<std::string> riemann_flux_names()
{
  // In the order of RiemannFlux.
  return {"hllc", "hll", "rusanov", "hllc shock stable"};
}

RiemannFlux parse_riemann_flux(const std::string &name)
{
  return static_cast<RiemannFlux>(
    position_of(name, riemann_flux_names(), "Riemann flux"));
}
} // namespace contrecoup
