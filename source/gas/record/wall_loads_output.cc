// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/timers.h>
#include <contrecoup/base/version.h>
#include <contrecoup/gas/record/wall_loads.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/io/load_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
template <int dim>
void WallLoads<dim>::begin_samples(const double time, const double step)
{
  // The last sample before is as short as those that follow: readers who draw
  // lines between the middles of samples then stay at rest until here.
  const double length = std::max(interval_, step);
  const double round_off = 1e-9 * length;
  totals_.sample_begin = 0.;
  if (time - length > round_off)
    end_sample(time - length);
  if (time > round_off)
    end_sample(time);
}


template <int dim>
void WallLoads<dim>::end_sample(const double time)
{
  const std::size_t enough_to_write = 32 << 20;
  const double duration = time - totals_.sample_begin;
  const std::size_t row = samples_.size();
  samples_.resize(row + records_.size(), 0.F);
  for (const Facet &facet : facets_)
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
    flush();
}


template <int dim>
void WallLoads<dim>::finish()
{
  if (active_ && is_waiting())
    totals_.sample_begin = 0.;
  if (active_ && totals_.time > totals_.sample_begin)
    end_sample(totals_.time);
  flush();
  if (active_ && dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
    gauges_.write_injury();
}


template <int dim>
void WallLoads<dim>::flush()
{
  if (!active_)
    return;
  if (file_.empty())
  {
    // A run without results, such as a trial of the costs.
    times_.clear();
    samples_.clear();
    return;
  }
  const TimerScope timer("loads");
  dealii::Utilities::MPI::sum(samples_, communicator_, samples_);
  share();
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
  for (std::size_t i = 0; i < keys_.size(); ++i)
  {
    const double *values = &geometry_[n_geometry * i];
    const double area =
      dealii::Tensor<1, 3>({values[3], values[4], values[5]}).norm();
    facets.areas.push_back(area);
    for (unsigned int d = 0; d < 3; ++d)
    {
      facets.centroids.push_back(values[d]);
      facets.normals.push_back(-values[3 + d] / area);
    }
  }
  io::LoadFile(file_).create(
    facets,
    {{"application", "blast " + version() + " (" + git_revision() + ")"},
     {"units", dim == 3 ? "m, m^2, s, Pa, Pa s" : "m, m, s, Pa, Pa s"},
     {"overpressure_samples", "means since the time before"},
     {"gauges", gauges_.description()}});
}


template <int dim>
void WallLoads<dim>::write_measures()
{
  std::array<std::vector<double>, 4> values;
  double highest = 0.;
  for (const Record &record : records_)
  {
    const BlastMeasures measures = record.blast.measures(totals_.time);
    values[0].push_back(measures.peak);
    values[1].push_back(measures.impulse);
    values[2].push_back(measures.arrival);
    values[3].push_back(measures.duration);
    highest = std::max(highest, measures.peak);
  }
  totals_.peak_loss = 0.;
  for (const Record &record : records_)
    if (record.blast.peak > counted_part * highest)
      totals_.peak_loss = std::max(totals_.peak_loss,
                                   1. - record.sample_peak / record.blast.peak);
  io::LoadFile file(file_);
  const char *const names[] = {"peak", "impulse", "arrival", "duration"};
  for (unsigned int k = 0; k < 4; ++k)
    file.write(names[k], values[k]);
  io::LoadFile::Numbers numbers = {{"ambient_pressure_Pa", ambient_}};
  for (const NamedValue &value : audit())
    numbers.emplace_back(value.name, value.value);
  file.write(numbers);
}


template <int dim>
std::vector<NamedValue> WallLoads<dim>::audit() const
{
  if (!active_)
    return {};
  const auto relative = [](const double part, const double whole) {
    return whole > 0. ? part / whole : 0.;
  };
  std::vector<NamedValue> values = {
    {"loads_facets", "-", double(keys_.size())}};
  const std::array<const char *, 3> axes = {{"x", "y", "z"}};
  for (unsigned int d = 0; d < dim; ++d)
    values.push_back({std::string("loads_impulse_") + axes[d],
                      dim == 3 ? "N s" : "N s/m",
                      totals_.facet_impulse[d]});
  values.push_back(
    {"loads_impulse_difference",
     "-",
     relative((totals_.facet_impulse - totals_.gas_impulse).norm(),
              totals_.gas_impulse.norm())});
  values.push_back(
    {"loads_force_difference",
     "-",
     relative(totals_.largest_difference, totals_.largest_force)});
  values.push_back({"loads_sampled_peak_loss", "-", totals_.peak_loss});
  for (const NamedValue &value : gauges_.measures(totals_.time))
    values.push_back(value);
  return values;
}


template <int dim>
void WallLoads<dim>::save(std::ostream &stream) const
{
  if (!active_)
    return;
  const std::size_t n = records_.size();
  stream.write(reinterpret_cast<const char *>(&totals_), sizeof(totals_));
  stream.write(reinterpret_cast<const char *>(&n), sizeof(n));
  stream.write(reinterpret_cast<const char *>(records_.data()),
               n * sizeof(Record));
  gauges_.save(stream);
}


template <int dim>
void WallLoads<dim>::save_file(const std::string &folder) const
{
  if (active_ && totals_.n_times > 0. && !file_.empty())
    io::copy_file(file_, folder + "/loads.h5");
}


template <int dim>
void WallLoads<dim>::restore_file(const std::string &folder) const
{
  if (active_ && totals_.n_times > 0.)
    io::copy_file(folder + "/loads.h5", file_);
}


template <int dim>
void WallLoads<dim>::load(std::istream &stream)
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
}


#define CONTRECOUP_INSTANTIATE(dim)                                        \
  template void WallLoads<dim>::begin_samples(const double, const double); \
  template void WallLoads<dim>::end_sample(const double);                  \
  template void WallLoads<dim>::finish();                                  \
  template void WallLoads<dim>::flush();                                   \
  template void WallLoads<dim>::create_file() const;                       \
  template void WallLoads<dim>::write_measures();                          \
  template std::vector<NamedValue> WallLoads<dim>::audit() const;          \
  template void WallLoads<dim>::save(std::ostream &) const;                \
  template void WallLoads<dim>::save_file(const std::string &) const;      \
  template void WallLoads<dim>::restore_file(const std::string &) const;   \
  template void WallLoads<dim>::load(std::istream &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
