// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/allowed_values.h>
#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/parameters/number_or_word.h>
#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/unicode.h>

#include <deal.II/base/patterns.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <sstream>

namespace contrecoup
{
namespace
{
  using declared::is_entry;
  using declared::is_pattern;
  using declared::names;
  using declared::pattern_of;
  using declared::Tree;
  using declared::tree_of;

  /// The pattern with this description. deal.II's own function supports commas
  /// as separators only.
  std::unique_ptr<dealii::Patterns::PatternBase>
  pattern_of_text(const std::string &description)
  {
    if (description.find("[List of <[List of <") == 0)
      return points_pattern().clone();
    if (auto pattern = NumberOrWord::create(description))
      return pattern;
    return dealii::Patterns::pattern_factory(description);
  }

  /// Declares the entries of @p node in the current subsection of @p prm.
  void declare_copy(const Tree &node, ParameterHandler &prm)
  {
    if (!node.is_object())
      return;
    for (const auto &item : node.items())
      if (is_entry(item.value()))
      {
        const auto text = [&](const char *field) {
          return item.value()[field].get<std::string>();
        };
        prm.declare_entry(item.key(),
                          text("default_value"),
                          *pattern_of_text(text("pattern_description")),
                          text("documentation"));
      }
      else
      {
        prm.enter_subsection(item.key());
        declare_copy(item.value(), prm);
        prm.leave_subsection();
      }
  }

  std::string where(const std::vector<std::string> &sections,
                    const std::size_t depth)
  {
    if (depth == 0)
      return "at the top level";
    return "in \"" + join({sections.begin(), sections.begin() + depth}, "/") +
           "\"";
  }

  /// "; it has U+00A0 (no-break space) ..." of a name; empty if it has none.
  std::string remark_on(const std::string &name)
  {
    const std::string found = find_lookalike(name);
    return found.empty() ? "" : "; it has " + found;
  }

  /// Declares the named items in @p assignment and checks that its entry
  /// exists. Returns the entry's node.
  const Tree &
  find_entry(const Assignment &assignment, ParameterHandler &prm, Tree &tree)
  {
    Tree *node = &tree;
    const auto &sections = assignment.sections;
    for (std::size_t depth = 0; depth < sections.size(); ++depth)
    {
      const std::string &section = sections[depth];
      const std::vector<std::string> known = names(*node, false);
      const bool declared =
        std::find(known.begin(), known.end(), section) != known.end();
      const std::string pattern = pattern_of(*node, section);
      if (is_pattern(section) || (!declared && pattern.empty()))
        throw InputError(assignment.origin + ": unknown subsection " +
                         quotation(section) + " " + where(sections, depth) +
                         suggestion(section, known) + remark_on(section));
      if (!declared)
      {
        const Tree copy = (*node)[pattern];
        for (std::size_t i = 0; i <= depth; ++i)
          prm.enter_subsection(sections[i]);
        declare_copy(copy, prm);
        for (std::size_t i = 0; i <= depth; ++i)
          prm.leave_subsection();
        (*node)[section] = copy;
      }
      node = &(*node)[section];
    }
    const std::vector<std::string> known = names(*node, true);
    const std::string &entry = assignment.entry;
    if (std::find(known.begin(), known.end(), entry) == known.end())
      throw InputError(
        assignment.origin + ": unknown entry " + quotation(entry) + " " +
        where(sections, sections.size()) +
        (assignment.origin == "--set" && entry.find('.') != std::string::npos
           ? "; a \"/\" separates section and entry: " +
               quotation(join(split(entry, '.'), "/"))
           : suggestion(entry, known) + remark_on(entry)));
    return (*node)[assignment.entry];
  }

  /// Whether a subsection is the pattern itself, "Region *", with the default
  /// of an entry, as --print-parameters prints it.
  /// @throws InputError for another value, which would have no effect
  bool is_of_pattern(const Assignment &assignment, const Tree &tree)
  {
    const auto &sections = assignment.sections;
    const auto star =
      std::find_if(sections.begin(), sections.end(), is_pattern);
    if (star == sections.end() || assignment.origin == "--set")
      return false;
    std::string path;
    for (const std::string &section : sections)
      path += "/" + section;
    const Tree::json_pointer place(path + "/" + assignment.entry);
    if (!tree.contains(place) || !is_entry(tree[place]))
      return false;
    if (tree[place]["default_value"] != assignment.value)
      throw InputError(assignment.origin + ": the * of subsection " +
                       quotation(*star) + " stands for a name of your own");
    return true;
  }

