// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/gauge_tables.h>
#include <contrecoup/numerics/injury/load_injury.h>

#include <map>

namespace contrecoup::gas
{
namespace
{
  const std::string chest = "chest", back = "back";

  std::string row(const std::string &measure,
                  const std::string &place,
                  const double value,
                  const std::string &unit,
                  const std::string &definition)
  {
    return join({measure, place, exact(value), unit, "\"" + definition + "\""},
                ",") +
           "\n";
  }


  bool is_ear(const std::string &place)
  {
    const std::string ending = "ear";
    return place.size() >= ending.size() &&
           place.compare(place.size() - ending.size(), ending.size(), ending) ==
             0;
  }


  std::string chest_wall_rows(const std::map<std::string, LoadInjury> &injuries)
  {
    std::string text;
    double sum = 0.;
    unsigned int n = 0;
    for (const std::string &place : {chest, back})
    {
      const auto found = injuries.find(place);
      if (found == injuries.end())
        continue;
      text += row("chest_wall_velocity",
                  place,
                  found->second.chest_wall_velocity,
                  "m/s",
                  "largest inward velocity of a mass on a spring before one "
                  "lung under the overpressure at this place (Axelsson and "
                  "Yelverton 1996)");
      sum += found->second.chest_wall_velocity;
      ++n;
    }
    if (n == 2)
      text += row("chest_wall_velocity",
                  chest + " and " + back,
                  sum / n,
                  "m/s",
                  "mean of the velocities at chest and back");
    return text;
  }
} // namespace


std::string gauge_measures_table(const std::vector<GaugeBlast> &gauges)
{
  std::string text = "place,arrival [s],peak [Pa],peak time [s],impulse [Pa "
                     "s],positive phase [s]\n";
  for (const GaugeBlast &gauge : gauges)
    text += join({gauge.place,
                  exact(gauge.blast.arrival),
                  exact(gauge.blast.peak),
                  exact(gauge.peak_time),
                  exact(gauge.blast.impulse),
                  exact(gauge.blast.duration)},
                 ",") +
            "\n";
  return text;
}


std::string gauge_injury_table(const std::vector<GaugeBlast> &gauges,
                               const std::vector<double> &times,
                               const double body_mass)
{
  std::map<std::string, LoadInjury> injuries;
  std::string ears;
  for (const GaugeBlast &gauge : gauges)
  {
    if (gauge.place != chest && gauge.place != back && !is_ear(gauge.place))
      continue;
    const LoadInjury injury =
      load_injury(times,
                  gauge.overpressures,
                  {gauge.blast.peak, gauge.blast.duration},
                  body_mass);
    injuries[gauge.place] = injury;
    if (is_ear(gauge.place))
      ears += row("eardrum_rupture",
                  gauge.place,
                  injury.eardrum_rupture,
                  "-",
                  "probability by the peak overpressure at this ear (Richmond "
                  "et al. 1989)");
  }
  std::string lung;
  const auto front = injuries.find(chest);
  if (front != injuries.end() && front->second.pulse.duration > 0.)
    lung = row("lung_exposure",
               chest,
               front->second.lung_exposure,
               "-",
               "peak overpressure over the one that half survive for this "
               "positive phase and body mass (Bowen et al. 1968)");
  const std::string rows = chest_wall_rows(injuries) + lung + ears;
  return rows.empty() ? "" : "measure,place,value,unit,definition\n" + rows;
}
} // namespace contrecoup::gas
