// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/gauge_tables.h>
#include <contrecoup/gas/record/probe_rasters.h>
#include <contrecoup/gas/record/record_gaps.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/plane_file.h>
#include <contrecoup/numerics/injury/body_mass.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <sstream>

namespace contrecoup::gas
{
namespace
{
  const std::string axis_names = "xyz";

  /// Parses a list of numbers "a, b, c".
  std::vector<double> numbers(const std::string &text, const std::string &where)
  {
    std::vector<double> result;
    for (const auto &word : split(text, ','))
      try
      {
        result.push_back(dealii::Utilities::string_to_double(word));
      }
      catch (const std::exception &)
      {
        throw InputError(where + "\"" + word + "\" is not a number");
      }
    return result;
  }

  template <int dim>
  dealii::Point<dim> point(const std::string &text, const std::string &where)
  {
    const auto values = numbers(text, where);
    if (values.size() != dim)
      throw InputError(where + "\"" + text + "\" has not " +
                       std::to_string(dim) + " coordinate(s)");
    dealii::Point<dim> result;
    std::copy(values.begin(), values.end(), result.begin_raw());
    return result;
  }

  /// Lets every rank have all records of type @p Record, which consists of
  /// n_values numbers: those of the places in @p local are known here.
  template <typename Record>
  void share(std::vector<Record> &records,
             const std::vector<unsigned int> &local,
             const MPI_Comm communicator)
  {
    static_assert(sizeof(Record) == Record::n_values * sizeof(double));
    const dealii::ArrayView<double> target(
      reinterpret_cast<double *>(records.data()),
      records.size() * Record::n_values);
    std::vector<double> mine(target.size(), 0.);
    for (const unsigned int i : local)
      std::copy_n(target.begin() + i * Record::n_values,
                  Record::n_values,
                  mine.begin() + i * Record::n_values);
    dealii::Utilities::MPI::sum(
      dealii::ArrayView<const double>(mine), communicator, target);
  }
} // namespace


template <int dim>
void ProbeRasters<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Probes");
  declare_string(
    prm,
    "Lines",
    "",
    selecting("Lines of probes \"begin : end : number; ...\" [m], such as "
              "\"0,0,0 : 2,0,0 : 101\", whose peak overpressure, impulse, "
              "arrival and duration are written with the fields."));
  declare_string(
    prm,
    "Gauge planes",
    "",
    selecting("Planes of probes \"begin : end : numbers; ...\" [m] "
              "between two opposite corners, such as \"-2,-2,0 : 2,2,0 : "
              "81, 81\"."));
}


template <int dim>
void ProbeRasters<dim>::parse_parameters(ParameterHandler &prm,
                                         const GasScene<dim> &scene)
{
  rasters_.clear();
  is_in_body_.clear();
  {
    const Section loads(prm, "Loads");
    body_mass_ = read_body_mass(prm, scene.body.phantom_mass());
  }
  std::vector<dealii::Point<dim>> places;
  const Section section(prm, "Probes");
  parse_list("Lines", prm.get("Lines"), 1, scene.body, places);
  if (dim > 1 || !prm.get("Gauge planes").empty())
    parse_list("Gauge planes", prm.get("Gauge planes"), 2, scene.body, places);
  const bool wanted = prm.get_bool("Injury");
  probes_.place(places,
                scene,
                "Probes/Lines and Gauge planes: the probe",
                wanted ? Exposure::load_and_chest : Exposure::none);
  is_shared_ = true;
}


