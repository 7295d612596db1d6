// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/record/peak_fields.h>

#include <string>

namespace contrecoup::solid
{
/**
 * Writes the body for ParaView: `solid_0012.vtu`, or a piece for each rank and
 * `solid_0012.pvtu`. Points are those of the undeformed body; displacement and
 * velocity stand at nodes, tissue, pressure, von Mises stress and largest
 * principal strain in elements, and the peaks that are kept. Collective.
 * @return the file to open, without folder
 * @throws SystemError
 */
template <typename Real>
std::string write_solid(const SolidBody<Real> &body,
                        const PeakFields<Real> &peaks,
                        const std::string &folder,
                        unsigned int index);
} // namespace contrecoup::solid
