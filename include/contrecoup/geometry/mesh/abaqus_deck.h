// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <istream>
#include <map>
#include <string>

namespace contrecoup
{
/// The mesh of an Abaqus input file.
struct AbaqusDeck
{
  std::string ucd; ///< as a text that deal.II's reader of UCD files takes
  /// Names of the element sets by number, which is the material id; elements
  /// without a set have 0.
  std::map<unsigned int, std::string> groups;
};

/// Whether the text of a .inp file is one of Abaqus: its first keyword begins
/// with a "*". Leaves the stream at its begin.
bool is_abaqus_deck(std::istream &stream);

/**
 * Reads nodes and elements of one part: 8-node bricks (C3D8, C3D8R, ...) in
 * three dimensions, quadrilaterals (CPS4, CPE4, CAX4, S4, ...) in two. An
 * element belongs to the set of its *SOLID SECTION, otherwise to the ELSET of
 * its *ELEMENT. Shells, beams and springs of a three-dimensional deck are left
 * out.
 * @param where begin of error messages
 * @throws InputError for elements of second order or of other shapes, nodes
 * that are missing or given twice, and instances that are moved
 */
AbaqusDeck read_abaqus_deck(std::istream &stream,
                            unsigned int dimension,
                            const std::string &where);
} // namespace contrecoup
