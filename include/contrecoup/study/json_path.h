// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace contrecoup::study
{
/**
 * The number at a dotted path such as "errors.density_L1" in an object of
 * objects; null, which stands for a number that is not finite, gives NaN.
 * @throws InputError naming what is there instead when there is no such
 *   number; @p where names the object.
 */
double number_at(const nlohmann::json &object,
                 const std::string &path,
                 const std::string &where);
} // namespace contrecoup::study
