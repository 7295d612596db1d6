// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/aligned_rows.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/gauge_tables.h>
#include <contrecoup/gas/record/load_gauges.h>
#include <contrecoup/gas/record/record_gaps.h>
#include <contrecoup/gas/record/thin_parts.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/history_reader.h>
#include <contrecoup/numerics/injury/body_mass.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>

namespace contrecoup::gas
{
using dealii::Point;

namespace
{
  constexpr unsigned int n_geometry = 6; ///< numbers of a facet

  constexpr const char *histories = "/load_gauges.csv";

  /// A gauge "name: x, y, z".
  template <int dim>
  Landmark read_place(const std::string &text)
  {
    const std::string what =
      "Loads/Gauges: \"" + text + "\" must be a name, a colon and " +
      std::to_string(dim) + " coordinates, as in \"forehead: 0.1, 0" +
      (dim == 3 ? ", 1.7\"" : "\"");
    const std::vector<std::string> parts = split(text, ':');
    if (parts.size() != 2)
      throw InputError(what);
    const std::vector<std::string> words = split(parts[1], ',');
    Landmark place{parts[0], Point<3>()};
    const auto belongs = [](const unsigned char c) {
      return std::isalnum(c) || c == ' ' || c == '_' || c == '-';
    };
    if (words.size() != dim || place.name.empty() ||
        !std::all_of(place.name.begin(), place.name.end(), belongs))
      throw InputError(what + "; names are of letters, digits and spaces");
    for (unsigned int d = 0; d < dim; ++d)
    {
      char *end = nullptr;
      place.place[d] = std::strtod(words[d].c_str(), &end);
      if (words[d].empty() || *end != '\0' || !std::isfinite(place.place[d]))
        throw InputError(what + "; \"" + words[d] + "\" is no number");
    }
    return place;
  }


  /// Whether a landmark has no counterpart on the other side of the body, whose
  /// gauge would stand for both.
  bool is_of_the_middle(const std::string &name)
  {
    return !begins_with(name, "left ") && !begins_with(name, "right ");
  }


