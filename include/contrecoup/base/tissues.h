// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// What a piece of a body is made of. The numbers are those in mesh files and
/// do not change.
enum class Tissue : unsigned char
{
  none = 0,
  soft_tissue = 1,
  skin = 2,
  skeleton = 3,
  brain = 4,
  spinal_cord = 5,
  cerebrospinal_fluid = 6,
  lung = 7,
  heart = 8,
  liver = 9,
  water = 10,
  gelatin = 11,
  polycarbonate = 12,
};

/// The names by number, "none" first; the list that parameter files, labels
/// of images and reports use.
const std::vector<std::string> &tissue_names();

/// Its name in tissue_names().
const std::string &name_of(Tissue tissue);

/// The tissue of this name. @throws InputError with the nearest name
Tissue find_tissue(const std::string &name);
} // namespace contrecoup
