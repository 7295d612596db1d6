// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/ideal_gas.h>
#include <contrecoup/materials/mie_grueneisen.h>
#include <contrecoup/materials/tait.h>
#include <contrecoup/numerics/hex8_fluid.h>

#include <string>
#include <variant>

namespace contrecoup::ale
{
/// Equations of state of fluids.
using FluidLaw = std::variant<IdealGas, MieGrueneisen, Tait>;

/// A part of the mesh with one material.
struct Region
{
  std::string name;
  FluidLaw law = IdealGas();
  FluidViscosity viscosity;
};
} // namespace contrecoup::ale
