// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/injury_criteria.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace contrecoup
{
namespace
{
  // The text of injury_criteria.json.
  const char *const text =
#include <contrecoup/numerics/injury/injury_criteria.inc>
    ;

  const nlohmann::json &data()
  {
    static const nlohmann::json parsed = nlohmann::json::parse(text);
    return parsed;
  }


  /// A range of a measure with its meaning; ranges may overlap.
  struct Level
  {
    std::string meaning;
    double begin, end;
  };


  std::vector<std::pair<double, std::string>>
  thresholds_of(const std::vector<Level> &levels)
  {
    std::set<double> edges;
    for (const Level &level : levels)
      edges.insert({level.begin, level.end});
    std::vector<std::pair<double, std::string>> thresholds;
    for (const double edge : edges)
    {
      std::vector<std::string> meanings;
      for (const Level &level : levels)
        if (level.begin <= edge && edge < level.end)
          meanings.push_back(level.meaning);
      if (!meanings.empty())
        thresholds.emplace_back(edge, join(meanings, " or "));
    }
    return thresholds;
  }


  InjuryCriterion criterion_of(const nlohmann::json &measure)
  {
    InjuryCriterion criterion;
    if (measure.contains("levels"))
    {
      std::vector<Level> levels;
      for (const nlohmann::json &level : measure["levels"])
        levels.push_back({level[0],
                          level[1],
                          level[2].is_null()
                            ? std::numeric_limits<double>::infinity()
                            : level[2].get<double>()});
      criterion.thresholds = thresholds_of(levels);
    }
    else
      for (const nlohmann::json &threshold : measure["thresholds"])
        criterion.thresholds.emplace_back(threshold[0], threshold[1]);
    criterion.source =
      data()["sources"].at(measure["source"].get<std::string>());
    criterion.limits = measure["limits"];
    criterion.limits_of_impact =
      measure.value("limits_of_impact", criterion.limits);
    criterion.unit = measure["unit"];
    criterion.of = measure["of"];
    criterion.largest =
      measure.value("largest", std::numeric_limits<double>::infinity());
    if (measure.contains("curves"))
      criterion.curves = measure["curves"].get<std::vector<std::string>>();
    return criterion;
  }


  const std::map<std::string, InjuryCriterion> &criteria()
  {
    static const std::map<std::string, InjuryCriterion> known = [] {
      std::map<std::string, InjuryCriterion> list;
      for (const auto &[name, measure] : data()["measures"].items())
        list[name] = criterion_of(measure);
      return list;
    }();
    return known;
  }


  /// Part of the standard normal distribution below @p deviation.
  double normal_part_below(const double deviation)
  {
    return 0.5 * std::erfc(-deviation / std::sqrt(2.));
  }


  std::map<std::string, InjuryCurve> read_curves()
  {
    std::map<std::string, InjuryCurve> list;
    for (const auto &[name, curve] : data()["curves"].items())
      list[name] = {name,
                    curve.value("event", ""),
                    data()["sources"].at(curve["source"].get<std::string>()),
                    curve["valid"]};
    return list;
  }
} // namespace


double InjuryCurve::probability(const double value) const
{
  if (!(value > 0.))
    return 0.;
  const std::string law = data()["curves"][name]["law"];
  const auto constant = [&](const char *const of) {
    return injury_curve_constant(name, of);
  };
  if (law == "lognormal")
  {
    const double own = normal_part_below((std::log(value) - constant("mean")) /
                                         constant("deviation"));
    // Fits of different deviation cross; an event that includes another one is
    // at least as probable.
    const auto &curve = data()["curves"][name];
    return curve.contains("includes")
             ? std::max(own,
                        injury_curve(curve["includes"].get<std::string>())
                          .probability(value))
             : own;
  }
  if (law == "probit")
    return normal_part_below(constant("intercept") +
                             constant("slope") * std::log(value) - 5.);
  if (law == "weibull")
    return -std::expm1(
      -std::pow(value / constant("scale"), constant("exponent")));
  throw InputError("the curve \"" + name + "\" is no probability");
}


const InjuryCurve &injury_curve(const std::string &name)
{
  static const std::map<std::string, InjuryCurve> known = read_curves();
  const auto found = known.find(name);
  if (found == known.end())
    throw InputError("there is no curve of injury \"" + name + "\"");
  return found->second;
}


double injury_curve_constant(const std::string &curve, const std::string &name)
{
  injury_curve(curve);
  return data()["curves"][curve].at(name);
}


std::string InjuryCriterion::meaning(const double value) const
{
  std::string worst = "none";
  for (const auto &[limit, words] : thresholds)
    if (limit < 0. ? value < limit : value > limit)
      worst = words;
  return worst;
}


std::string InjuryCriterion::in_words() const
{
  std::vector<std::string> words;
  for (const auto &[limit, meaning] : thresholds)
    words.push_back(brief(limit, 6) + (unit == "-" ? "" : " " + unit) + ": " +
                    meaning);
  return thresholds.empty() ? "no threshold (" + source + ")"
                            : join(words, "; ") + " (" + source + ")";
}


const InjuryCriterion &injury_criterion(const std::string &name)
{
  const auto found = criteria().find(name);
  if (found == criteria().end())
    throw InputError("there is no measure of injury \"" + name + "\"");
  return found->second;
}


std::vector<std::string>
injury_measures_of(const std::vector<std::string> &kinds)
{
  std::vector<std::string> names;
  for (const auto &[name, criterion] : criteria())
    if (std::find(kinds.begin(), kinds.end(), criterion.of) != kinds.end())
      names.push_back(name);
  return names;
}
} // namespace contrecoup
