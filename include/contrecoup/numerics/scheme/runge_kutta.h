// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// One stage u <- a u^n + b (u + dt L(u)), with L evaluated at t^n + c dt.
struct RungeKuttaStage
{
  double initial_weight; ///< a [-]
  double step_weight;    ///< b = 1 - a [-]
  double time;           ///< c [-]
};

/**
 * Strong-stability-preserving Runge-Kutta method as convex combinations of
 * forward Euler steps (Shu and Osher 1988): bounds that hold for forward Euler
 * hold for the method. All methods here allow the step size of forward Euler.
 */
struct RungeKuttaTable
{
  unsigned int order = 0;
  std::vector<RungeKuttaStage> stages;
};

/// Names of the methods, one for each order from 1 to 3.
std::vector<std::string> runge_kutta_names();

/// The method with this name. @throws InputError for an unknown name
RungeKuttaTable parse_runge_kutta(const std::string &name);
} // namespace contrecoup