  /// The position in the box and, in 2-D, in the plane of the scene that is
  /// nearest to a place; none where that is farther than @p tolerance [m].
  template <int dim>
  std::optional<Point<3>> place_inside(const Point<3> &place,
                                       const Point<dim> &lower,
                                       const Point<dim> &upper,
                                       const double tolerance)
  {
    Point<3> inside;
    for (unsigned int d = 0; d < 3; ++d)
      inside[d] =
        d < dim
          ? std::clamp(place[d], lower[d < dim ? d : 0], upper[d < dim ? d : 0])
          : 0.;
    if (place.distance(inside) > tolerance)
      return {};
    return inside;
  }
} // namespace


void LoadGauges::declare_parameters(dealii::ParameterHandler &prm)
{
  {
    const UsedWith used("Loads/Record = true");
    declare_string(
      prm,
      "Gauges",
      "",
      selecting("Gauges on the body in addition to the phantom's landmarks, "
                "as \"name: x, y, z; name: ...\" [m]; each is moved to the "
                "nearest point of the surface, by at most Gauge radius and "
                "two cells."));
    declare_double(prm,
                   "Gauge radius",
                   "0.02",
                   bounds::smallest_length,
                   bounds::length,
                   "m",
                   "Radius of the surface patch over which a gauge averages, "
                   "above 0; without a facet within it, the nearest facet is "
                   "used.");
  }
  const UsedWith used("Loads/Record or Probes/Injury = true");
  declare_body_mass(prm,
                    "Body mass for the lung exposure in gauge_injury.csv and "
                    "probe_injury.csv; lighter persons are more vulnerable.");
}


template <int dim>
void LoadGauges::parse_parameters(dealii::ParameterHandler &prm,
                                  const RigidBody &body,
                                  const Point<dim> &lower,
                                  const Point<dim> &upper,
                                  const double cell)
{
  places_.clear();
  radius_ = read_double(prm, "Gauge radius");
  body_mass_ = read_body_mass(prm, body.phantom_mass());
  // The middle of a body that was scanned is not exactly a plane of symmetry.
  const double tolerance = 0.25 * radius_;
  for (const Landmark &landmark : body.landmarks())
  {
    const bool is_central = is_of_the_middle(landmark.name);
    if (const auto place = place_inside(
          landmark.place, lower, upper, is_central ? radius_ : tolerance))
      add_place(landmark.name, *place, body);
    else if (is_central)
      log_line("WARNING: the " + landmark.name + " of the body, " +
               coordinates(landmark.place) +
               " m, is outside of the domain and has no gauge");
  }
  for (const std::string &text : split(prm.get("Gauges"), ';'))
  {
    if (text.empty())
      continue;
    const Landmark given = read_place<dim>(text);
    const Point<3> nearest = body.project(given.place);
    const double away = given.place.distance(nearest);
    if (away > radius_ + 2. * cell)
      throw InputError("Loads/Gauges: \"" + given.name + "\" is " +
                       brief(away) + " m from the surface of the body, " +
                       "more than Gauge radius and two cells of " +
                       brief(cell) + " m; the nearest point of it is " +
                       coordinates(nearest));
    const auto place = place_inside(nearest, lower, upper, tolerance);
    if (!place)
      throw InputError("Loads/Gauges: the surface point nearest to \"" +
                       given.name + "\", " + coordinates(nearest) +
                       " m, is outside of the domain");
    add_place(given.name, *place, body);
  }
  std::vector<Landmark> on_body;
  for (const Place &place : places_)
    on_body.push_back({place.name, place.point});
  // Trial runs have coarser cells.
  const double diagonal = body.is_required() ? std::sqrt(dim) * cell : 0.;
  const std::string warning = warn_of_thin_parts(body, on_body, diagonal);
  if (!warning.empty())
    log_line(warning);
  diagonal_ =
    std::ldexp(diagonal, int(body.most_levels()) - int(body.levels()));
  records_.assign(places_.size(), {});
}


void LoadGauges::add_place(const std::string &name,
                           const Point<3> &point,
                           const RigidBody &body)
{
  for (const Place &place : places_)
    if (place.name == name)
      throw InputError("Loads/Gauges: there are two gauges \"" + name + "\"");
  places_.push_back({name, point, body.normal(point)});
}


double LoadGauges::find_patch(const unsigned int gauge,
                              const std::vector<double> &geometry,
                              std::vector<Contribution> &contributions) const
{
  const Place &place = places_[gauge];
  double sum = 0., nearest_distance = std::numeric_limits<double>::max();
  std::size_t nearest_facet = 0;
  for (std::size_t i = 0; i < geometry.size() / n_geometry; ++i)
  {
    const double *values = &geometry[n_geometry * i];
    const dealii::Tensor<1, 3> area({values[3], values[4], values[5]});
    const double distance =
      place.point.distance({values[0], values[1], values[2]});
    // On a thin body, facets of the opposite side are within the radius as
    // well.
    if (area * place.normal >= 0.)
      continue;
    if (distance < nearest_distance)
    {
      nearest_distance = distance;
      nearest_facet = i;
    }
    if (distance <= radius_)
    {
      contributions.push_back({i, gauge, area.norm()});
      sum += area.norm();
    }
  }
  if (contributions.empty() && !geometry.empty())
  {
    contributions.push_back({nearest_facet, gauge, 1.});
    sum = 1.;
  }
  for (Contribution &contribution : contributions)
    contribution.weight /= sum;
  return nearest_distance;
}


void LoadGauges::reinit(const std::vector<double> &geometry,
                        const std::vector<std::size_t> &owned)
{
  std::vector<char> is_owned(geometry.size() / n_geometry, 0);
  for (const std::size_t facet : owned)
    is_owned[facet] = 1;
  contributions_.clear();
  patch_sizes_.clear();
  std::vector<GaugePatch> patches;
  for (unsigned int gauge = 0; gauge < places_.size(); ++gauge)
  {
    std::vector<Contribution> patch;
    const double distance = find_patch(gauge, geometry, patch);
    patches.push_back({places_[gauge].name, {}, distance});
    patch_sizes_.push_back(patch.size());
    for (const Contribution &contribution : patch)
    {
      patches.back().facets.push_back(contribution.facet);
      if (is_owned[contribution.facet])
        contributions_.push_back(contribution);
    }
  }
  if (diagonal_ > 0. && !geometry.empty())
    for (const std::string &warning : warn_of_patches(patches, diagonal_))
      log_line(warning);
  diagonal_ = 0.; // once
}


void LoadGauges::begin_step(const double step)
{
  for (Record &record : records_)
    record.sum += 0.5 * step * record.last;
}


void LoadGauges::add(const std::vector<double> &overpressures,
                     const double time,
                     const double step,
                     const double smallest)
{
  for (std::size_t i = 0; i < records_.size(); ++i)
  {
    Record &record = records_[i];
    if (overpressures[i] > record.blast.peak)
      record.peak_time = time;
    record.blast.add(overpressures[i], time, step, smallest);
    record.peaks.add(overpressures[i], time, record.blast);
    record.sum += 0.5 * step * overpressures[i];
    record.last = overpressures[i];
  }
}


void LoadGauges::open_file()
{
  file_ = std::make_unique<io::HistoryFile>(folder_ + histories);
  if (file_size_ > 0)
    file_->resume(file_size_);
  else
    file_->start();
}


void LoadGauges::end_sample(const double time,
                            const double duration,
                            const bool writes)
{
  std::vector<NamedValue> row = {{"time", "s", time}};
  for (std::size_t i = 0; i < records_.size(); ++i)
  {
    const double mean = records_[i].sum / duration;
    row.push_back({places_[i].name, "Pa", mean});
    records_[i].sample_peak = std::max(records_[i].sample_peak, mean);
    records_[i].sum = 0.;
  }
  if (!writes || places_.empty() || folder_.empty())
    return;
  if (!file_)
    open_file();
  file_->add_row(row);
}


double LoadGauges::largest_peak_loss() const
{
  double loss = 0.;
  for (const Record &record : records_)
    if (record.blast.peak > 0.)
      loss = std::max(loss, 1. - record.sample_peak / record.blast.peak);
  return loss;
}


void LoadGauges::flush()
{
  if (!file_)
    return;
  file_->flush();
  file_size_ = file_->size();
}


void LoadGauges::write_tables(const double time) const
{
  const std::string file = folder_ + histories;
  if (folder_.empty() || !std::filesystem::exists(file))
    return;
  const io::HistoryTable table = io::read_history(file);
  const std::vector<double> &times = table.column("time", file);
  if (times.size() < 2)
    return;
  std::vector<GaugeBlast> gauges;
  for (std::size_t i = 0; i < places_.size(); ++i)
    gauges.push_back({places_[i].name,
                      records_[i].blast.measures(time),
                      records_[i].peak_time,
                      table.column(places_[i].name, file)});
  io::write_file(folder_ + "/gauge_measures.csv", [&](std::ostream &out) {
    out << gauge_measures_table(gauges, time);
  });
  const std::string injuries = gauge_injury_table(gauges, times, body_mass_);
  if (!injuries.empty())
    io::write_file(folder_ + "/gauge_injury.csv",
                   [&](std::ostream &out) { out << injuries; });
}


void LoadGauges::save(std::ostream &stream) const
{
  const std::size_t n = records_.size();
  stream.write(reinterpret_cast<const char *>(&n), sizeof(n));
  stream.write(reinterpret_cast<const char *>(&file_size_), sizeof(file_size_));
  stream.write(reinterpret_cast<const char *>(records_.data()),
               n * sizeof(Record));
}


void LoadGauges::load(std::istream &stream)
{
  std::size_t n = 0;
  stream.read(reinterpret_cast<char *>(&n), sizeof(n));
  stream.read(reinterpret_cast<char *>(&file_size_), sizeof(file_size_));
  if (!stream)
    return;
  if (n != records_.size())
    throw InputError("Loads/Gauges: the checkpoint has " + std::to_string(n) +
                     " places, this scene " + std::to_string(records_.size()));
  stream.read(reinterpret_cast<char *>(records_.data()), n * sizeof(Record));
}


std::vector<NamedValue> LoadGauges::measures(const double time) const
{
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < records_.size(); ++i)
  {
    const std::string begin = "loads_" + places_[i].name + "_";
    const BlastMeasures blast = records_[i].blast.measures(time);
    std::vector<NamedValue> found = gauge_values(blast, records_[i].peak_time);
    if (blast.peak > 0.)
      found.push_back({"first_peak", "Pa", records_[i].peaks.first});
    if (is_cut_off(blast, time))
      found.push_back({"cut_off", "-", 1.});
    for (NamedValue &value : found)
    {
      value.name = begin + value.name;
      std::replace(value.name.begin(), value.name.end(), ' ', '_');
      values.push_back(value);
    }
  }
  return values;
}