template <int dim>
void ProbeRasters<dim>::parse_list(const std::string &entry,
                                   const std::string &text,
                                   const unsigned int n_counts,
                                   const RigidBody &body,
                                   std::vector<dealii::Point<dim>> &places)
{
  for (const auto &item : split(text, ';'))
  {
    const std::string where = "Probes/" + entry + ": ";
    const auto parts = split(item, ':');
    if (parts.size() != 3)
      throw InputError(where + "write \"begin : end : number\", not \"" + item +
                       "\"");
    Raster raster{point<dim>(parts[0], where),
                  point<dim>(parts[1], where),
                  {{0, 0}},
                  {{0, 0}},
                  places.size()};
    const auto counts = numbers(parts[2], where);
    if (counts.size() != n_counts)
      throw InputError(where + "write " + std::to_string(n_counts) +
                       " number(s) of probes, not \"" + parts[2] + "\"");
    for (unsigned int i = 0; i < n_counts; ++i)
    {
      if (counts[i] != std::floor(counts[i]) || counts[i] < 2. ||
          counts[i] > 1e5)
        throw InputError(where +
                         "numbers of probes must be integers from "
                         "2 to 100000, not " +
                         brief(counts[i]));
      raster.counts[i] = static_cast<unsigned int>(counts[i]);
    }
    if (n_counts == 2)
    {
      std::vector<unsigned int> axes;
      for (unsigned int d = 0; d < dim; ++d)
        if (raster.begin[d] != raster.end[d])
          axes.push_back(d);
      if (axes.size() != 2)
        throw InputError(where + "the corners of \"" + item +
                         "\" must differ in two coordinates");
      raster.axes = {{axes[0], axes[1]}};
    }
    std::uint64_t n_in_gas = 0;
    for (const auto &place : raster.places())
    {
      places.push_back(place);
      is_in_body_.push_back(!body.empty() && body.value(place) < -1e-9);
      n_in_gas += is_in_body_.back() ? 0 : 1;
    }
    rasters_.push_back(raster);
    Selections selections;
    selections.add("Probes/" + entry, item, "place in the gas", n_in_gas);
    selections.require_some(MPI_COMM_SELF, "the body is there");
  }
}


template <int dim>
std::vector<dealii::Point<dim>> ProbeRasters<dim>::Raster::places() const
{
  const auto along = [](const unsigned int i, const unsigned int n) {
    return static_cast<double>(i) / (n - 1);
  };
  std::vector<dealii::Point<dim>> result;
  for (unsigned int j = 0; j < std::max(counts[1], 1U); ++j)
    for (unsigned int i = 0; i < counts[0]; ++i)
      if (counts[1] == 0)
        result.push_back(begin + along(i, counts[0]) * (end - begin));
      else
      {
        dealii::Point<dim> place = begin;
        const unsigned int a = axes[0], b = axes[1];
        place[a] += along(i, counts[0]) * (end[a] - begin[a]);
        place[b] += along(j, counts[1]) * (end[b] - begin[b]);
        result.push_back(place);
      }
  return result;
}


template <int dim>
void ProbeRasters<dim>::mesh_changed(const GasSnapshot<dim> &gas)
{
  reduce_over_ranks();
  communicator_ = gas.mesh.communicator();
  probes_.mesh_changed(gas);
}


template <int dim>
void ProbeRasters<dim>::inherit(const KnownRecord<dim> &record,
                                const GasSnapshot<dim> &gas)
{
  if (!is_taken_)
    probes_.inherit(record);
  probes_.expect_smearing(gas);
}


template <int dim>
void ProbeRasters<dim>::add_step(const GasSnapshot<dim> &gas)
{
  if (rasters_.empty())
    return;
  probes_.sampler().for_each(
    gas.field,
    gas.scene.material,
    [&](const unsigned int i, const GasState<dim> &state) {
      probes_.add(i, state, gas.time, gas.step);
    });
  is_shared_ = false;
}


template <int dim>
void ProbeRasters<dim>::reduce_over_ranks()
{
  if (is_shared_)
    return;
  const std::vector<unsigned int> local = probes_.sampler().local_places();
  share(probes_.records(), local, communicator_);
  if (has_injuries())
    share(probes_.exposures(), local, communicator_);
  is_shared_ = true;
}


template <int dim>
std::vector<std::string> ProbeRasters<dim>::gaps(const double time) const
{
  RecordGaps gaps(time,
                  "probes of Probes/Lines and Gauge planes in the gas",
                  ", and injuries of lungs unknown, except where even an "
                  "endless phase would kill nobody");
  for (std::size_t i = 0; has_injuries() && i < probes_.size(); ++i)
    if (!is_in_body_[i])
      gaps.add("(" + coordinates(probes_.places()[i]) + ") m",
               is_rising(i) ? BlastMeasures()
                            : probes_.records()[i].measures(time),
               probes_.exposures()[i].goes_on());
  return gaps.in_words();
}


template <int dim>
void ProbeRasters<dim>::finish()
{
  reduce_over_ranks();
  std::size_t n_between = 0;
  for (std::size_t i = 0; has_injuries() && i < probes_.size(); ++i)
  {
    const BlastRecord<double> &record = probes_.records()[i];
    const ExposureRecord &exposure = probes_.exposures()[i];
    n_between += !is_in_body_[i] && record.end > 0. && !exposure.goes_on() &&
                     lungs_are_unknown({"",
                                        record.measures(record.end),
                                        probes_.ambient()[i],
                                        exposure,
                                        record.running},
                                       body_mass_)
                   ? 1
                   : 0;
  }
  if (n_between > 0)
    log_line("Probes/Lines and Gauge planes: " +
             words_of_unknown_lungs(std::to_string(n_between) + " probes"));
}


