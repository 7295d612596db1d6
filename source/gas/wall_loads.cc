// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/timers.h>
#include <contrecoup/base/version.h>
#include <contrecoup/gas/gas_measures.h>
#include <contrecoup/gas/primitive.h>
#include <contrecoup/gas/wall_loads.h>
#include <contrecoup/io/load_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <numeric>

namespace contrecoup::gas
{
namespace
{
  constexpr unsigned int n_geometry = 6; ///< numbers of a facet

  double norm(const std::array<double, 3> &v)
  {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }

  double distance(const std::array<double, 3> &a,
                  const std::array<double, 3> &b)
  {
    return norm({{a[0] - b[0], a[1] - b[1], a[2] - b[2]}});
  }
} // namespace


template <int dim>
void WallLoads<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Loads");
  declare_bool(prm,
               "Record",
               "false",
               "Whether the overpressure on every facet of the rigid body is "
               "written to loads.h5 as the run goes.");
  declare_double(prm,
                 "Interval",
                 "0",
                 0.,
                 unbounded,
                 "s",
                 "Least time between samples, which are means since the last "
                 "one, so that impulses stay exact; 0 for every step. Peaks "
                 "and arrivals are found from every step anyhow.");
  LoadGauges::declare_parameters(prm);
}


template <int dim>
void WallLoads<dim>::parse_parameters(ParameterHandler &prm,
                                      const RigidBody &body,
                                      const CoarseMesh<dim> &domain)
{
  const Section section(prm, "Loads");
  active_ = prm.get_bool("Record");
  interval_ = read_double(prm, "Interval");
  if (active_ && body.empty())
    throw InputError("Loads/Record = true needs a Rigid body/Kind other than "
                     "none");
  if (active_)
    gauges_.parse_parameters(
      prm, body, domain.lower_corner(), domain.upper_corner());
}


template <int dim>
void WallLoads<dim>::reinit(const LeafMesh<dim> &mesh,
                            const LeafLayout &layout,
                            const CutLeaves<dim> &cut_leaves,
                            const RigidBody &body)
{
  if (!active_)
    return;
  const TimerScope timer("loads");
  communicator_ = mesh.communicator();
  share();
  facets_.clear();
  std::vector<std::uint64_t> keys;
  std::vector<double> geometry;
  for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
    if (cut_leaves.shape(leaf) != nullptr)
      add_facets(leaf, mesh, layout, cut_leaves, body, keys, geometry);
  number_facets(keys, geometry);
}


template <int dim>
std::uint64_t WallLoads<dim>::key_of(const dealii::Point<dim> &place,
                                     const CoarseMesh<dim> &domain)
{
  // Centres of cells differ by some millionths of the domain at least.
  const auto &lower = domain.lower_corner(), &upper = domain.upper_corner();
  std::uint64_t key = 0;
  for (unsigned int d = 0; d < dim; ++d)
    key = (key << 21) +
          static_cast<std::uint64_t>((place[d] - lower[d]) /
                                     (upper[d] - lower[d]) * (1U << 21));
  return key;
}


template <int dim>
void WallLoads<dim>::add_facets(const unsigned int leaf,
                                const LeafMesh<dim> &mesh,
                                const LeafLayout &layout,
                                const CutLeaves<dim> &cut_leaves,
                                const RigidBody &body,
                                std::vector<std::uint64_t> &keys,
                                std::vector<double> &geometry)
{
  // Parts of a cell's face that are round-off.
  const double nothing = 1e-10;
  const LeafBox<dim> box = leaf_box(mesh, leaf);
  const dealii::Tensor<1, dim> size = box.extents / layout.n;
  double volume = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    volume *= size[d];
  for (unsigned int q = 0; q < layout.n_points; ++q)
  {
    dealii::Tensor<1, dim> area;
    if constexpr (dim > 1)
      area = cut_leaves.wall({leaf, q});
    if (area.norm() < nothing || cut_leaves.fractions()(leaf, q) == 0.)
      continue;
    dealii::Point<dim> place = box.origin;
    unsigned int rest = q;
    for (unsigned int d = 0; d < dim; ++d)
    {
      place[d] += size[d] * (rest % layout.n + 0.5);
      rest /= layout.n;
      area[d] *= volume / size[d];
    }
    facets_.push_back({leaf, q, 0, area});
    keys.push_back(key_of(place, mesh.coarse_mesh()));
    // Known facets stay where they are: it is costly to find them.
    const std::size_t known =
      std::lower_bound(keys_.begin(), keys_.end(), keys.back()) - keys_.begin();
    if (known < keys_.size() && keys_[known] == keys.back())
    {
      const auto values = geometry_.begin() + n_geometry * known;
      geometry.insert(geometry.end(), values, values + n_geometry);
      continue;
    }
    const dealii::Point<3> centroid = body.project(place);
    for (unsigned int d = 0; d < 3; ++d)
      geometry.push_back(centroid[d]);
    for (unsigned int d = 0; d < 3; ++d)
      geometry.push_back(d < dim ? area[d] : 0.);
  }
}


