// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/wall_loads.h>
#include <contrecoup/gas/scene/scene_places.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/load_file.h>
#include <contrecoup/io/output/load_series.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
template <int dim>
void WallLoads<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Loads");
  declare_bool(prm,
               "Record",
               "false",
               "Whether the overpressure on every facet of the rigid body is "
               "recorded in loads.h5 during the run.");
  LoadGauges::declare_parameters(prm);
  const UsedWith used("Loads/Record = true");
  declare_double(prm,
                 "Interval",
                 "0",
                 0.,
                 bounds::time,
                 "s",
                 "Time between samples, each the mean since the previous one; "
                 "0: every step. Peaks and arrivals follow from every step.");
  declare_double(prm,
                 "Largest loss of peaks",
                 "0.01",
                 0.,
                 1.,
                 "-",
                 "Largest part of a facet's peak that samples may lose; a step "
                 "that would exceed it is a sample. 1: the interval alone.");
  declare_double(
    prm,
    "Smallest overpressure",
    "1e-4",
    0.,
    0.01,
    "-",
    "Relative change of the pressure on any facet at which samples "
    "begin; the first is the mean over all time before.");
}


template <int dim>
void WallLoads<dim>::parse_parameters(ParameterHandler &prm,
                                      const GasScene<dim> &scene)
{
  const auto &mesh = scene.coarse_mesh;
  to_whole_ = factors_to_whole_body(prm, mesh, scene.body);
  is_plane_ = dim == 2 && mesh.geometry() == Geometry::plane;
  const Section section(prm, "Loads");
  active_ = prm.get_bool("Record");
  interval_ = read_double(prm, "Interval");
  largest_loss_ = read_double(prm, "Largest loss of peaks");
  smallest_ = read_double(prm, "Smallest overpressure");
  if (!active_)
    return;
  if (scene.body.empty())
    throw InputError("Loads/Record = true needs a Rigid body/Kind other than "
                     "none");
  const double cell = cell_at_body(mesh, scene.body, scene.scheme.n_points);
  gauges_.parse_parameters(
    prm, scene.body, mesh.lower_corner(), mesh.upper_corner(), cell);
}


template <int dim>
void WallLoads<dim>::mesh_changed(const GasSnapshot<dim> &gas)
{
  if (!active_)
    return;
  const TimerScope timer("loads");
  communicator_ = gas.mesh.communicator();
  ambient_ = gas.scene.ambient().pressure;
  share_records();
  const bool was_found = facets_.n_global() > 0;
  const bool are_others = facets_.mesh_changed(gas);
  if (records_.size() != facets_.n_global() || (was_found && are_others))
  {
    if (totals_.time > 0.)
      throw InputError("Loads: the facets are not those of the checkpoint");
    records_.assign(facets_.n_global(), {});
  }
  std::vector<std::size_t> numbers;
  for (const auto &facet : facets_.owned())
    numbers.push_back(facet.number);
  gauges_.reinit(facets_.geometry(), numbers);
  pressures_.assign(numbers.size(), 0.);
}


template <int dim>
void WallLoads<dim>::share_records()
{
  if (facets_.n_global() == 0 ||
      dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1)
    return;
  constexpr std::size_t n = sizeof(Record) / sizeof(double);
  static_assert(n * sizeof(double) == sizeof(Record));
  std::vector<double> values(n * records_.size(), 0.);
  for (const auto &facet : facets_.owned())
    std::copy_n(reinterpret_cast<const double *>(&records_[facet.number]),
                n,
                &values[n * facet.number]);
  dealii::Utilities::MPI::sum(values, communicator_, values);
  std::copy_n(
    values.data(), values.size(), reinterpret_cast<double *>(records_.data()));
}


template <int dim>
void WallLoads<dim>::add_step(const GasSnapshot<dim> &gas)
{
  if (!active_)
    return;
  const TimerScope timer("loads");
  const double time = gas.time, step = gas.step;
  const double smallest = BlastRecord<double>::threshold * ambient_;
  totals_.time = time;
  pressures_ = facets_.overpressures(gas, ambient_);
  begin_step(time - 0.5 * step, step);
  dealii::Tensor<1, 3> force;
  for (std::size_t i = 0; i < pressures_.size(); ++i)
  {
    const auto &facet = facets_.owned()[i];
    Record &record = records_[facet.number];
    record.blast.add(pressures_[i], time, step, smallest);
    // Mean over the step: of the values at its begin and end.
    for (unsigned int d = 0; d < dim; ++d)
      force[d] += 0.5 * (record.last + pressures_[i]) * facet.area[d];
    record.last = pressures_[i];
    record.sum += 0.5 * step * pressures_[i];
  }
  add_gauges(time, step);
  add_forces(force, gas.wall_force, step);
}


