// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/injury/kingery_bulmash.h>
#include <contrecoup/solid/boundary/analytic_blast.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>

namespace contrecoup::solid
{
using dealii::Point;
using dealii::Tensor;

const std::vector<std::string> AnalyticBlast::kinds{"friedlander",
                                                    "kingery bulmash"};

namespace
{
  void declare_friedlander(ParameterHandler &prm)
  {
    const Section section(prm, "Friedlander");
    const UsedWith used("Kind = friedlander");
    declare_double(prm,
                   "Peak",
                   "1e5",
                   1e-6,
                   1e12,
                   "Pa",
                   "Peak overpressure of the incident wave at its arrival.");
    declare_double(prm,
                   "Duration",
                   "2e-3",
                   1e-12,
                   1e6,
                   "s",
                   "Duration of the positive phase, everywhere the same.");
    declare_double(
      prm, "Decay", "1", 0., 1e3, "-", "b in P (1 - s/T) exp(-b s/T).");
    declare_list(
      prm,
      "Centre",
      "1e3, 0, 0",
      3,
      3,
      -1e9,
      1e9,
      "m",
      "Position of the charge; a distant charge gives a plane front.");
    declare_double(
      prm, "Speed", "400", 1e-3, 1e9, "m/s", "Constant speed of the front.");
    declare_double(prm,
                   "First distance",
                   "0",
                   0.,
                   1e9,
                   "m",
                   "Distance of the front from the charge at time 0.");
    declare_selection(prm,
                      "Reflection",
                      "normal shock",
                      {"none", "normal shock"},
                      "Whether facets that face the charge feel the peak of "
                      "a normally reflected shock in air, with the same "
                      "duration and decay.");
    declare_double(
      prm,
      "Ambient pressure",
      "101325",
      1.,
      1e9,
      "Pa",
      used_with("Reflection = normal shock",
                "Ambient pressure of the air, for the reflected shock."));
    declare_bool(prm,
                 "Negative phase",
                 "false",
                 "Whether the pulse continues below the ambient pressure "
                 "after its positive phase.");
  }

