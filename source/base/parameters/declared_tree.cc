// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/system/text.h>

#include <nlohmann/json.hpp>

#include <sstream>

namespace contrecoup::declared
{
using dealii::ParameterHandler;

Tree tree_of(const ParameterHandler &prm)
{
  std::ostringstream text;
  prm.print_parameters(
    text, ParameterHandler::JSON | ParameterHandler::KeepDeclarationOrder);
  return trim(text.str()).empty() ? Tree::object() : Tree::parse(text.str());
}


bool is_entry(const Tree &node)
{
  return node.is_object() && node.contains("pattern_description") &&
         node["pattern_description"].is_string();
}


bool is_pattern(const std::string &section)
{
  return section.size() > 2 &&
         section.compare(section.size() - 2, 2, " *") == 0;
}


std::vector<std::string> names(const Tree &node, const bool entries)
{
  std::vector<std::string> result;
  if (node.is_object())
    for (const auto &item : node.items())
      if (is_entry(item.value()) == entries)
        result.push_back(item.key());
  return result;
}


std::string pattern_of(const Tree &node, const std::string &section)
{
  for (const std::string &name : names(node, false))
    if (is_pattern(name) && section.size() >= name.size() &&
        section.compare(0, name.size() - 1, name, 0, name.size() - 1) == 0)
      return name;
  return "";
}


std::string between(const std::string &text,
                    const std::string &first,
                    const std::string &last)
{
  const std::size_t begin = text.find(first) + first.size();
  return text.substr(begin, text.rfind(last) - begin);
}
} // namespace contrecoup::declared
