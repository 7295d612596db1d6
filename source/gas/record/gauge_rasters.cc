// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/text.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/gauge_rasters.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/io/numpy.h>

#include <deal.II/base/mpi.h>

#include <sstream>

namespace contrecoup::gas
{
namespace
{
  const std::string axis_names = "xyz";

  /// Numbers "a, b, c".
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
} // namespace


template <int dim>
void GaugeRasters<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Probes");
  declare_string(prm,
                 "Lines",
                 "",
                 "Lines of gauges \"begin : end : number; ...\" [m], such as "
                 "\"0,0,0 : 2,0,0 : 101\", whose peak overpressure, impulse, "
                 "arrival and duration are written with the fields.");
  declare_string(prm,
                 "Gauge planes",
                 "",
                 "Planes of gauges \"begin : end : numbers; ...\" [m] between "
                 "two opposite corners, such as \"-2,-2,0 : 2,2,0 : 81, 81\".");
}


template <int dim>
void GaugeRasters<dim>::parse_parameters(ParameterHandler &prm,
                                         const CoarseMesh<dim> &mesh)
{
  rasters_.clear();
  places_.clear();
  const Section section(prm, "Probes");
  parse_list("Lines", prm.get("Lines"), 1);
  if (dim > 1 || !prm.get("Gauge planes").empty())
    parse_list("Gauge planes", prm.get("Gauge planes"), 2);
  for (const auto &place : places_)
    for (unsigned int d = 0; d < dim && mesh.is_axis_aligned(); ++d)
      if (place[d] < mesh.lower_corner()[d] ||
          place[d] > mesh.upper_corner()[d])
      {
        std::ostringstream message;
        message << "Probes: the gauge " << place
                << " m of a line or plane is outside of the domain, "
                << mesh.lower_corner() << " m to " << mesh.upper_corner()
                << " m";
        throw InputError(message.str());
      }
  ambient_.assign(places_.size(), 0.);
  records_.assign(places_.size(), {});
  is_shared_ = true;
}


template <int dim>
void GaugeRasters<dim>::parse_list(const std::string &entry,
                                   const std::string &text,
                                   const unsigned int n_counts)
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
                  places_.size()};
    const auto counts = numbers(parts[2], where);
    if (counts.size() != n_counts)
      throw InputError(where + "write " + std::to_string(n_counts) +
                       " number(s) of gauges, not \"" + parts[2] + "\"");
    for (unsigned int i = 0; i < n_counts; ++i)
    {
      if (counts[i] != std::floor(counts[i]) || counts[i] < 2. ||
          counts[i] > 1e5)
        throw InputError(where +
                         "numbers of gauges are whole, from 2 to "
                         "100000, not " +
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
    add_gauges(raster);
  }
}


template <int dim>
void GaugeRasters<dim>::add_gauges(Raster raster)
{
  const auto along = [](const unsigned int i, const unsigned int n) {
    return static_cast<double>(i) / (n - 1);
  };
  if (raster.counts[1] == 0)
    for (unsigned int i = 0; i < raster.counts[0]; ++i)
      places_.push_back(raster.begin + along(i, raster.counts[0]) *
                                         (raster.end - raster.begin));
  else
    for (unsigned int j = 0; j < raster.counts[1]; ++j)
      for (unsigned int i = 0; i < raster.counts[0]; ++i)
      {
        dealii::Point<dim> place = raster.begin;
        const unsigned int a = raster.axes[0], b = raster.axes[1];
        place[a] +=
          along(i, raster.counts[0]) * (raster.end[a] - raster.begin[a]);
        place[b] +=
          along(j, raster.counts[1]) * (raster.end[b] - raster.begin[b]);
        places_.push_back(place);
      }
  rasters_.push_back(raster);
}


template <int dim>
void GaugeRasters<dim>::set_ambient(const InitialState<dim> &initial_state)
{
  for (std::size_t i = 0; i < places_.size(); ++i)
    ambient_[i] = initial_state.ambient_pressure(places_[i]);
}


template <int dim>
void GaugeRasters<dim>::reinit(const LeafMesh<dim> &mesh,
                               const LeafPoints<dim> &points)
{
  if (empty())
    return;
  share();
  communicator_ = mesh.communicator();
  sampler_.reinit(places_, mesh, points);
}


