// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>

namespace contrecoup
{
namespace io
{
  /**
   * Writes NAME.xdmf next to NAME.h5, a LoadFile with facets as polygons or
   * lines, by which ParaView (its "XDMF Reader", not those of Xdmf3) shows
   * overpressure over time on the facets, with peak, impulse, arrival and
   * duration. It holds no numbers of its own but times. Writes nothing where
   * facets have no corners.
   * @throws InputError when the file is no load file
   * @throws SystemError when the disk is full
   */
  void write_load_series(const std::string &load_file);
} // namespace io
} // namespace contrecoup
