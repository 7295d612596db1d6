// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/conditions/profile.h>

#include <string>

namespace contrecoup::gas
{
/**
 * Writes a profile as HDF5, or as a table if @p file ends in ".csv". Called by
 * one rank. HDF5 files have attributes (format, geometry, time_s, material,
 * version, units, ambient state), data sets edges_0 and edges_1 [m], density,
 * momentum_0, momentum_1, energy, products (one value per cell), and a group
 * "maps". A table has the same data in comment lines "# name = value" and one
 * line per cell.
 * @throws SystemError when the disk is full
 */
void write_profile(const std::string &file, const ProfileData &data);

/**
 * Reads a file of write_profile(). A table needs only the comment lines
 * geometry, time and those of the ambient state.
 * @throws InputError when the file is missing or is not a valid profile
 */
ProfileData read_profile(const std::string &file);
} // namespace contrecoup::gas
