// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_answer.h>
#include <contrecoup/ale/lagrange/largest_mean.h>
#include <contrecoup/base/system/text.h>

#include <cmath>
#include <map>

namespace contrecoup::ale
{
namespace
{
  using Values = std::map<std::string, double>;

  std::string milliseconds(const double time)
  {
    return brief(1e3 * time, 3) + " ms";
  }

  std::string contact_line(const Values &values)
  {
    std::string line =
      "Impact at " + brief(values.at("impact_speed"), 3) + " m/s";
    const double normal = values.at("normal_impact_speed");
    if (std::abs(normal) < 0.999 * values.at("impact_speed"))
      line += ", " + brief(normal, 3) + " m/s along the normal of the plane";
    if (values.count("peak_contact_force") == 0)
      return line + ": nothing touches a plane until the end";
    const bool lasts = values.count("contact_cut_off") > 0;
    line += ": largest contact force " + std::string(lasts ? "so far " : "") +
            brief(values.at("peak_contact_force"), 3) + " N, a mean over " +
            brief(1e6 * LargestMean::span, 3) + " us, at " +
            milliseconds(values.at("peak_contact_force_time")) +
            ", contact from " + milliseconds(values.at("contact_begin"));
    return line + (lasts ? ", which lasts when the run ends"
                         : " to " + milliseconds(values.at("contact_end")));
  }

  /// A pressure after @p word, "so far" where it is a lower limit.
  std::string extreme(const std::string &word,
                      const std::string &name,
                      const Values &values)
  {
    return word + (values.count(name + "_cut_off") > 0 ? " so far " : " ") +
           brief(1e-3 * values.at(name), 3) + " kPa";
  }

  std::string pressure_line(const Values &values, const std::string &which)
  {
    std::string line = "Pressure in the brain, " + which + ": ";
    if (values.count("coup_pressure") == 0)
      return line +
             extreme("from", "injury_intracranial_pressure_lowest", values) +
             extreme(" to", "injury_intracranial_pressure_peak", values);
    return line + extreme("coup", "coup_pressure", values) + " at " +
           milliseconds(values.at("coup_pressure_time")) + ", " +
           extreme("contrecoup", "contrecoup_pressure", values) + " at " +
           milliseconds(values.at("contrecoup_pressure_time"));
  }
} // namespace


std::vector<std::string> answer_lines(const std::vector<NamedValue> &results,
                                      const bool has_planes,
                                      const std::string &pressures)
{
  Values values;
  for (const NamedValue &result : results)
    values[result.name] = result.value;
  std::vector<std::string> lines;
  if (has_planes && values.count("impact_speed") > 0)
    lines.push_back(contact_line(values));
  if (values.count("injury_intracranial_pressure_peak") > 0)
    lines.push_back(pressure_line(values, pressures));
  if (values.count("injury_strain_95") > 0)
    lines.push_back("95 % of the brain is strained by at most " +
                    brief(100. * values.at("injury_strain_95"), 3) + " %" +
                    (values.count("injury_strain_95_cut_off") == 0
                       ? ""
                       : " up to the end of the run, where strains may still "
                         "grow: a later Time/End time gives all of it"));
  if (values.count("injury_hic15") > 0)
    lines.push_back("HIC15 " +
                    std::string(values.count("injury_hic15_cut_off") == 0
                                  ? ""
                                  : "at least ") +
                    brief(values.at("injury_hic15"), 3));
  return lines;
}
} // namespace contrecoup::ale
