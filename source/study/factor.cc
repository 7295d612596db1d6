// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/study/factor.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <set>

namespace contrecoup::study
{
namespace
{
  /// Splits @p text, keeping an empty last part: "a |" has two.
  std::vector<std::string> cells_of_row(const std::string &text)
  {
    std::vector<std::string> parts = {""};
    for (const char letter : text)
      if (letter == '|')
        parts.emplace_back();
      else
        parts.back() += letter;
    for (std::string &part : parts)
      part = trim(part);
    return parts;
  }

  /// Parts between semicolons; a final semicolon adds none.
  std::vector<std::string> rows(const std::string &text)
  {
    std::vector<std::string> parts = split(text, ';');
    while (!parts.empty() && parts.back().empty())
      parts.pop_back();
    return parts;
  }

  /// Parses "a to b" or "a to b logarithmic". Returns whether it matches.
  bool read_range(const std::string &text, Factor &factor)
  {
    const std::size_t middle = text.find(" to ");
    if (middle == std::string::npos)
      return false;
    std::string upper = trim(text.substr(middle + 4));
    const std::string word = "logarithmic";
    factor.logarithmic =
      upper.size() > word.size() &&
      upper.compare(upper.size() - word.size(), word.size(), word) == 0;
    if (factor.logarithmic)
      upper = trim(upper.substr(0, upper.size() - word.size()));
    factor.lower = leading_number(trim(text.substr(0, middle)));
    factor.upper = leading_number(upper);
    return !std::isnan(factor.lower) && !std::isnan(factor.upper);
  }

  std::vector<std::string> name_rows(const Factor &factor)
  {
    std::vector<std::string> labels;
    for (const auto &row : factor.values)
    {
      std::vector<std::string> texts;
      for (const std::string &text : row)
        if (!text.empty())
          texts.push_back(text);
      labels.push_back(texts.empty() ? "as in the file" : join(texts, ", "));
    }
    return labels;
  }

