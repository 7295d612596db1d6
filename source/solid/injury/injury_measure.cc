// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/injury_criteria.h>
#include <contrecoup/solid/injury/injury_measure.h>

namespace contrecoup::solid
{
InjuryMeasure known_measure(const std::string &name, const double value)
{
  const InjuryCriterion &criterion = injury_criterion(name);
  return {
    {name, criterion.unit, value}, criterion.in_words(), criterion.limits};
}


std::string in_words(const InjuryMeasure &measure)
{
  const NamedValue &value = measure.value;
  const std::string sign = !measure.is_cut    ? " = "
                           : value.value < 0. ? " <= "
                                              : " >= ";
  return value.name + sign + brief(value.value) + " " + value.unit + " (" +
         measure.threshold + ")";
}


std::vector<NamedValue> values_of(const std::vector<InjuryMeasure> &measures)
{
  std::vector<NamedValue> values;
  for (const InjuryMeasure &measure : measures)
  {
    values.push_back(measure.value);
    if (measure.is_cut)
      values.push_back({measure.value.name + "_cut_off", "-", 1.});
  }
  return values;
}


void apply(const OwnThresholds &own, std::vector<InjuryMeasure> &measures)
{
  for (const std::string &name : own.measures())
    for (InjuryMeasure &measure : measures)
      if (measure.value.name == name)
      {
        const InjuryCriterion criterion = own.criterion(name);
        const std::string published = injury_criterion(name).limits;
        measure.threshold = criterion.in_words();
        // Other limits of the measure stay.
        measure.limits.replace(
          measure.limits.find(published), published.size(), criterion.limits);
      }
}


void limit_to_impact(std::vector<InjuryMeasure> &measures)
{
  for (const std::string &name : injury_measures_of({"head"}))
    for (InjuryMeasure &measure : measures)
      if (measure.value.name == name)
      {
        const InjuryCriterion &published = injury_criterion(name);
        if (const auto begin = measure.limits.find(published.limits);
            begin != std::string::npos)
          measure.limits.replace(
            begin, published.limits.size(), published.limits_of_impact);
      }
}


std::vector<InjuryMeasure> probabilities_of(const InjuryMeasure &measure)
{
  std::vector<InjuryMeasure> list;
  for (const std::string &name : injury_criterion(measure.value.name).curves)
  {
    const InjuryCurve &curve = injury_curve(name);
    list.push_back(
      {{"injury_" + name, "-", curve.probability(measure.value.value)},
       "probability of " + curve.event + " (" + curve.source + ")",
       curve.valid});
  }
  return list;
}
} // namespace contrecoup::solid
