// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/bounds.h>
#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/gather.h>
#include <contrecoup/base/parameters.h>
#include <contrecoup/base/timers.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/record/wall_loads.h>
#include <contrecoup/gas/state/primitive.h>

#include <deal.II/base/mpi.h>

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
               "written to loads.h5 as the run goes.");
  declare_double(prm,
                 "Interval",
                 "0",
                 0.,
                 bounds::time,
                 "s",
                 "Time between samples, which are means since the last one, so "
                 "that impulses stay exact; 0 for every step. Peaks and "
                 "arrivals are found from every step anyhow.");
  declare_double(prm,
                 "Largest loss of peaks",
                 "0.01",
                 0.,
                 1.,
                 "-",
                 "Part of a facet's peak that samples may miss; where the next "
                 "step would make it more, the sample ends before and after "
                 "that step. 1: samples end by the interval alone.");
  declare_double(prm,
                 "Smallest overpressure",
                 "1e-4",
                 0.,
                 0.01,
                 "-",
                 "Part of the ambient pressure by which the pressure on some "
                 "facet must differ from it before samples are kept, each by "
                 "itself; the first one is the mean of all time before, so "
                 "that impulses stay exact.");
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
  largest_loss_ = read_double(prm, "Largest loss of peaks");
  smallest_ = read_double(prm, "Smallest overpressure");
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
  pressures_.assign(facets_.size(), 0.);
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
  for (unsigned int q = 0; q < layout.n_points; ++q)
  {
    dealii::Tensor<1, dim> area;
    if constexpr (dim > 1)
      area = cut_leaves.wall({leaf, q});
    if (area.norm() < nothing || cut_leaves.fractions()(leaf, q) == 0.)
      continue;
    dealii::Point<dim> place = box.origin;
    const double volume = cut_leaves.cell_volume({leaf, q});
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
  for (const auto &of_rank : gather_arrays(communicator_, keys))
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
  totals_.time = time;
  const double smallest = BlastRecord<double>::threshold * ambient_;
  dealii::Tensor<1, 3> force;
  std::visit(
    [&](const auto &gas) {
      for (std::size_t i = 0; i < facets_.size(); ++i)
      {
        const Facet &facet = facets_[i];
        pressures_[i] = quiet_leaves.is_quiet(facet.leaf)
                          ? 0.
                          : wall_pressure(facet, field, gas, flux) - ambient_;
      }
    },
    material.model());
  if (is_waiting() && has_arrived())
    begin_samples(time - step, step);
  const bool is_peak = !is_waiting() && loses_peaks(time, step);
  if (is_peak && time - step > totals_.sample_begin)
    end_sample(time - step);
  for (std::size_t i = 0; i < facets_.size(); ++i)
  {
    Record &record = records_[facets_[i].number];
    record.blast.add(pressures_[i], time, step, smallest);
    // Over the step, the mean of begin and end.
    for (unsigned int d = 0; d < dim; ++d)
      force[d] += 0.5 * (record.last + pressures_[i]) * facets_[i].area[d];
    record.last = pressures_[i];
    record.sum += pressures_[i] * step;
  }
  add_gauges(time, step);
  add_forces(force, wall_force, step);
  const double duration = time - totals_.sample_begin;
  if (is_peak || (!is_waiting() && duration >= interval_ * (1. - 1e-9)))
    end_sample(time);
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
bool WallLoads<dim>::loses_peaks(const double time, const double step)
{
  if (largest_loss_ >= 1.)
    return false;
  // Half of what may be lost, for the round-off of floats and slow rises that
  // are cut short.
  const double part = 1. - 0.5 * largest_loss_;
  const double duration = time - totals_.sample_begin;
  double loses = 0.;
  for (std::size_t i = 0; i < facets_.size(); ++i)
  {
    const double now = pressures_[i];
    const Record &record = records_[facets_[i].number];
    const double peak = std::max(now, record.blast.peak);
    if (peak <= counted_part * totals_.highest ||
        record.sample_peak >= part * peak)
      continue;
    // The peak is in the sample that is going on, or comes with this step.
    const double before = duration > step ? record.sum / (duration - step) : 0.;
    const double after = (record.sum + now * step) / duration;
    if (after < part * peak && std::max(before, now) >= part * peak)
      loses = 1.;
  }
  const double highest =
    pressures_.empty()
      ? 0.
      : *std::max_element(pressures_.begin(), pressures_.end());
  std::vector<double> largest = {loses, highest};
  dealii::Utilities::MPI::max(largest, communicator_, largest);
  totals_.highest = std::max(totals_.highest, largest[1]);
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


template class WallLoads<1>;
template class WallLoads<2>;
template class WallLoads<3>;
} // namespace contrecoup::gas
