// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Numbers in the tables of a blast with these entries, see
/// io::ApplicationDescription::tables.
/// @throws InputError for gauges that the scene cannot have
std::vector<std::string> blast_tables(dealii::ParameterHandler &prm);
} // namespace contrecoup::coupling
