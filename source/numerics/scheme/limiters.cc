// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/scheme/limiters.h>
#include <contrecoup/numerics/scheme/multidimensional_limiter.h>

#include <algorithm>

namespace contrecoup
{
namespace
{
  /// Index of @p name in @p names.
  std::size_t position(const std::string &name,
                       const std::vector<std::string> &names,
                       const std::string &kind)
  {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError("There is no " + kind + " named '" + name + "'" +
                       suggestion(name, names));
    return found - names.begin();
  }
} // namespace

std::vector<std::string> slope_limiter_names()
{
  return {"none", "minmod", "van albada", "van leer", "mc", "superbee"};
}

SlopeLimiter parse_slope_limiter(const std::string &name)
{
  return static_cast<SlopeLimiter>(
    position(name, slope_limiter_names(), "slope limiter"));
}

std::vector<std::string> gradient_limiter_names()
{
  return {"barth jespersen", "venkatakrishnan"};
}

GradientLimiter parse_gradient_limiter(const std::string &name)
{
  return static_cast<GradientLimiter>(
    position(name, gradient_limiter_names(), "gradient limiter"));
}
} // namespace contrecoup
