// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/record/peak_fields.h>

#include <string>

namespace contrecoup::solid
{
/**
 * Writes the body for ParaView: `solid_0012.vtu`, or one piece per rank and
 * `solid_0012.pvtu`. Points are those of the undeformed body. Point data are
 * displacement and velocity; cell data are tissue, pressure, von Mises stress,
 * largest principal strain and the recorded peaks; field data
 * are the names of the tissues by number. Collective.
 * @return name of the file to open, without folder
 * @throws SystemError when the disk fails
 */
template <typename Real>
std::string write_solid(const SolidBody<Real> &body,
                        const PeakFields<Real> &peaks,
                        const std::string &folder,
                        unsigned int index);
} // namespace contrecoup::solid