  void write_entry(const Tree &entry,
                   const std::string &name,
                   const std::string &indent,
                   const bool annotated,
                   std::ostream &out)
  {
    const auto text = [&](const char *field) {
      return entry[field].get<std::string>();
    };
    if (annotated)
    {
      const std::string allowed = plain_words(text("pattern_description"));
      std::string comment = text("documentation");
      if (!allowed.empty())
        comment += " Allowed: " + allowed + ".";
      if (text("value") != text("default_value"))
        comment += " Default: " + text("default_value");
      for (const std::string &line : wrap(comment, 76 - indent.size()))
        out << indent << "# " << line << '\n';
    }
    out << indent << "set " << name << " = " << text("value") << '\n';
  }

  void write_section(const Tree &node,
                     const std::string &indent,
                     const bool annotated,
                     std::ostream &out)
  {
    if (!node.is_object())
      return;
    bool first = true;
    for (const std::string &name : names(node, true))
    {
      if (annotated && !first)
        out << '\n';
      first = false;
      write_entry(node[name], name, indent, annotated, out);
    }
    for (const std::string &name : names(node, false))
    {
      if (is_pattern(name) && !annotated)
        continue;
      if (!first)
        out << '\n';
      first = false;
      if (is_pattern(name))
        out << indent << "# any number of times, a name for the *\n";
      out << indent << "subsection " << name << '\n';
      write_section(node[name], indent + "  ", annotated, out);
      out << indent << "end\n";
    }
  }

  /// Value of an assignment; the name of an existing file is made absolute.
  std::string resolve_file(const Assignment &assignment,
                           const std::string &description)
  {
    namespace fs = std::filesystem;
    if (description.find("[FileName ") != 0 || assignment.value.empty())
      return assignment.value;
    std::error_code ignored;
    for (const fs::path &folder : {fs::path(assignment.folder), fs::path()})
      if (fs::is_regular_file(folder / assignment.value, ignored))
        return fs::absolute(folder / assignment.value)
          .lexically_normal()
          .string();
    return assignment.value;
  }

  /// Number of letters at the beginning of @p text that make a number.
  std::size_t length_of_number(const std::string &text)
  {
    char *end = nullptr;
    std::strtod(text.c_str(), &end);
    return static_cast<std::size_t>(end - text.c_str());
  }

  /// Fault of @p value where numbers are wanted: a letter beyond
  /// ASCII, a unit, a comma as decimal separator; empty if none of these.
  std::string why_no_number(const std::string &value, const Tree &entry)
  {
    const auto pattern = entry["pattern_description"].get<std::string>();
    const bool is_list = pattern.find("[List of <") == 0 &&
                         pattern.find("[Double") != std::string::npos;
    if (!is_list && pattern.find("[Double") != 0 &&
        pattern.find("[Integer") != 0)
      return "";
    const std::string foreign = find_foreign_letter(value);
    if (!foreign.empty())
      return foreign;
    const std::string unit = unit_in(entry["documentation"]);
    std::string numbers = value;
    std::replace(numbers.begin(), numbers.end(), ';', ',');
    for (const std::string &item :
         is_list ? split(numbers, ',') : std::vector<std::string>{value})
    {
      const std::size_t end = length_of_number(item);
      const std::string rest = trim(item.substr(end));
      if (end > 0 && !is_list && rest.size() > 1 && rest[0] == ',' &&
          rest.find_first_not_of("0123456789", 1) == std::string::npos)
        return "the decimal separator is a point: " +
               quotation(item.substr(0, end) + "." + rest.substr(1));
      if (end > 0 && !rest.empty() &&
          std::isalpha(static_cast<unsigned char>(rest[0])) != 0)
        return "a number stands without its unit, here " +
               (unit.empty() || unit == "-" ? "none" : unit) + ": " +
               quotation(item.substr(0, end));
    }
    return "";
  }

