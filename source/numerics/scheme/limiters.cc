// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/names.h>
#include <contrecoup/numerics/scheme/limiters.h>

namespace contrecoup
{
std::vector<std::string> slope_limiter_names()
{
  return {"none", "minmod", "van albada", "van leer", "mc", "superbee"};
}

SlopeLimiter parse_slope_limiter(const std::string &name)
{
  return static_cast<SlopeLimiter>(
    position_of(name, slope_limiter_names(), "slope limiter"));
}
} // namespace contrecoup
