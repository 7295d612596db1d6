// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <map>

namespace contrecoup
{
namespace
{
  using declared::Tree;

  bool is_letter_or_digit(const char letter)
  {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0;
  }

  /// The name in lower case without separators between letters; "-x" and "x"
  /// stay different.
  std::string normalised(const std::string &name)
  {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i)
    {
      const bool is_separator =
        std::string(" -_").find(name[i]) != std::string::npos;
      const std::size_t next = name.find_first_not_of(" -_", i);
      if (is_separator && !result.empty() && next != std::string::npos &&
          is_letter_or_digit(result.back()) && is_letter_or_digit(name[next]))
        continue;
      result +=
        static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    }
    return result;
  }

  /// "Region ball" for "region ball" if "Region *" is declared; empty without
  /// such a pattern.
  std::string name_of_item(const std::string &section, const Tree &node)
  {
    const std::size_t blank = section.find(' ');
    if (blank == std::string::npos)
      return "";
    for (const std::string &name : declared::names(node, false))
    {
      const std::string stem = name.substr(0, name.size() - 1);
      if (declared::is_pattern(name) && section.size() > stem.size() &&
          section[stem.size() - 1] == ' ' &&
          normalised(section.substr(0, stem.size())) == normalised(stem))
        return stem + section.substr(stem.size());
    }
    return "";
  }

  /// Replaces @p section by its declared name, and returns its node.
  const Tree *enter(std::string &section, const Tree &node)
  {
    std::vector<std::string> known;
    // Names of items belong to the user: "Region a" is not "Region A".
    for (const std::string &name : declared::names(node, false))
      if (declared::pattern_of(node, name).empty())
        known.push_back(name);
    const std::string resolved = resolve_name(section, known);
    const std::string item =
      resolved.empty() ? name_of_item(section, node) : "";
    if (resolved.empty() && item.empty())
      return nullptr;
    section = resolved.empty() ? item : resolved;
    return &node[resolved.empty() ? declared::pattern_of(node, item)
                                  : resolved];
  }

  std::string declared_value(const std::string &value,
                             const std::string &description)
  {
    std::vector<std::string> known;
    if (description.find("[Selection ") == 0)
      known = split(declared::between(description, "[Selection ", "]"), '|');
    else if (description == "[Bool]")
    {
      if (!resolve_name(value, {"true", "yes", "on", "1"}).empty())
        return "true";
      if (!resolve_name(value, {"false", "no", "off", "0"}).empty())
        return "false";
    }
    const std::string resolved = resolve_name(value, known);
    return resolved.empty() ? value : resolved;
  }

  void use_declared_names(Assignment &assignment, const Tree &tree)
  {
    const Tree *node = &tree;
    for (std::string &section : assignment.sections)
    {
      node = enter(section, *node);
      if (node == nullptr)
        return;
    }
    const std::string entry =
      resolve_name(assignment.entry, declared::names(*node, true));
    if (entry.empty())
      return;
    assignment.entry = entry;
    assignment.value =
      declared_value(assignment.value,
                     (*node)[entry]["pattern_description"].get<std::string>());
  }
} // namespace


std::string resolve_name(const std::string &name,
                         const std::vector<std::string> &known)
{
  if (std::find(known.begin(), known.end(), name) != known.end())
    return name;
  const std::string wanted = normalised(name);
  std::string resolved;
  for (const std::string &candidate : known)
    if (normalised(candidate) == wanted)
    {
      if (!resolved.empty())
        return "";
      resolved = candidate;
    }
  return resolved;
}


std::vector<Assignment>
with_declared_names(const std::vector<Assignment> &assignments,
                    const dealii::ParameterHandler &prm)
{
  const Tree tree = declared::tree_of(prm);
  std::vector<Assignment> result = assignments;
  for (Assignment &assignment : result)
    use_declared_names(assignment, tree);
  return result;
}


std::vector<std::string>
find_oversights(const std::string &file,
                const std::vector<Assignment> &assignments)
{
  // Separates file name and line number: "\"file.prm\", line 7".
  const std::string mark = "\", line ";
  std::vector<std::string> lines;
  std::map<std::string, std::string> before;
  bool is_empty = true;
  for (const Assignment &assignment : assignments)
  {
    const std::size_t end = assignment.origin.rfind(mark);
    if (end == std::string::npos)
      continue;
    is_empty = false;
    std::vector<std::string> path = assignment.sections;
    path.push_back(assignment.entry);
    const std::string place = assignment.origin.substr(end + mark.size());
    const std::string line = place.substr(0, place.find(','));
    std::string &earlier =
      before[assignment.origin.substr(0, end) + mark + join(path, "/")];
    if (!earlier.empty())
      lines.push_back("WARNING: " + assignment.origin + ": entry \"" +
                      join(path, "/") + "\" was set in line " + earlier +
                      " already; the later value, " +
                      quotation(assignment.value) + ", counts");
    earlier = line;
  }
  if (is_empty && !file.empty())
    lines.insert(lines.begin(),
                 "WARNING: the parameter file " + quotation(file) +
                   " sets no entry, so that each has its default");
  return lines;
}
} // namespace contrecoup