template <int dim>
void WallLoads<dim>::number_facets(const std::vector<std::uint64_t> &keys,
                                   const std::vector<double> &geometry)
{
  std::vector<std::uint64_t> all;
  for (const auto &of_rank :
       dealii::Utilities::MPI::all_gather(communicator_, keys))
    all.insert(all.end(), of_rank.begin(), of_rank.end());
  std::sort(all.begin(), all.end());
  if (records_.size() != all.size() || (!keys_.empty() && keys_ != all))
  {
    if (totals_.time > 0.)
      throw InputError("Loads: the facets are not those of the checkpoint");
    records_.assign(all.size(), {});
  }
  keys_ = all;
  geometry_.assign(n_geometry * keys_.size(), 0.);
  for (std::size_t i = 0; i < facets_.size(); ++i)
  {
    facets_[i].number =
      std::lower_bound(keys_.begin(), keys_.end(), keys[i]) - keys_.begin();
    std::copy_n(&geometry[n_geometry * i],
                n_geometry,
                &geometry_[n_geometry * facets_[i].number]);
  }
  dealii::Utilities::MPI::sum(geometry_, communicator_, geometry_);
  std::vector<std::size_t> numbers;
  for (const Facet &facet : facets_)
    numbers.push_back(facet.number);
  gauges_.reinit(geometry_, numbers);
}


template <int dim>
void WallLoads<dim>::share()
{
  if (keys_.empty() ||
      dealii::Utilities::MPI::n_mpi_processes(communicator_) == 1)
    return;
  constexpr std::size_t n = sizeof(Record) / sizeof(double);
  static_assert(n * sizeof(double) == sizeof(Record));
  std::vector<double> values(n * records_.size(), 0.);
  for (const Facet &facet : facets_)
    std::copy_n(reinterpret_cast<const double *>(&records_[facet.number]),
                n,
                &values[n * facet.number]);
  dealii::Utilities::MPI::sum(values, communicator_, values);
  std::copy_n(
    values.data(), values.size(), reinterpret_cast<double *>(records_.data()));
}


template <int dim>
template <typename Gas>
double WallLoads<dim>::wall_pressure(const Facet &facet,
                                     const GasField &field,
                                     const Gas &gas,
                                     const RiemannFlux flux) const
{
  using C = Component<dim>;
  constexpr unsigned int nc = n_conserved<dim, Gas>;
  std::array<double, nc> u;
  for (unsigned int c = 0; c < nc; ++c)
    u[c] = field.value(facet.leaf, c, facet.point);
  auto inside = to_primitive<dim>(gas, u);
  double speed = 0.;
  for (unsigned int d = 0; d < dim; ++d)
  {
    speed += inside[C::momentum + d] * facet.area[d] / facet.area.norm();
    inside[C::momentum + d] = 0.;
  }
  auto image = inside;
  inside[C::momentum] = speed;
  image[C::momentum] = -speed;
  const double pressure =
    numerical_flux(
      flux, to_face_state<dim>(gas, inside), to_face_state<dim>(gas, image), 1.)
      .momentum[0];
  return field.exerted_pressure(pressure,
                                field.burned(facet.leaf, facet.point));
}


template <int dim>
void WallLoads<dim>::add(const GasField &field,
                         const GasMaterial &material,
                         const RiemannFlux flux,
                         const double time,
                         const double step,
                         const QuietLeaves<dim> &quiet_leaves,
                         const std::array<double, 6> &wall_force)
{
  const TimerScope timer("loads");
  if (totals_.time == 0.)
    totals_.sample_begin = time - step;
  totals_.time = time;
  const double smallest = BlastRecord<double>::threshold * ambient_;
  std::array<double, 3> force = {};
  std::visit(
    [&](const auto &gas) {
      for (const Facet &facet : facets_)
      {
        if (quiet_leaves.is_quiet(facet.leaf))
          continue;
        const double overpressure =
          wall_pressure(facet, field, gas, flux) - ambient_;
        Record &record = records_[facet.number];
        record.blast.add(overpressure, time, step, smallest);
        // Over the step, the mean of begin and end.
        const double mean = 0.5 * (record.last + overpressure);
        record.last = overpressure;
        record.sum += mean * step;
        for (unsigned int d = 0; d < dim; ++d)
          force[d] += mean * facet.area[d];
      }
    },
    material.model());
  add_gauges(time, step);
  add_forces(force, wall_force, step);
  if (time - totals_.sample_begin >= interval_ * (1. - 1e-9))
    end_sample(time);
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
void WallLoads<dim>::add_forces(const std::array<double, 3> &facet_force,
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
  std::array<double, 3> facets, gas;
  for (unsigned int d = 0; d < 3; ++d)
  {
    facets[d] = sums[d];
    gas[d] = sums[3 + d];
    totals_.facet_impulse[d] += step * facets[d];
    totals_.gas_impulse[d] += step * gas[d];
  }
  totals_.largest_force = std::max(totals_.largest_force, norm(gas));
  totals_.largest_difference =
    std::max(totals_.largest_difference, distance(facets, gas));
}


template <int dim>
void WallLoads<dim>::end_sample(const double time)
{
  const std::size_t most_in_memory = 64 << 20;
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
  if (samples_.size() * sizeof(float) > most_in_memory)
    flush();
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
    if (!has_file_ && totals_.n_times > 0.)
      file.truncate(static_cast<std::size_t>(totals_.n_times));
    else if (!has_file_)
      create_file();
    file.append(times_, samples_);
    write_measures();
    gauges_.flush();
  }
  has_file_ = true;
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
    const double area = norm({{values[3], values[4], values[5]}});
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
    if (record.blast.peak > 0.05 * highest)
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
     relative(distance(totals_.facet_impulse, totals_.gas_impulse),
              norm(totals_.gas_impulse))});
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


template class WallLoads<1>;
template class WallLoads<2>;
template class WallLoads<3>;
} // namespace contrecoup::gas
