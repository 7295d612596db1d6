// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
/// Material of a part of a body. The numbers appear in mesh files and never
/// change.
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

/// Names by number, "none" first, as in parameter files, image labels and
/// reports.
const std::vector<std::string> &tissue_names();

/// Name of a tissue in tissue_names().
const std::string &name_of(Tissue tissue);

/// The tissue with this name. @throws InputError that suggests the nearest
/// name
Tissue find_tissue(const std::string &name);
} // namespace contrecoup