  void declare_tables(ParameterHandler &prm)
  {
    const Section section(prm, "Kingery Bulmash");
    const UsedWith used("Kind = kingery bulmash");
    declare_double(
      prm, "Mass", "1", 1e-9, 1e9, "kg", "TNT mass of the charge.");
    declare_list(prm,
                 "Centre",
                 "3, 0, 0",
                 3,
                 3,
                 -1e9,
                 1e9,
                 "m",
                 "Position of the charge.");
    declare_selection(prm,
                      "Set",
                      "spherical",
                      KingeryBulmash::sets,
                      "Tables: spherical charge in free air, hemispherical "
                      "on rigid ground, or simpler fits for the latter.");
    declare_double(prm,
                   "Start time",
                   "0",
                   0.,
                   1e6,
                   "s",
                   "Time from detonation to the start of the run.");
  }
} // namespace


void AnalyticBlast::declare_parameters(ParameterHandler &prm)
{
  declare_friedlander(prm);
  declare_tables(prm);
}


std::shared_ptr<AnalyticBlast>
AnalyticBlast::parse_parameters(ParameterHandler &prm,
                                const std::string &kind,
                                const std::string &path)
{
  auto blast = std::make_shared<AnalyticBlast>();
  blast->path_ = path;
  if (kind == kinds[0])
    blast->parse_friedlander(prm);
  else
    blast->parse_tables(prm);
  return blast;
}


void AnalyticBlast::parse_friedlander(ParameterHandler &prm)
{
  const Section section(prm, "Friedlander");
  pulse_.peak = read_double(prm, "Peak");
  pulse_.duration = read_double(prm, "Duration");
  pulse_.decay = read_double(prm, "Decay");
  centre_ = read_point<3>(prm, "Centre");
  speed_ = read_double(prm, "Speed");
  first_distance_ = read_double(prm, "First distance");
  if (prm.get("Reflection") != "none")
    ambient_ = read_double(prm, "Ambient pressure");
  negative_phase_ = prm.get_bool("Negative phase");
}


void AnalyticBlast::parse_tables(ParameterHandler &prm)
{
  const Section section(prm, "Kingery Bulmash");
  from_tables_ = true;
  mass_ = read_double(prm, "Mass");
  centre_ = read_point<3>(prm, "Centre");
  set_ = prm.get("Set");
  start_time_ = read_double(prm, "Start time");
}


AnalyticBlast::Waves AnalyticBlast::waves(const double distance) const
{
  if (!from_tables_)
  {
    Waves waves{pulse_, pulse_};
    waves.incident.arrival = (distance - first_distance_) / speed_;
    waves.reflected = waves.incident;
    if (ambient_ > 0.)
      waves.reflected.peak = reflected_overpressure(pulse_.peak, ambient_);
    return waves;
  }
  const KingeryBulmash tables(set_, mass_);
  const auto value = [&](const BlastQuantity quantity) {
    if (!tables.covers(quantity, distance))
      throw InputError(path_ + "/Kingery Bulmash: a loaded facet is " +
                       brief(distance) +
                       " m from the charge, which the tables do not cover for "
                       "this mass; move the charge, or leave the facet out by "
                       "Where");
    return tables.value(quantity, distance);
  };
  const double arrival = value(BlastQuantity::arrival) - start_time_;
  const double duration = value(BlastQuantity::duration);
  return {friedlander_pulse(arrival,
                            value(BlastQuantity::overpressure),
                            duration,
                            value(BlastQuantity::impulse)),
          friedlander_pulse(arrival,
                            value(BlastQuantity::reflected_overpressure),
                            duration,
                            value(BlastQuantity::reflected_impulse))};
}


void AnalyticBlast::set_surface(
  const std::vector<std::array<Point<3>, 4>> &facets,
  const MPI_Comm communicator)
{
  std::vector<double> mine;
  for (const auto &corners : facets)
    for (const Point<3> &corner : corners)
      for (unsigned int d = 0; d < 3; ++d)
        mine.push_back(corner[d]);
  std::vector<LineOfSight::Triangle> triangles;
  for (const auto &numbers : gather_arrays<double>(communicator, mine))
    for (std::size_t i = 0; i + 12 <= numbers.size(); i += 12)
    {
      std::array<Point<3>, 4> x;
      for (unsigned int v = 0; v < 4; ++v)
        for (unsigned int d = 0; d < 3; ++d)
          x[v][d] = numbers[i + 3 * v + d];
      triangles.push_back({{x[0], x[1], x[2]}});
      triangles.push_back({{x[0], x[2], x[3]}});
    }
  sight_.emplace(std::move(triangles));
}


bool AnalyticBlast::sees_charge(const Point<3> &middle, const double size) const
{
  // Facets are warped: a tenth of their size before them, none is in its own
  // way.
  const Tensor<1, 3> way = centre_ - middle;
  const double distance = way.norm();
  return !sight_ || distance <= 0.1 * size ||
         !sight_->is_blocked(middle + 0.1 * size / distance * way, centre_);
}


void AnalyticBlast::reinit(const std::vector<Point<3>> &middles,
                           const std::vector<Tensor<1, 3>> &areas,
                           const MPI_Comm communicator)
{
  communicator_ = communicator;
  facets_.clear();
  for (std::size_t i = 0; i < middles.size(); ++i)
  {
    const Tensor<1, 3> way = centre_ - middles[i];
    const double distance = way.norm();
    const double area = areas[i].norm();
    const double cosine = way * areas[i] / std::max(distance * area, 1e-300);
    const bool is_lit = cosine > 0. && sees_charge(middles[i], std::sqrt(area));
    facets_.push_back({waves(distance), is_lit ? cosine : 0.});
  }
}


std::string AnalyticBlast::warning(const double end_time) const
{
  double arrival = std::numeric_limits<double>::infinity();
  for (const Facet &facet : facets_)
    arrival = std::min(arrival, facet.waves.incident.arrival);
  arrival = dealii::Utilities::MPI::min(arrival, communicator_);
  if (arrival < end_time)
    return "";
  return path_ + ": the wave arrives at " + brief(arrival) +
         " s, after the end of the run at " + brief(end_time) +
         " s, and loads nothing";
}


double AnalyticBlast::pressure(const std::size_t facet) const
{
  const Facet &here = facets_[facet];
  if (time_ < here.waves.incident.arrival)
    return 0.;
  return pressure_at_angle(here.waves.incident.value(time_, negative_phase_),
                           here.waves.reflected.value(time_, negative_phase_),
                           here.cosine);
}
} // namespace contrecoup::solid
