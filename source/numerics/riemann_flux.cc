// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/numerics/riemann_flux.h>

namespace contrecoup
{
std::string riemann_flux_names()
{
  return "hllc|hll|rusanov|hllc shock stable";
}

RiemannFlux parse_riemann_flux(const std::string &name)
{
  if (name == "hllc")
    return RiemannFlux::hllc;
  if (name == "hll")
    return RiemannFlux::hll;
  if (name == "rusanov")
    return RiemannFlux::rusanov;
  if (name == "hllc shock stable")
    return RiemannFlux::hllc_shock_stable;
  throw InputError("There is no flux named '" + name +
                   "'; choose one of: " + riemann_flux_names() + ".");
}
} // namespace contrecoup
