// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace contrecoup::study
{
/**
 * Number at a dotted path such as "errors.density_L1" in nested objects, or the
 * "value" of the object there, as of "results.injury_hic15"; null, which
 * represents a value that is not finite, gives NaN.
 * @param where name of the object, for error messages
 * @throws InputError, listing what exists, if there is no such number
 */
double number_at(const nlohmann::json &object,
                 const std::string &path,
                 const std::string &where);
} // namespace contrecoup::study