template <int dim>
void GaugeRasters<dim>::add(const GasField &field,
                            const GasMaterial &material,
                            const double time,
                            const double step)
{
  if (empty())
    return;
  sampler_.for_each(
    field, material, [&](const unsigned int i, const GasState<dim> &state) {
      records_[i].add(state.pressure - ambient_[i],
                      time,
                      step,
                      Record::threshold * ambient_[i]);
    });
  is_shared_ = false;
}


template <int dim>
void GaugeRasters<dim>::set_records(
  const std::function<
    std::optional<BlastRecord<double>>(const dealii::Point<dim> &)> &record)
{
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (const auto known = record(places_[i]))
      records_[i] = *known;
}


template <int dim>
void GaugeRasters<dim>::share()
{
  if (is_shared_)
    return;
  std::vector<Record> mine(records_.size());
  for (const unsigned int i : sampler_.local_places())
    mine[i] = records_[i];
  static_assert(sizeof(Record) == Record::n_values * sizeof(double));
  const dealii::ArrayView<double> target(
    reinterpret_cast<double *>(records_.data()),
    records_.size() * Record::n_values);
  dealii::Utilities::MPI::sum(
    dealii::ArrayView<const double>(
      reinterpret_cast<const double *>(mine.data()), target.size()),
    communicator_,
    target);
  is_shared_ = true;
}


template <int dim>
void GaugeRasters<dim>::save(std::ostream &stream) const
{
  stream.write(reinterpret_cast<const char *>(records_.data()),
               records_.size() * sizeof(Record));
}


template <int dim>
void GaugeRasters<dim>::load(std::istream &stream)
{
  stream.read(reinterpret_cast<char *>(records_.data()),
              records_.size() * sizeof(Record));
  is_shared_ = true;
}


template <int dim>
void GaugeRasters<dim>::write(const std::string &folder,
                              const double time) const
{
  unsigned int line = 0, plane = 0;
  for (const Raster &raster : rasters_)
    if (raster.counts[1] == 0)
      write_line(folder + "/gauges_line_" + std::to_string(++line) + ".csv",
                 raster,
                 time);
    else
      write_plane(
        folder + "/gauges_plane_" + std::to_string(++plane), raster, time);
}


template <int dim>
void GaugeRasters<dim>::write_line(const std::string &file,
                                   const Raster &raster,
                                   const double time) const
{
  io::write_file(file, [&](std::ostream &out) {
    for (unsigned int d = 0; d < dim; ++d)
      out << axis_names[d] << " [m],";
    for (std::size_t k = 0; k < map_quantities.size(); ++k)
      out << (k == 0 ? "" : ",") << map_quantities[k].first << " ["
          << map_quantities[k].second << "]";
    out << '\n';
    for (std::size_t i = raster.first; i < raster.first + raster.counts[0]; ++i)
    {
      for (unsigned int d = 0; d < dim; ++d)
        out << brief(places_[i][d], 9) << ",";
      const auto values = map_values(records_[i].measures(time));
      for (std::size_t k = 0; k < values.size(); ++k)
        out << (k == 0 ? "" : ",") << brief(values[k], 9);
      out << '\n';
    }
  });
}


template <int dim>
void GaugeRasters<dim>::write_plane(const std::string &stem,
                                    const Raster &raster,
                                    const double time) const
{
  io::PlaneSamples samples;
  samples.time = time;
  for (unsigned int i = 0; i < 2; ++i)
  {
    samples.axes[i] = axis_names.substr(raster.axes[i], 1);
    samples.lower[i] = raster.begin[raster.axes[i]];
    samples.upper[i] = raster.end[raster.axes[i]];
    samples.n_points[i] = raster.counts[i];
  }
  const std::size_t n = samples.n_points[0] * samples.n_points[1];
  for (std::size_t k = 0; k < map_quantities.size(); ++k)
  {
    samples.quantity = map_quantities[k].first;
    samples.unit = map_quantities[k].second;
    samples.values.clear();
    for (std::size_t i = raster.first; i < raster.first + n; ++i)
      samples.values.push_back(map_values(records_[i].measures(time))[k]);
    io::write_plane(stem + "_" + samples.quantity, samples);
  }
}


template class GaugeRasters<1>;
template class GaugeRasters<2>;
template class GaugeRasters<3>;
} // namespace contrecoup::gas
