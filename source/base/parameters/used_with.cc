// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/text.h>

#include <boost/algorithm/string/predicate.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <regex>
#include <set>

namespace contrecoup
{
namespace
{
  using declared::Tree;

  const std::string mark = " Used with ";

  /// Conditions of the present scopes, the outermost first.
  std::vector<std::string> &conditions()
  {
    static std::vector<std::string> list;
    return list;
  }


  struct Condition
  {
    std::vector<std::string> entries;
    bool is_negated = false;
    std::vector<std::string> values;
  };


  /// Splits at " or ".
  std::vector<std::string> alternatives(const std::string &text)
  {
    return split(boost::replace_all_copy(text, " or ", "|"), '|');
  }


  /// Conditions in a help text, the outermost first.
  std::vector<Condition> conditions_of(const std::string &documentation)
  {
    static const std::regex form(mark + "([^.=]+?) (=|not) ([^.]+)\\.");
    std::vector<Condition> found;
    for (std::sregex_iterator match(
           documentation.begin(), documentation.end(), form);
         match != std::sregex_iterator();
         ++match)
      found.push_back({alternatives((*match)[1]),
                       (*match)[2] == "not",
                       split((*match)[3], ',')});
    std::reverse(found.begin(), found.end());
    return found;
  }


  bool is_same(const std::string &value, const std::string &other)
  {
    if (value == other || (value.empty() && other == "empty"))
      return true;
    char *end = nullptr, *other_end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    const double other_number = std::strtod(other.c_str(), &other_end);
    return !value.empty() && !other.empty() && *end == '\0' &&
           *other_end == '\0' && number == other_number;
  }


  /// Whether a value, or the word of one item of "1: word, 2: word", is one of
  /// the condition.
  bool is_among(const std::string &value, const Condition &condition)
  {
    std::vector<std::string> words = {trim(value)};
    for (const std::string &item : split(value, ','))
      words.push_back(trim(item.substr(item.rfind(':') + 1)));
    return std::any_of(words.begin(), words.end(), [&](const auto &word) {
      return std::any_of(condition.values.begin(),
                         condition.values.end(),
                         [&](const auto &one) { return is_same(word, one); });
    });
  }


  /// Path of @p name as seen from an entry in @p sections; empty: there is
  /// none.
  std::string resolve(const Tree &tree,
                      std::vector<std::string> sections,
                      const std::string &name)
  {
    for (;; sections.pop_back())
    {
      const std::string path =
        (sections.empty() ? "" : join(sections, "/") + "/") + name;
      const Tree::json_pointer place("/" + path);
      if (tree.contains(place) && declared::is_entry(tree[place]))
        return path;
      if (sections.empty())
        return "";
    }
  }


  std::string value_at(const Tree &tree, const std::string &path)
  {
    return tree[Tree::json_pointer("/" + path)]["value"].get<std::string>();
  }


  /// Why an entry is not used; without text it is.
  struct Reason
  {
    std::string text;
    std::vector<std::string> choices; ///< paths of the entries that it names
  };


  /// Why the condition does not hold for an entry in @p sections; without text
  /// it does, or names no entry of this application.
  Reason find_reason(const Tree &tree,
                     const std::vector<std::string> &sections,
                     const Condition &condition)
  {
    std::vector<std::string> paths, is;
    for (const std::string &name : condition.entries)
    {
      const std::string path = resolve(tree, sections, name);
      if (path.empty())
        continue;
      const std::string value = value_at(tree, path);
      if (is_among(value, condition) != condition.is_negated)
        return {};
      paths.push_back(path);
      is.push_back(value.empty() ? "empty" : value);
    }
    if (paths.empty())
      return {};
    const bool differ =
      std::any_of(is.begin(), is.end(), [&](const auto &value) {
        return value != is.front();
      });
    std::string reason = paths.front() + " is " + is.front();
    for (std::size_t i = 1; i < paths.size(); ++i)
      reason += " and " + paths[i] + " is " + is[i];
    if (!differ && paths.size() > 1)
      reason = join(paths, " and ") + " are " + is.front();
    return {reason + (condition.is_negated
                        ? ""
                        : ", not " + join(condition.values, " or ")),
            paths};
  }


  /// Why an entry that differs from its default is not used.
  Reason why_unused(const Tree &tree,
                    const std::vector<std::string> &sections,
                    const std::string &path)
  {
    const Tree::json_pointer place("/" + path);
    // The "*" of a pattern is no item.
    if (!tree.contains(place))
      return {};
    const auto text = [&](const char *field) {
      return tree[place][field].get<std::string>();
    };
    if (is_same(text("value"), text("default_value")))
      return {};
    for (const Condition &condition : conditions_of(text("documentation")))
    {
      Reason reason = find_reason(tree, sections, condition);
      if (!reason.text.empty())
        return reason;
    }
    return {};
  }


  std::string path_of(const Assignment &assignment)
  {
    std::vector<std::string> words = assignment.sections;
    words.push_back(assignment.entry);
    return join(words, "/");
  }

  bool is_included(const Assignment &assignment)
  {
    return boost::algorithm::ends_with(assignment.origin, ", included");
  }
} // namespace


UsedWith::UsedWith(const std::string &condition)
{
  conditions().push_back(condition);
}


UsedWith::~UsedWith()
{
  conditions().pop_back();
}


std::string UsedWith::annotate(const std::string &sentence)
{
  std::string text = sentence;
  for (auto outer = conditions().rbegin(); outer != conditions().rend();
       ++outer)
    text = used_with(*outer, text);
  return text;
}


std::string used_with(const std::string &condition, const std::string &sentence)
{
  return sentence + mark + condition + ".";
}


std::vector<std::string> find_unused(const dealii::ParameterHandler &prm,
                                     const std::vector<Assignment> &assignments)
{
  const Tree tree = declared::tree_of(prm);
  std::vector<std::string> reasons;
  std::map<std::string, std::vector<std::string>> entries;
  std::map<std::string, std::size_t> last;
  for (std::size_t i = 0; i < assignments.size(); ++i)
    last[path_of(assignments[i])] = i;
  for (std::size_t i = 0; i < assignments.size(); ++i)
  {
    const std::string path = path_of(assignments[i]);
    if (last[path] != i || is_included(assignments[i]))
      continue;
    const auto [reason, choices] =
      why_unused(tree, assignments[i].sections, path);
    const auto is_overridden = [&](const std::string &choice) {
      const auto found = last.find(choice);
      return found != last.end() &&
             assignments[found->second].origin == "--set";
    };
    if (reason.empty() ||
        (assignments[i].origin != "--set" &&
         std::any_of(choices.begin(), choices.end(), is_overridden)))
      continue;
    if (entries.count(reason) == 0)
      reasons.push_back(reason);
    entries[reason].push_back(path);
  }
  std::vector<std::string> warnings;
  for (const std::string &reason : reasons)
    warnings.push_back(unused_warning(entries[reason], reason));
  return warnings;
}


std::string unused_warning(const std::vector<std::string> &entries,
                           const std::string &reason)
{
  return "WARNING: " + join(entries, ", ") +
         (entries.size() == 1 ? " is" : " are") +
         " set but not used: " + reason;
}
} // namespace contrecoup
