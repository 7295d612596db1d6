// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/aligned_rows.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/gauge_tables.h>
#include <contrecoup/gas/record/probe_set.h>
#include <contrecoup/gas/record/record_gaps.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/numerics/injury/body_mass.h>

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  std::string place_of(const std::size_t i)
  {
    return "probe " + std::to_string(i + 1);
  }

  std::string probe_name(const std::size_t i, const std::string &quantity)
  {
    return "probe_" + std::to_string(i + 1) + "_" + quantity;
  }

  /// Whether a quantity of map_quantities is a lower limit where the end of the
  /// run cuts the positive phase off.
  bool ends_with_phase(const std::size_t quantity)
  {
    const std::string &name = map_quantities[quantity].first;
    return name == "impulse" || name == "duration";
  }

  std::string difference(const double computed, const double exact)
  {
    std::ostringstream text;
    text << std::showpos << std::fixed << std::setprecision(1)
         << 100. * (computed / exact - 1.) << " %";
    return text.str();
  }
} // namespace


template <int dim>
void ProbeSet<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Probes");
  declare_points(
    prm,
    "Points",
    "",
    "m",
    selecting("Positions at which pressure, density and velocity are "
              "recorded in every step."));
  declare_bool(
    prm,
    "Injury",
    "false",
    used_with(
      "Probes/Points or Probes/Lines or Probes/Gauge planes not empty",
      "Whether lines and planes of probes also show what the blast "
      "would do to people who stand there, as if nobody were there but "
      "the body of this run, if it has one, which reflects the wave "
      "and shields from it: eardrum rupture, death by lung injury and the velocity of the "
      "chest wall, which probe_injury.csv then has as well."));
}


template <int dim>
void ProbeSet<dim>::parse_parameters(ParameterHandler &prm,
                                     const GasScene<dim> &scene)
{
  {
    const Section loads(prm, "Loads");
    body_mass_ = read_body_mass(prm, scene.body.phantom_mass());
  }
  const Section section(prm, "Probes");
  probes_.place(read_points<dim>(prm, "Points"),
                scene,
                "Probes/Points: the point",
                prm.get_bool("Injury") ? Exposure::load_and_chest
                                       : Exposure::load);
  for (const auto &place : places())
    if (!scene.body.empty() && scene.body.value(place) < -1e-9)
    {
      std::ostringstream message;
      message << "Probes/Points: the point " << place
              << " m is in the rigid body, where there is no gas";
      throw InputError(message.str());
    }
}


template <int dim>
void ProbeSet<dim>::begin(const GasSnapshot<dim> &gas)
{
  is_continued_ = last_time_ > 0.;
  last_time_ = gas.time;
  add_step(gas);
}


template <int dim>
void ProbeSet<dim>::inherit(const KnownRecord<dim> &record,
                            const GasSnapshot<dim> &gas)
{
  if (!is_continued_)
    probes_.inherit(record);
  probes_.expect_smearing(gas);
}


template <int dim>
void ProbeSet<dim>::add_step(const GasSnapshot<dim> &gas)
{
  if (!places().empty())
    take(probes_.sampler().sample(gas.field, gas.scene.material), gas.time);
}


template <int dim>
void ProbeSet<dim>::take(const std::vector<GasState<dim>> &states,
                         const double time)
{
  states_ = states;
  for (std::size_t i = 0; i < states_.size(); ++i)
    probes_.add(i, states_[i], time, time - last_time_);
  last_time_ = time;
}


template <int dim>
std::vector<NamedValue> ProbeSet<dim>::values(const bool has_products) const
{
  const std::array<const char *, 3> axes = {{"x", "y", "z"}};
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < states_.size(); ++i)
  {
    values.push_back({probe_name(i, "pressure"), "Pa", states_[i].pressure});
    values.push_back({probe_name(i, "density"), "kg/m^3", states_[i].density});
    for (unsigned int d = 0; d < dim; ++d)
      values.push_back({probe_name(i, std::string("velocity_") + axes[d]),
                        "m/s",
                        states_[i].velocity[d]});
    if (has_products)
      values.push_back({probe_name(i, "products"), "-", states_[i].products});
  }
  return values;
}


template <int dim>
std::vector<BlastMeasures> ProbeSet<dim>::blasts() const
{
  std::vector<BlastMeasures> result;
  for (const auto &record : probes_.records())
    result.push_back(record.measures(last_time_));
  return result;
}


template <int dim>
std::vector<BlastMeasures> ProbeSet<dim>::first_waves() const
{
  std::vector<BlastMeasures> result = blasts();
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i].peak = waves(i).first;
  return result;
}


template <int dim>
std::vector<NamedValue>
ProbeSet<dim>::measures(const ReferenceSolution<dim> &reference) const
{
  std::vector<NamedValue> values;
  const auto found = blasts(), first = first_waves();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const auto add =
      [&](const std::string &name, const std::size_t k, double value) {
        values.push_back({probe_name(i, name + map_quantities[k].first),
                          map_quantities[k].second,
                          value});
      };
    const auto numbers = recorded_map_values(found[i]);
    for (std::size_t k = 0; k < numbers.size(); ++k)
      add("", k, numbers[k]);
    add("first_", 0, recorded_map_values(first[i])[0]);
    if (waves(i).later > 0.)
    {
      add("later_", 0, waves(i).later);
      values.push_back(
        {probe_name(i, "later_peak_time"), "s", waves(i).later_time});
      values.push_back({probe_name(i, "impulse_of_all_phases"),
                        "Pa s",
                        probes_.records()[i].running});
    }
    if (is_cut_off(found[i], last_time_))
      values.push_back({probe_name(i, "cut_off"), "-", 1.});
    if (!reference.has_arrivals())
      continue;
    const auto exact = map_values(reference.arrival(places()[i]));
    for (std::size_t k = 0; k < exact.size(); ++k)
      if (exact[k] != 0.)
        add("reference_", k, exact[k]);
  }
  return values;
}


