// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace contrecoup
{
/**
 * Annotated parameter file (see parameter_text()) with one section or entry, by
 * name or path such as "Body/Surface"; else with all entries whose name or help
 * text has the words of @p what. Letter case does not matter.
 * @throws InputError when nothing is found, with the nearest name
 */
std::string find_parameters(const dealii::ParameterHandler &prm,
                            const std::string &what);
} // namespace contrecoup