std::vector<std::string> LoadGauges::table(const double time) const
{
  if (places_.empty())
    return {};
  std::vector<std::vector<std::string>> rows = {{"place on body",
                                                 "x, y, z [m]",
                                                 "facets",
                                                 "arrival [ms]",
                                                 "peak [kPa]",
                                                 "at [ms]",
                                                 "impulse [Pa s]"}};
  for (std::size_t i = 0; i < places_.size(); ++i)
  {
    const BlastMeasures blast = records_[i].blast.measures(time);
    rows.push_back(
      {places_[i].name,
       coordinates(places_[i].point),
       std::to_string(i < patch_sizes_.size() ? patch_sizes_[i] : 0)});
    const std::vector<std::string> measured = {
      brief(1e3 * blast.arrival),
      brief(1e-3 * blast.peak),
      brief(1e3 * records_[i].peak_time),
      (is_cut_off(blast, time) ? ">= " : "") + brief(blast.impulse)};
    if (blast.peak > 0.)
      rows.back().insert(rows.back().end(), measured.begin(), measured.end());
    else
      rows.back().emplace_back("not reached");
  }
  return aligned_rows(rows);
}


std::vector<std::string> LoadGauges::gaps(const double time) const
{
  RecordGaps gaps(time, "gauges");
  for (std::size_t i = 0; i < records_.size(); ++i)
    gaps.add(places_[i].name, records_[i].blast.measures(time));
  return gaps.in_words();
}


std::vector<std::string> LoadGauges::names() const
{
  std::vector<std::string> result;
  for (const Place &place : places_)
    result.push_back(place.name);
  return result;
}


std::vector<double> LoadGauges::overpressures() const
{
  std::vector<double> result;
  for (const Record &record : records_)
    result.push_back(record.last);
  return result;
}


std::string LoadGauges::description() const
{
  std::vector<std::string> parts;
  for (const Place &place : places_)
    parts.push_back(place.name + ": " + coordinates(place.point));
  return join(parts, "; ");
}


#define CONTRECOUP_INSTANTIATE(dim)                                      \
  template void LoadGauges::parse_parameters(dealii::ParameterHandler &, \
                                             const RigidBody &,          \
                                             const Point<dim> &,         \
                                             const Point<dim> &,         \
                                             double)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
