// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_names.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/own_thresholds.h>

#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace
{
  using Threshold = std::pair<double, std::string>;

  const std::string thresholds_entry = "Thresholds", source_entry = "Source";

  /// How reports name the source of thresholds that no publication has.
  const std::string own_source = "the user's own";

  constexpr double largest_threshold = 1e12;


  /// One "value: meaning".
  Threshold read_threshold(const std::string &text, const std::string &path)
  {
    const std::size_t colon = text.find(':');
    const std::string number = trim(text.substr(0, colon));
    const std::string meaning =
      colon == std::string::npos ? "" : trim(text.substr(colon + 1));
    if (!dealii::Patterns::Double().match(number) || meaning.empty())
      throw InputError(path + ": \"" + text +
                       "\" must be a value and what it means to exceed it, as "
                       "in \"300: concussion\"");
    return {dealii::Utilities::string_to_double(number), meaning};
  }


  /// @throws InputError for a value that the measure cannot have
  void check_range(const double value,
                   const InjuryCriterion &published,
                   const std::string &path)
  {
    const bool falls =
      !published.thresholds.empty() && published.thresholds[0].first < 0.;
    const double least = falls ? -largest_threshold : 0.,
                 most =
                   falls ? 0. : std::min(published.largest, largest_threshold);
    if (value == 0. || !(value >= least && value <= most))
      throw InputError(path + ": a threshold of this measure cannot be " +
                       brief(value) + "; allowed: " +
                       (falls ? "from " + brief(least) + ", below 0"
                              : "above 0, at most " + brief(most)) +
                       (published.unit != "-" ? " " + published.unit
                        : published.largest == 1.
                          ? ", a fraction or probability"
                          : ""));
  }


  std::vector<Threshold> read_thresholds(const std::string &text,
                                         const InjuryCriterion &published,
                                         const std::string &path)
  {
    std::vector<Threshold> list;
    for (const std::string &word : split(text, ';'))
      if (!word.empty())
      {
        list.push_back(read_threshold(word, path));
        check_range(list.back().first, published, path);
      }
    if (list.empty())
      throw InputError(path + " is missing, as in \"300: concussion; 800: "
                              "fracture of the skull\"");
    for (std::size_t i = 1; i < list.size(); ++i)
      if (!(std::abs(list[i].first) > std::abs(list[i - 1].first)))
        throw InputError(path + ": " + brief(list[i].first) + " after " +
                         brief(list[i - 1].first) +
                         "; thresholds must be in the order of increasing "
                         "severity");
    return list;
  }


  /// Text that a quoted field of a table can hold.
  std::string read_words(const ParameterHandler &prm,
                         const std::string &entry,
                         const std::string &path)
  {
    std::string text = trim(prm.get(entry));
    if (text.find('"') != std::string::npos)
      throw InputError(path + "/" + entry + " cannot have a quotation mark");
    return text;
  }
} // namespace


void OwnThresholds::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Measure *");
  declare_string(prm,
                 thresholds_entry,
                 "",
                 "Values that replace the published thresholds of this measure "
                 "(" +
                   join(injury_measures_of({"head", "chest", "gauges"}), ", ") +
                   "), and what it means to exceed each, in SI units, the "
                   "least severe first: \"300: concussion; 800: fracture\".");
  declare_string(prm,
                 source_entry,
                 "",
                 "Where they are from, for reports; empty: no more than that "
                 "they are the user's own.");
}


void OwnThresholds::parse_parameters(ParameterHandler &prm,
                                     const std::string &section)
{
  list_.clear();
  const std::vector<std::string> known =
    injury_measures_of({"head", "chest", "gauges"});
  for (const std::string &name : item_names(prm, section + "/Measure"))
  {
    Measure measure;
    measure.path = section + "/Measure " + name;
    measure.name = resolve_name(name, known);
    if (measure.name.empty())
    {
      const std::string meant = nearest(name, known);
      throw InputError(measure.path + ": there is no such measure of injury; " +
                       (meant.empty()
                          ? "known are "
                          : "did you mean \"" + meant + "\"? Known are ") +
                       join(known, ", "));
    }
    if (find(measure.name) != nullptr)
      throw InputError(measure.path + ": a second section of this measure");
    const Section outer(prm, section);
    const Section inner(prm, "Measure " + name);
    measure.text = read_words(prm, thresholds_entry, measure.path);
    measure.source = read_words(prm, source_entry, measure.path);
    measure.criterion = injury_criterion(measure.name);
    measure.criterion.thresholds =
      read_thresholds(measure.text,
                      injury_criterion(measure.name),
                      measure.path + "/" + thresholds_entry);
    measure.criterion.source =
      own_source + (measure.source.empty() ? "" : ": " + measure.source);
    measure.criterion.limits =
      "thresholds of the user's own; with those that are published: " +
      measure.criterion.limits;
    list_.push_back(measure);
  }
}


void OwnThresholds::require(const std::vector<std::string> &taken,
                            const std::string &reason) const
{
  for (const Measure &measure : list_)
    if (std::find(taken.begin(), taken.end(), measure.name) == taken.end())
      throw InputError(
        measure.path + ": this measure is not taken here" +
        (reason.empty() ? "" : " (" + reason + ")") + "; " +
        (taken.empty() ? "none is" : "those are " + join(taken, ", ")));
}


std::vector<std::string> OwnThresholds::measures() const
{
  std::vector<std::string> names;
  for (const Measure &measure : list_)
    names.push_back(measure.name);
  return names;
}


const OwnThresholds::Measure *OwnThresholds::find(const std::string &name) const
{
  const auto found =
    std::find_if(list_.begin(), list_.end(), [&](const Measure &measure) {
      return measure.name == name;
    });
  return found == list_.end() ? nullptr : &*found;
}


InjuryCriterion OwnThresholds::criterion(const std::string &measure) const
{
  const Measure *const own = find(measure);
  return own == nullptr ? injury_criterion(measure) : own->criterion;
}


std::string OwnThresholds::path(const std::string &measure) const
{
  return find(measure)->path;
}


std::vector<std::pair<std::string, std::string>>
OwnThresholds::entries(const std::string &measure) const
{
  const Measure &own = *find(measure);
  std::vector<std::pair<std::string, std::string>> list{
    {thresholds_entry, own.text}};
  if (!own.source.empty())
    list.emplace_back(source_entry, own.source);
  return list;
}


std::vector<Assumption> OwnThresholds::assumptions() const
{
  std::vector<Assumption> items;
  for (const Measure &own : list_)
    items.push_back({"own_" + own.name,
                     own.name + " with " + own.criterion.in_words(),
                     "first threshold, in place of the published ones",
                     own.criterion.unit,
                     own.criterion.thresholds[0].first,
                     std::numeric_limits<double>::quiet_NaN(),
                     false,
                     own.path});
  return items;
}
} // namespace contrecoup
