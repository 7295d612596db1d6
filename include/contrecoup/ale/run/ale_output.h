// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>

#include <string>

namespace contrecoup::ale
{
/**
 * Writes the present mesh for ParaView, `ale_0012.vtu`, with velocity,
 * density, pressure, specific internal energy, mass fraction of products and
 * region. Collective.
 * @return name of the file to open, without folder
 * @throws SystemError when the disk fails
 */
std::string write_ale(const HexSpace &space,
                      const LagrangeStep &lagrange,
                      const AleState &state,
                      const std::string &folder,
                      const unsigned int index);
} // namespace contrecoup::ale
