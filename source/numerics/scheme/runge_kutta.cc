// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/scheme/runge_kutta.h>

namespace contrecoup
{
std::vector<std::string> runge_kutta_names()
{
  return {"forward euler", "ssp rk2", "ssp rk3"};
}

RungeKuttaTable parse_runge_kutta(const std::string &name)
{
  if (name == "forward euler")
    return {1, {{0., 1., 0.}}};
  if (name == "ssp rk2")
    return {2, {{0., 1., 0.}, {0.5, 0.5, 1.}}};
  if (name == "ssp rk3")
    return {3, {{0., 1., 0.}, {0.75, 0.25, 1.}, {1. / 3., 2. / 3., 0.5}}};
  throw InputError("There is no Runge-Kutta method named '" + name + "'" +
                   suggestion(name, runge_kutta_names()));
}
} // namespace contrecoup
