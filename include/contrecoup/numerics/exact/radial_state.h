// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/// State of a flow with plane, cylindrical or spherical symmetry.
struct RadialState
{
  double density = 0.;  ///< [kg/m^3]
  double velocity = 0.; ///< away from the centre [m/s]
  double pressure = 0.; ///< absolute [Pa]
};
} // namespace contrecoup