  Refinement refinement_of(const std::string &word)
  {
    return word == "by level"   ? Refinement::by_level
           : word == "by count" ? Refinement::by_count
           : word == "by size"  ? Refinement::by_size
                                : Refinement::none;
  }
} // namespace

double leading_number(const std::string &text)
{
  const char *begin = text.c_str();
  char *end = nullptr;
  const double number = std::strtod(begin, &end);
  const bool is_number = end != begin && (*end == '\0' || *end == ',');
  return is_number ? number : std::numeric_limits<double>::quiet_NaN();
}

void Factor::declare_parameters(ParameterHandler &prm)
{
  declare_string(
    prm,
    "Entry",
    "",
    selecting("The varied entry, \"Section/Subsection/Entry\"; several "
              "entries that change together are separated by \"|\"."));
  declare_string(prm,
                 "Values",
                 "",
                 "Values, separated by \";\"; with several entries, each "
                 "value has one text per entry, separated by \"|\", where "
                 "an empty text leaves the entry as in the parameter file. "
                 "For a Latin hypercube also a range: \"0.1 to 0.9\" or \"1 "
                 "to 1e6 logarithmic\".");
  declare_string(prm,
                 "Labels",
                 "",
                 "Names of the values in tables and pictures, separated by "
                 "\";\"; empty: the values.");
  declare_selection(prm,
                    "Refinement",
                    "none",
                    {"none", "by level", "by count", "by size"},
                    "Whether the values refine the mesh: by level (each "
                    "level halves the mesh width), by count (cells along an "
                    "edge), or by size (cell size). Lines in pictures and "
                    "orders follow this factor.");
}

void Factor::parse_parameters(ParameterHandler &prm,
                              const std::string &item_name)
{
  const std::string where = "Vary " + item_name + "/";
  name = item_name;
  entries = cells_of_row(prm.get("Entry"));
  for (const std::string &entry : entries)
    if (entry.empty())
      throw InputError(where + "Entry must name an entry as in "
                               "\"Section/Subsection/Entry\"");
  refinement = refinement_of(prm.get("Refinement"));
  const std::string text = prm.get("Values");
  is_range = entries.size() == 1 && read_range(text, *this);
  if (is_range)
  {
    if (!(lower < upper) || (logarithmic && !(lower > 0.)))
      throw InputError(
        where + "Values: the range \"" + text + "\" must rise" +
        (logarithmic ? " and be above 0 to be logarithmic" : ""));
    return;
  }
  for (const std::string &row : rows(text))
  {
    values.push_back(cells_of_row(row));
    if (values.back().size() != entries.size())
      throw InputError(where + "Values: \"" + row + "\" has " +
                       std::to_string(values.back().size()) +
                       " parts between \"|\", but Entry names " +
                       std::to_string(entries.size()) + " entries");
  }
  if (values.empty())
    throw InputError(where + "Values must hold at least one value");
  labels = rows(prm.get("Labels"));
  if (labels.empty())
    labels = name_rows(*this);
  if (labels.size() != values.size())
    throw InputError(where + "Labels: there are " +
                     std::to_string(labels.size()) + " labels for " +
                     std::to_string(values.size()) + " values");
  require_different(where);
}

void Factor::require_different(const std::string &where) const
{
  std::set<std::vector<std::string>> known;
  for (const auto &row : values)
    if (!known.insert(row).second)
      throw InputError(where + "Values: \"" + join(row, " | ") +
                       "\" is there twice");
  std::set<std::string> names;
  for (const std::string &label : labels)
    if (!names.insert(label).second)
      throw InputError(where + "Labels: \"" + label + "\" is there twice");
}

Settings Factor::settings(const std::size_t row) const
{
  Settings result;
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (!values[row][i].empty())
      result.emplace_back(entries[i], values[row][i]);
  return result;
}

double Factor::number(const std::size_t row) const
{
  const double of_value = leading_number(values[row].front());
  // The mesh width follows from the value, regardless of its label.
  if (refinement != Refinement::none)
    return of_value;
  const double of_label = leading_number(labels[row]);
  return std::isnan(of_label) ? of_value : of_label;
}

bool Factor::always_sets(const std::size_t entry) const
{
  return std::all_of(values.begin(), values.end(), [&](const auto &row) {
    return entry < row.size() && !row[entry].empty();
  });
}

std::vector<Factor> parse_factors(ParameterHandler &prm)
{
  std::vector<Factor> factors;
  std::map<std::string, std::string> varied_by;
  unsigned int n_refining = 0;
  for (const std::string &name : item_names(prm, "Vary"))
  {
    const Section section(prm, "Vary " + name);
    factors.emplace_back();
    factors.back().parse_parameters(prm, name);
    for (std::size_t i = 0; i < factors.back().entries.size(); ++i)
      if (const std::string &entry = factors.back().entries[i];
          !varied_by.emplace(entry, name).second &&
          factors.back().always_sets(i))
        throw InputError("\"Vary " + varied_by[entry] + "\" and \"Vary " +
                         name + "\" both vary \"" + entry + "\"");
    if (factors.back().refinement != Refinement::none)
      ++n_refining;
    for (std::size_t row = 0; row < factors.back().values.size(); ++row)
      if (factors.back().refinement != Refinement::none &&
          std::isnan(factors.back().number(row)))
        throw InputError("Vary " + name + "/Values: \"" +
                         factors.back().values[row].front() +
                         "\" is no number and refines nothing");
      else if (factors.back().refinement == Refinement::by_size &&
               !(factors.back().number(row) > 0.))
        throw InputError("Vary " + name +
                         "/Values: the size of a cell must "
                         "be above 0");
  }
  if (factors.empty())
    throw InputError("there is nothing to vary; a subsection \"Vary NAME\" "
                     "names an entry and its values");
  if (n_refining > 1)
    throw InputError("only one subsection \"Vary *\" can have a Refinement; "
                     "entries that refine together stand in one, separated "
                     "by \"|\"");
  return factors;
}

Settings parse_settings(const std::string &text, const std::string &where)
{
  Settings settings;
  for (const std::string &part : rows(text))
  {
    const std::size_t equals = part.find('=');
    const std::string entry = trim(part.substr(0, equals));
    if (equals == std::string::npos || entry.empty())
      throw InputError(where + ": \"" + part +
                       "\" is not of the form \"Section/Entry=value\"");
    settings.emplace_back(entry, trim(part.substr(equals + 1)));
  }
  return settings;
}
} // namespace contrecoup::study