template <int dim>
void WallLoads<dim>::begin_step(const double middle, const double step)
{
  for (const auto &facet : facets_.owned())
  {
    Record &record = records_[facet.number];
    record.sum += 0.5 * step * record.last;
  }
  gauges_.begin_step(step);
  if (is_waiting())
  {
    if (has_arrived())
      begin_samples(middle, step);
    return;
  }
  const bool is_peak = loses_peaks(middle, step);
  if (is_peak || middle - totals_.sample_begin >= interval_ * (1. - 1e-9))
    end_sample(middle);
}


template <int dim>
bool WallLoads<dim>::has_arrived() const
{
  double largest = 0.;
  for (const double pressure : pressures_)
    largest = std::max(largest, std::abs(pressure));
  return dealii::Utilities::MPI::max(largest, communicator_) >
         smallest_ * ambient_;
}


template <int dim>
bool WallLoads<dim>::loses_peaks(const double middle, const double step)
{
  if (largest_loss_ >= 1.)
    return false;
  // Half of the allowed loss: the rest covers the round-off of single precision
  // and slow rises that a sample ends.
  const double threshold = 1. - 0.5 * largest_loss_;
  const double duration = middle - totals_.sample_begin;
  double loses = 0.;
  for (std::size_t i = 0; i < pressures_.size(); ++i)
  {
    const double now = pressures_[i];
    const Record &record = records_[facets_.owned()[i].number];
    const double peak = std::max(now, record.blast.peak);
    if (peak <= counted_fraction * totals_.highest ||
        record.sample_peak >= threshold * peak)
      continue;
    // The peak lies in the current sample or at the end of this step, which
    // counts for half of it if the run ends there, else for all.
    const double before = record.sum / duration;
    const auto after = [&](const double length) {
      return (record.sum + now * length) / (duration + length);
    };
    if (std::min(after(0.5 * step), after(step)) < threshold * peak &&
        std::max(before, now) >= threshold * peak)
      loses = 1.;
  }
  std::vector<double> largest = {loses, totals_.highest};
  for (const double pressure : pressures_)
    largest[1] = std::max(largest[1], pressure);
  dealii::Utilities::MPI::max(largest, communicator_, largest);
  totals_.highest = largest[1];
  return largest[0] > 0.;
}


template <int dim>
void WallLoads<dim>::add_gauges(const double time, const double step)
{
  std::vector<double> sums = gauges_.partial_sums(
    [this](const std::size_t facet) { return records_[facet].last; });
  dealii::Utilities::MPI::sum(sums, communicator_, sums);
  gauges_.add(sums, time, step, BlastRecord<double>::threshold * ambient_);
}


template <int dim>
void WallLoads<dim>::add_forces(const dealii::Tensor<1, 3> &facet_force,
                                const std::array<double, 6> &wall_force,
                                const double step)
{
  std::vector<double> sums(6);
  for (unsigned int d = 0; d < 3; ++d)
  {
    sums[d] = facet_force[d];
    sums[3 + d] = wall_force[d] - ambient_ * wall_force[3 + d];
  }
  dealii::Utilities::MPI::sum(sums, communicator_, sums);
  dealii::Tensor<1, 3> facets, gas;
  for (unsigned int d = 0; d < 3; ++d)
  {
    facets[d] = sums[d];
    gas[d] = sums[3 + d];
    totals_.facet_impulse[d] += step * facets[d];
    totals_.gas_impulse[d] += step * gas[d];
  }
  totals_.largest_force = std::max(totals_.largest_force, gas.norm());
  totals_.largest_difference =
    std::max(totals_.largest_difference, (facets - gas).norm());
}


template <int dim>
void WallLoads<dim>::begin_samples(const double middle, const double step)
{
  // The last sample before the arrival is as short as the following ones, so
  // that linear interpolation between midpoints of samples is zero until then.
  const double length = std::max(interval_, step);
  const double round_off = 1e-9 * length;
  totals_.sample_begin = 0.;
  if (middle - length > round_off)
    end_sample(middle - length);
  end_sample(middle);
}


template <int dim>
void WallLoads<dim>::end_sample(const double time)
{
  const std::size_t enough_to_write = 32 << 20;
  const double duration = time - totals_.sample_begin;
  const std::size_t row = samples_.size();
  samples_.resize(row + records_.size(), 0.F);
  for (const auto &facet : facets_.owned())
  {
    Record &record = records_[facet.number];
    const double mean = record.sum / duration;
    samples_[row + facet.number] = static_cast<float>(mean);
    record.sample_peak = std::max(record.sample_peak, mean);
    record.sum = 0.;
  }
  gauges_.end_sample(time,
                     duration,
                     dealii::Utilities::MPI::this_mpi_process(communicator_) ==
                       0);
  times_.push_back(time);
  totals_.sample_begin = time;
  const bool fills_chunks =
    std::lround(totals_.n_times + times_.size()) % io::LoadFile::chunk_times ==
    0;
  if (fills_chunks && samples_.size() * sizeof(float) > enough_to_write)
    reduce_over_ranks();
}


