// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/study/json_path.h>

#include <nlohmann/json.hpp>

#include <limits>

namespace contrecoup::study
{
double number_at(const nlohmann::json &object,
                 const std::string &path,
                 const std::string &where)
{
  const nlohmann::json *node = &object;
  std::string walked;
  for (const std::string &part : split(path, '.'))
  {
    std::vector<std::string> known;
    if (node->is_object())
      for (const auto &item : node->items())
        known.push_back(item.key());
    if (!node->is_object() || !node->contains(part))
      throw InputError(where + " has no \"" + part + "\"" +
                       (walked.empty() ? "" : " in \"" + walked + "\"") +
                       (known.empty() ? ", where nothing is" : "") +
                       suggestion(part, known));
    walked += (walked.empty() ? "" : ".") + part;
    node = &(*node)[part];
  }
  // A result or check is an object with a value and its unit.
  if (node->is_object() && node->contains("value"))
    node = &(*node)["value"];
  if (node->is_null())
    return std::numeric_limits<double>::quiet_NaN();
  if (!node->is_number() || path.empty())
    throw InputError(where + ": \"" + path + "\" is not a number");
  return node->get<double>();
}
} // namespace contrecoup::study
