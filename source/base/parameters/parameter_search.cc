// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/allowed_values.h>
#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/parameter_search.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>

#include <boost/algorithm/string/case_conv.hpp>
#include <nlohmann/json.hpp>

#include <functional>

namespace contrecoup
{
namespace
{
  using declared::is_entry;
  using declared::Tree;

  /// Whether an item of this path is wanted; of sections with all they hold.
  using Filter =
    std::function<bool(const std::vector<std::string> &path, const Tree &item)>;

  /// Copy of @p node with what the filter wants.
  Tree pruned(const Tree &node,
              const Filter &is_wanted,
              const std::vector<std::string> &path = {})
  {
    Tree result = Tree::object();
    if (!node.is_object())
      return result;
    for (const auto &item : node.items())
    {
      std::vector<std::string> here = path;
      here.push_back(item.key());
      if (is_wanted(here, item.value()))
        result[item.key()] = item.value();
      else if (!is_entry(item.value()))
      {
        Tree part = pruned(item.value(), is_wanted, here);
        if (!part.empty())
          result[item.key()] = std::move(part);
      }
    }
    return result;
  }

  /// Whether @p path ends with the names of @p wanted.
  bool ends_with(const std::vector<std::string> &path,
                 const std::vector<std::string> &wanted)
  {
    if (wanted.empty() || path.size() < wanted.size())
      return false;
    const std::size_t first = path.size() - wanted.size();
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (resolve_name(wanted[i], {path[first + i]}).empty() &&
          resolve_name(wanted[i] + " *", {path[first + i]}).empty())
        return false;
    return true;
  }

  bool has_words(const std::string &text, const std::vector<std::string> &words)
  {
    const std::string letters = boost::to_lower_copy(text);
    for (const std::string &word : words)
      if (letters.find(word) == std::string::npos)
        return false;
    return true;
  }

  /// Names of all sections and entries.
  void collect_names(const Tree &node, std::vector<std::string> &names)
  {
    for (const bool entries : {false, true})
      for (const std::string &name : declared::names(node, entries))
      {
        names.push_back(name);
        if (!entries)
          collect_names(node[name], names);
      }
  }

  /// The part of @p tree that is wanted, see find_parameters().
  Tree find(const Tree &tree, const std::string &what)
  {
    const std::vector<std::string> wanted = split(what, '/');
    Tree found = pruned(tree, [&](const auto &path, const Tree &) {
      return ends_with(path, wanted);
    });
    if (!found.empty())
      return found;
    const std::vector<std::string> words =
      split(boost::to_lower_copy(trim(what)), ' ');
    found = pruned(tree, [&](const auto &path, const Tree &item) {
      return is_entry(item) &&
             has_words(path.back() + " " +
                         item["documentation"].template get<std::string>(),
                       words);
    });
    if (!found.empty())
      return found;
    std::vector<std::string> names;
    collect_names(tree, names);
    throw InputError("--print-parameters: no section or entry is called " +
                     quotation(what) + ", and no help text has it" +
                     suggestion(what, names));
  }

  /// A bound as the number that it is; null if there is none.
  Tree bound(const std::string &text)
  {
    return text.empty() ? Tree() : Tree::parse(text);
  }

  /// Adds what a program wants to know of each entry.
  void add_details(Tree &node)
  {
    if (!is_entry(node))
    {
      for (auto &item : node)
        add_details(item);
      return;
    }
    const auto pattern = node["pattern_description"].get<std::string>();
    node["allowed"] = plain_words(pattern);
    if (is_of_numbers(pattern))
    {
      const std::string unit = unit_in(node["documentation"]);
      if (!unit.empty())
        node["unit"] = unit;
      const auto [least, most] = range_of(pattern);
      node["range"] = {bound(least), bound(most)};
    }
    if (const auto choices = choices_of(pattern); !choices.empty())
      node["choices"] = choices;
  }
} // namespace


std::string find_parameters(const dealii::ParameterHandler &prm,
                            const std::string &what,
                            const ParameterForm form)
{
  Tree tree = declared::tree_of(prm);
  if (!what.empty())
    tree = find(tree, what);
  if (form == ParameterForm::text)
    return declared::text_of(tree, true);
  add_details(tree);
  return tree.dump(2);
}
} // namespace contrecoup
