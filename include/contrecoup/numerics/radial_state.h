// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

namespace contrecoup
{
/// A flow that depends on the distance from a plane, axis or centre alone.
struct RadialState
{
  double density = 0.;  ///< mass per volume [kg/m^3]
  double velocity = 0.; ///< velocity away from the centre [m/s]
  double pressure = 0.; ///< absolute pressure [Pa]
};
} // namespace contrecoup