template <int dim>
std::vector<NamedValue> ProbeSet<dim>::errors(const GasSnapshot<dim> &gas) const
{
  const auto &reference = gas.scene.reference;
  std::vector<NamedValue> values;
  if (!reference.has_arrivals())
    return values;
  const auto found = first_waves();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    auto computed = recorded_map_values(found[i]);
    const auto exact = map_values(reference.arrival(places()[i]));
    for (std::size_t k = 0; k < exact.size(); ++k)
      if (exact[k] != 0.)
      {
        if (is_cut_off(found[i], last_time_) && ends_with_phase(k))
          computed[k] = std::numeric_limits<double>::quiet_NaN();
        values.push_back({probe_name(i, map_quantities[k].first + "_relative"),
                          "-",
                          computed[k] / exact[k] - 1.});
      }
  }
  return values;
}


template <int dim>
std::vector<std::string>
ProbeSet<dim>::values_in_words(const std::size_t probe,
                               const ReferenceSolution<dim> &reference) const
{
  const double factors[] = {1e-3, 1., 1e3, 1e3};
  const BlastMeasures found = first_waves()[probe];
  const auto computed = recorded_map_values(found);
  std::vector<std::string> row;
  for (std::size_t k = 0; k < computed.size(); ++k)
  {
    const bool is_known = !std::isnan(computed[k]);
    const bool is_cut = ends_with_phase(k) && is_cut_off(found, last_time_);
    row.push_back((is_cut ? ">= " : "") + (is_known
                                             ? brief(computed[k] * factors[k])
                                           : found.peak == 0. ? "not reached"
                                                              : "unknown"));
    if (!reference.has_arrivals())
      continue;
    const double exact = map_values(reference.arrival(places()[probe]))[k];
    row.back() +=
      " / " + (exact == 0. ? "unknown" : brief(exact * factors[k])) +
      (is_known && exact != 0.
         ? " (" + (is_cut ? "cut off" : difference(computed[k], exact)) + ")"
         : "");
  }
  return row;
}


template <int dim>
std::vector<std::string>
ProbeSet<dim>::report(const GasSnapshot<dim> &gas) const
{
  constexpr std::size_t most_rows = 12;
  const auto &reference = gas.scene.reference;
  if (places().empty())
    return {};
  const std::size_t n_rows = std::min(most_rows, places().size());
  std::vector<std::vector<std::string>> rows = {{"probe",
                                                 "place [m]",
                                                 "peak [kPa]",
                                                 "impulse [Pa s]",
                                                 "arrival [ms]",
                                                 "duration [ms]"}};
  for (std::size_t i = 0; i < n_rows; ++i)
  {
    rows.push_back({std::to_string(i + 1), coordinates(places()[i])});
    for (const std::string &value : values_in_words(i, reference))
      rows.back().push_back(value);
  }
  std::vector<std::string> lines;
  if (reference.has_arrivals())
    lines.push_back("computed / " + reference.description() + " (difference):");
  for (const std::string &line : aligned_rows(rows))
    lines.push_back(line);
  if (n_rows < places().size())
    lines.push_back("and " + std::to_string(places().size() - n_rows) +
                    " more in summary.json");
  for (std::size_t i = 0; i < n_rows; ++i)
    if (waves(i).later > waves(i).first)
      lines.push_back("a later wave has the larger peak at probe " +
                      std::to_string(i + 1) + ": " +
                      brief(1e-3 * waves(i).later) + " kPa at " +
                      brief(waves(i).later_time * 1e3) + " ms");
  return lines;
}


template <int dim>
std::vector<std::string> ProbeSet<dim>::gaps(const double time) const
{
  RecordGaps gaps(time,
                  "probes",
                  probes_.exposure() == Exposure::none
                    ? ""
                    : ", and injuries of lungs unknown");
  const auto found = blasts();
  for (std::size_t i = 0; i < found.size(); ++i)
    gaps.add(place_of(i), found[i]);
  return gaps.in_words();
}


template <int dim>
void ProbeSet<dim>::finish()
{
  // In 1-D each rank has all of the mesh, and communicators of its own.
  if (folder_.empty() ||
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  std::vector<AirBlast> air;
  std::vector<std::string> unknown;
  const auto found = blasts();
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    air.push_back({place_of(i),
                   found[i],
                   probes_.ambient()[i],
                   probes_.exposures()[i],
                   probes_.records()[i].running,
                   is_cut_off(found[i], last_time_)});
    if (is_habitable(air.back().ambient) &&
        lungs_are_unknown(air.back(), body_mass_))
      unknown.push_back(air.back().place);
  }
  if (!unknown.empty())
    log_line("WARNING: " + words_of_unknown_lungs(join(unknown, ", ")));
  const std::string table = air_injury_table(
    air, body_mass_, probes_.exposure() == Exposure::load_and_chest);
  if (!table.empty())
    io::write_file(folder_ + "/probe_injury.csv",
                   [&](std::ostream &out) { out << table; });
}


template <int dim>
void ProbeSet<dim>::save(std::ostream &stream,
                         const std::string & /*folder*/) const
{
  stream.write(reinterpret_cast<const char *>(&last_time_), sizeof(last_time_));
  probes_.save(stream);
}


template <int dim>
void ProbeSet<dim>::load(std::istream &stream, const std::string & /*folder*/)
{
  stream.read(reinterpret_cast<char *>(&last_time_), sizeof(last_time_));
  probes_.load(stream);
}


template class ProbeSet<1>;
template class ProbeSet<2>;
template class ProbeSet<3>;
} // namespace contrecoup::gas