template <int dim>
void ProbeRasters<dim>::save(std::ostream &stream,
                             const std::string & /*folder*/) const
{
  probes_.save(stream);
}


template <int dim>
void ProbeRasters<dim>::load(std::istream &stream,
                             const std::string & /*folder*/)
{
  probes_.load(stream);
  is_shared_ = true;
}


template <int dim>
void ProbeRasters<dim>::write(const GasSnapshot<dim> &gas,
                              const std::string &folder)
{
  reduce_over_ranks();
  if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
    return;
  unsigned int line = 0, plane = 0;
  for (const Raster &raster : rasters_)
    if (raster.counts[1] == 0)
      write_line(folder + "/gauges_line_" + std::to_string(++line) + ".csv",
                 raster,
                 gas.time);
    else
      write_plane(folder + "/gauges_plane_" + std::to_string(++plane) + ".vti",
                  raster,
                  gas.time);
}


template <int dim>
std::vector<std::pair<std::string, std::string>>
ProbeRasters<dim>::quantities() const
{
  auto result = map_fields;
  if (has_injuries())
  {
    result.insert(
      result.end(), air_injury_quantities.begin(), air_injury_quantities.end());
    result.emplace_back("chest_wall_velocity_cut_off", "-");
  }
  return result;
}


template <int dim>
std::vector<double> ProbeRasters<dim>::values(const std::size_t i,
                                              const double time) const
{
  if (is_in_body_[i] || is_rising(i))
    return std::vector<double>(quantities().size(),
                               std::numeric_limits<double>::quiet_NaN());
  const BlastMeasures blast = probes_.records()[i].measures(time);
  const auto measures = map_field_values(blast, time);
  std::vector<double> result(measures.begin(), measures.end());
  if (!has_injuries())
    return result;
  const ExposureRecord &exposure = probes_.exposures()[i];
  const auto injuries = mapped_injury_values({"",
                                              blast,
                                              probes_.ambient()[i],
                                              exposure,
                                              probes_.records()[i].running,
                                              is_cut_off(blast, time)},
                                             body_mass_);
  result.insert(result.end(), injuries.begin(), injuries.end());
  const bool is_known =
    blast.peak > 0. && !std::isnan(exposure.chest.largest_velocity);
  result.push_back(!is_known ? std::numeric_limits<double>::quiet_NaN()
                   : exposure.chest.is_fastest_now() ? 1.
                                                     : 0.);
  return result;
}


template <int dim>
void ProbeRasters<dim>::write_line(const std::string &file,
                                   const Raster &raster,
                                   const double time) const
{
  io::write_file(file, [&](std::ostream &out) {
    std::vector<std::string> words;
    for (unsigned int d = 0; d < dim; ++d)
      words.push_back(std::string(1, axis_names[d]) + " [m]");
    for (const auto &[name, unit] : quantities())
      words.push_back(name + " [" + unit + "]");
    out << join(words, ",") << '\n';
    for (std::size_t i = raster.first; i < raster.first + raster.counts[0]; ++i)
    {
      words.clear();
      for (unsigned int d = 0; d < dim; ++d)
        words.push_back(brief(probes_.places()[i][d], 9));
      for (const double value : values(i, time))
        words.push_back(std::isnan(value) ? "nan" : brief(value, 9));
      out << join(words, ",") << '\n';
    }
  });
}


template <int dim>
void ProbeRasters<dim>::write_plane(const std::string &file,
                                    const Raster &raster,
                                    const double time) const
{
  io::PlaneSamples samples;
  samples.time = time;
  samples.axes = raster.axes;
  for (unsigned int d = 0; d < dim; ++d)
  {
    samples.lower[d] = raster.begin[d];
    samples.upper[d] = raster.end[d];
  }
  for (unsigned int i = 0; i < 2; ++i)
    samples.n_points[i] = raster.counts[i];
  for (const auto &[name, unit] : quantities())
    samples.fields.push_back({name, unit, {}});
  for (std::size_t i = 0; i < samples.n_samples(); ++i)
  {
    const std::vector<double> found = values(raster.first + i, time);
    for (std::size_t k = 0; k < found.size(); ++k)
      samples.fields[k].values.push_back(found[k]);
  }
  io::write_plane(file, samples);
}


template class ProbeRasters<1>;
template class ProbeRasters<2>;
template class ProbeRasters<3>;
} // namespace contrecoup::gas
