// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <algorithm>

namespace contrecoup
{
/// -t / tau of a branch with the relaxation time @p tau at the time @p time
/// [s], at most 1; 0 at t = 0 for any tau. Its exponential, what remains of the
/// branch, neither overflows nor is it undefined: with tau = 0 the branch
/// follows at once. Where a step was cut, the stored strain is of a later time,
/// t < 0, to which it must not be taken back.
inline double relaxation_exponent(const double time, const double tau)
{
  return time == 0. ? 0. : std::min(1., -time / tau);
}
} // namespace contrecoup