template <int dim>
void WallLoads<dim>::finish()
{
  if (active_ && is_waiting())
    totals_.sample_begin = 0.;
  if (active_ && totals_.time > totals_.sample_begin)
    end_sample(totals_.time);
  reduce_over_ranks();
  if (!active_ || dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
    return;
  gauges_.write_tables(totals_.time);
  if (totals_.n_times > 0. && !file_.empty())
    io::write_load_series(file_);
}


template <int dim>
void WallLoads<dim>::gather_skin()
{
  if (active_)
    share_records();
}


template <int dim>
std::string WallLoads<dim>::write_skin(const std::string &folder,
                                       const unsigned int index,
                                       const double time) const
{
  if (!active_)
    return "";
  const std::string name =
    "skin_" + dealii::Utilities::int_to_string(index, 4) + ".vtp";
  if (dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
    return name;
  std::vector<io::SkinField> fields = {{"overpressure", "Pa", {}},
                                       {"peak", "Pa", {}},
                                       {"impulse", "Pa s", {}},
                                       {"arrival", "s", {}}};
  for (const Record &record : records_)
  {
    const auto [peak, impulse, arrival, duration] =
      recorded_map_values(record.blast.measures(time));
    const std::array<double, 4> values = {
      {record.last, peak, impulse, arrival}};
    for (std::size_t k = 0; k < values.size(); ++k)
      fields[k].values.push_back(static_cast<float>(values[k]));
  }
  io::write_skin(folder + "/" + name, facets_.skin(), fields, time);
  return name;
}


template <int dim>
void WallLoads<dim>::reduce_over_ranks()
{
  if (!active_)
    return;
  if (file_.empty())
  {
    // A run without output folder.
    times_.clear();
    samples_.clear();
    return;
  }
  const TimerScope timer("loads");
  dealii::Utilities::MPI::sum(samples_, communicator_, samples_);
  share_records();
  if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
  {
    io::LoadFile file(file_);
    if (totals_.n_times == 0.)
      create_file();
    file.append(times_, samples_);
    write_measures();
    gauges_.flush();
  }
  totals_.n_times += times_.size();
  times_.clear();
  samples_.clear();
}


template <int dim>
void WallLoads<dim>::create_file() const
{
  io::LoadFile::Facets facets;
  constexpr unsigned int n_geometry = WallFacets<dim>::n_geometry;
  for (std::size_t i = 0; i < facets_.n_global(); ++i)
  {
    const double *values = &facets_.geometry()[n_geometry * i];
    const double area = std::hypot(values[3], values[4], values[5]);
    facets.areas.push_back(area);
    for (unsigned int d = 0; d < 3; ++d)
    {
      facets.centroids.push_back(values[d]);
      facets.normals.push_back(-values[3 + d] / area);
    }
  }
  facets.corners = facets_.skin();
  io::LoadFile(file_).create(
    facets,
    {{"application", "blast " + version() + " (" + git_revision() + ")"},
     {"units", is_plane_ ? "m, m, s, Pa, Pa s" : "m, m^2, s, Pa, Pa s"},
     {"factors_to_whole_body", coordinates(dealii::Point<3>(to_whole_))},
     {"overpressure_samples", "means since the time before"},
     {"gauges", gauges_.description()}});
}


template <int dim>
void WallLoads<dim>::save(std::ostream &stream, const std::string &folder) const
{
  if (!active_)
    return;
  const std::size_t n = records_.size();
  stream.write(reinterpret_cast<const char *>(&totals_), sizeof(totals_));
  stream.write(reinterpret_cast<const char *>(&n), sizeof(n));
  stream.write(reinterpret_cast<const char *>(records_.data()),
               n * sizeof(Record));
  gauges_.save(stream);
  if (totals_.n_times > 0. && !file_.empty())
    io::copy_file(file_, folder + "/loads.h5");
}


template <int dim>
void WallLoads<dim>::load(std::istream &stream, const std::string &folder)
{
  if (!active_)
    return;
  std::size_t n = 0;
  stream.read(reinterpret_cast<char *>(&totals_), sizeof(totals_));
  stream.read(reinterpret_cast<char *>(&n), sizeof(n));
  if (!stream)
    return;
  records_.assign(n, {});
  stream.read(reinterpret_cast<char *>(records_.data()), n * sizeof(Record));
  gauges_.load(stream);
  if (totals_.n_times > 0. &&
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
    io::copy_file(folder + "/loads.h5", file_);
}


template class WallLoads<1>;
template class WallLoads<2>;
template class WallLoads<3>;
} // namespace contrecoup::gas