  /// @throws InputError for letters that look like others, except in titles
  /// and names of files
  void require_plain_letters(const Assignment &assignment,
                             const std::string &pattern)
  {
    const bool is_free =
      assignment.entry == "Title" || pattern.find("[FileName ") == 0;
    const std::string found = is_free ? "" : find_lookalike(assignment.value);
    if (!found.empty())
      throw InputError(assignment.origin + ": the value of entry " +
                       quotation(assignment.entry) + " has " + found);
  }

  /// Error text: what the entry allows instead of the given value.
  std::string refusal(const Assignment &assignment, const Tree &entry)
  {
    const auto description = entry["pattern_description"].get<std::string>();
    std::vector<std::string> path = assignment.sections;
    path.push_back(assignment.entry);
    const std::string meant =
      nearest(assignment.value, choices_of(description));
    const std::string help = meant.empty()
                               ? "; allowed: "
                               : "; did you mean \"" + meant + "\"? Allowed: ";
    const std::string why = why_no_number(assignment.value, entry);
    return assignment.origin + ": entry \"" + join(path, "/") +
           "\" cannot be " + quotation(assignment.value) +
           (why.empty() ? "" : ": " + why) + help + plain_words(description);
  }

  void collect(const Tree &node,
               const std::string &path,
               std::map<std::string, std::string> &values)
  {
    if (!node.is_object())
      return;
    for (const auto &item : node.items())
      if (is_entry(item.value()))
        values[path + item.key()] = item.value()["value"].get<std::string>();
      else if (!is_pattern(item.key()))
        collect(item.value(), path + item.key() + "/", values);
  }

  void collect_assignments(const Tree &node,
                           std::vector<std::string> &sections,
                           std::vector<Assignment> &assignments)
  {
    if (!node.is_object())
      return;
    for (const auto &item : node.items())
      if (is_entry(item.value()))
        assignments.push_back({sections,
                               item.key(),
                               item.value()["value"].get<std::string>(),
                               "derived parameters"});
      else if (!is_pattern(item.key()))
      {
        sections.push_back(item.key());
        collect_assignments(item.value(), sections, assignments);
        sections.pop_back();
      }
  }
} // namespace

void apply_assignments(const std::vector<Assignment> &assignments,
                       ParameterHandler &prm)
{
  Tree tree = tree_of(prm);
  for (const Assignment &assignment : with_declared_names(assignments, prm))
  {
    if (is_of_pattern(assignment, tree))
      continue;
    const Tree &entry = find_entry(assignment, prm, tree);
    const auto description = entry["pattern_description"].get<std::string>();
    for (const std::string &section : assignment.sections)
      prm.enter_subsection(section);
    require_plain_letters(assignment, description);
    try
    {
      prm.set(assignment.entry, resolve_file(assignment, description));
    }
    catch (const ParameterHandler::ExcValueDoesNotMatchPattern &)
    {
      throw InputError(refusal(assignment, entry));
    }
    for (std::size_t i = 0; i < assignment.sections.size(); ++i)
      prm.leave_subsection();
  }
}

std::vector<std::string> item_names(const ParameterHandler &prm,
                                    const std::string &kind)
{
  const Tree tree = tree_of(prm);
  const Tree *node = &tree;
  std::vector<std::string> path = split(kind, '/');
  const std::string stem = path.back() + " ";
  path.pop_back();
  for (const std::string &section : path)
    node = &node->at(section);
  std::vector<std::string> items;
  for (const std::string &name : names(*node, false))
    if (!is_pattern(name) && name.compare(0, stem.size(), stem) == 0)
      items.push_back(name.substr(stem.size()));
  return items;
}

std::vector<Assignment> assignments_of(const ParameterHandler &prm)
{
  std::vector<std::string> sections;
  std::vector<Assignment> assignments;
  collect_assignments(tree_of(prm), sections, assignments);
  return assignments;
}

std::map<std::string, std::string> parameter_values(const ParameterHandler &prm)
{
  std::map<std::string, std::string> values;
  collect(tree_of(prm), "", values);
  return values;
}

std::string declared::text_of(const Tree &node, const bool annotated)
{
  std::ostringstream text;
  write_section(node, "", annotated, text);
  return text.str();
}

std::string parameter_text(const ParameterHandler &prm, const bool annotated)
{
  return declared::text_of(tree_of(prm), annotated);
}
} // namespace contrecoup
