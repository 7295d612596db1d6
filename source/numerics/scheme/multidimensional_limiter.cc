// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/names.h>
#include <contrecoup/numerics/scheme/multidimensional_limiter.h>

namespace contrecoup
{
std::vector<std::string> gradient_limiter_names()
{
  return {"barth jespersen", "venkatakrishnan"};
}

GradientLimiter parse_gradient_limiter(const std::string &name)
{
  return static_cast<GradientLimiter>(
    position_of(name, gradient_limiter_names(), "gradient limiter"));
}
} // namespace contrecoup
