// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange_step.h>
#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/text.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  constexpr unsigned int width = AleState::width;
  using Lane = CellBatches::Lane;

  /// Three numbers of the corners of a batch.
  HexVectors<Lane> gather(const dealii::AlignedVector<double> &field,
                          const unsigned int *offsets)
  {
    HexVectors<Lane> result;
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      Lane values[width];
      dealii::vectorized_load_and_transpose(
        width, field.data(), offsets + CellBatches::n * corner, values);
      for (unsigned int d = 0; d < 3; ++d)
        result[corner][d] = values[d];
    }
    return result;
  }

  Lane gather_cells(const dealii::AlignedVector<double> &field,
                    const unsigned int *cells)
  {
    Lane result;
    result.gather(field.data(), cells);
    return result;
  }
} // namespace


void LagrangeStep::reinit(
  const HexSpace &space,
  const std::vector<Region> &regions,
  const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls,
  const Acceleration &acceleration)
{
  space_ = &space;
  regions_ = regions;
  acceleration_ = acceleration;
  walls_.reinit(space, space.positions(width), walls);
  batches_.reinit(space, width);
  for (const CellBatches::Range &range : batches_.ranges())
    if (range.region >= regions.size())
      throw InputError("Mesh: material id " + std::to_string(range.region) +
                       " is none of the " + std::to_string(regions.size()) +
                       " regions");
  node_exchange_.reinit(space.nodes(), width);
  force_.resize(node_exchange_.size());
  corner_forces_.resize(24 * batches_.n_batches());
  work_ = 0.;
}


void LagrangeStep::start(AleState &state) const
{
  dealii::AlignedVector<double> masses(node_exchange_.size());
  for (std::size_t c = 0; c < space_->n_own_cells(); ++c)
    for (const std::uint32_t node : space_->cell(c))
      masses[width * node + 3] += 0.125 * state.mass[c];
  node_exchange_.add_copies(masses);
  node_exchange_.update_copies(masses);
  node_exchange_.update_copies(state.velocity);
  for (std::size_t n = 0; n < space_->n_nodes(); ++n)
    state.velocity[width * n + 3] = 1. / masses[width * n + 3];
  walls_.apply(state.velocity, state.time);
}


template <typename Law>
void LagrangeStep::add_range(const CellBatches::Range &range,
                             const Law &law,
                             const FluidViscosity &viscosity,
                             const AleState &state)
{
  Lane rate(0.), least(std::numeric_limits<double>::max());
  for (unsigned int batch = range.begin; batch < range.end; ++batch)
  {
    const unsigned int *offsets = batches_.offsets(batch, 0);
    const unsigned int *cells = batches_.cells(batch);
    FluidElement<Lane> element;
    element.mass = gather_cells(state.mass, cells);
    element.energy = gather_cells(state.energy, cells);
    element.products = gather_cells(state.products, cells);
    const HexVectors<Lane> forces =
      fluid_forces(law,
                   viscosity,
                   gather(state.position, offsets),
                   gather(state.velocity, offsets),
                   element);
    rate = std::max(rate, element.signal_rate);
    least = std::min(least, element.volume);
    const Lane weight = batches_.weight(batch);
    Lane *stored = &corner_forces_[24 * batch];
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      Lane values[width];
      for (unsigned int d = 0; d < 3; ++d)
      {
        stored[3 * corner + d] = forces[corner][d];
        values[d] = -weight * forces[corner][d];
      }
      values[3] = Lane(0.);
      // One lane after the other: lanes may share a node.
      dealii::vectorized_transpose_and_store(
        true, width, values, offsets + CellBatches::n * corner, force_.data());
    }
  }
  signal_rate_ = std::max(signal_rate_, largest_lane(rate));
  least_volume_ = std::min(least_volume_, smallest_lane(least));
}


void LagrangeStep::add_forces(const AleState &state)
{
  force_.fill(0.);
  signal_rate_ = 0.;
  least_volume_ = std::numeric_limits<double>::max();
  for (const CellBatches::Range &range : batches_.ranges())
  {
    const Region &region = regions_[range.region];
    std::visit(
      [&](const auto &law) { add_range(range, law, region.viscosity, state); },
      region.law);
  }
  node_exchange_.add_copies(force_);
}


void LagrangeStep::accelerate(AleState &state,
                              const Start &start,
                              const double step) const
{
  const auto body = acceleration_(state.time);
  for (std::size_t n = 0; n < space_->n_own_nodes(); ++n)
  {
    const double *before = &start.velocity[width * n];
    double *after = &state.velocity[width * n];
    for (unsigned int d = 0; d < 3; ++d)
      after[d] =
        before[d] + step * (force_[width * n + d] * before[3] + body[d]);
  }
  node_exchange_.update_copies(state.velocity);
}


void LagrangeStep::move(AleState &state,
                        const Start &start,
                        const dealii::AlignedVector<double> &velocity,
                        const double step) const
{
  for (std::size_t n = 0; n < space_->n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      state.position[width * n + d] =
        start.position[width * n + d] + step * velocity[width * n + d];
}


void LagrangeStep::do_work(AleState &state,
                           const Start &start,
                           const dealii::AlignedVector<double> &velocity,
                           const double step)
{
  for (unsigned int batch = 0; batch < batches_.n_batches(); ++batch)
  {
    const HexVectors<Lane> v = gather(velocity, batches_.offsets(batch, 0));
    const Lane *forces = &corner_forces_[24 * batch];
    Lane power(0.);
    for (unsigned int corner = 0; corner < 8; ++corner)
      for (unsigned int d = 0; d < 3; ++d)
        power += forces[3 * corner + d] * v[corner][d];
    const unsigned int *cells = batches_.cells(batch);
    const Lane energy = gather_cells(start.energy, cells) + step * power;
    energy.scatter(cells, state.energy.data());
  }
}


bool LagrangeStep::is_physical(const AleState &state) const
{
  bool good = true;
  for (unsigned int batch = 0; batch < batches_.n_batches(); ++batch)
  {
    const auto x = gather(state.position, batches_.offsets(batch, 0));
    const Lane volume = hex_geometry(to_modes(x)).volume;
    const Lane energy = gather_cells(state.energy, batches_.cells(batch));
    // A NaN is not greater.
    good = good && all_greater(volume, Lane(0.)) &&
           all_greater(Lane(std::numeric_limits<double>::max()), energy);
  }
  return dealii::Utilities::MPI::min(good ? 1 : 0, space_->communicator()) == 1;
}


void LagrangeStep::book_work(const AleState &state,
                             const Start &start,
                             const dealii::AlignedVector<double> &mean,
                             const double step)
{
  for (std::size_t n = 0; n < space_->n_own_nodes(); ++n)
  {
    const std::size_t i = width * n;
    const double mass = 1. / state.velocity[i + 3];
    for (unsigned int d = 0; d < 3; ++d)
      work_ +=
        mean[i + d] * (mass * (state.velocity[i + d] - start.velocity[i + d]) -
                       step * force_[i + d]);
  }
}


bool LagrangeStep::try_step(AleState &state,
                            const Start &start,
                            const double step)
{
  // The forces are those of the start.
  const double begin = state.time;
  state.time = begin + 0.25 * step;
  accelerate(state, start, 0.5 * step);
  walls_.apply(state.velocity, begin + 0.5 * step);
  move(state, start, state.velocity, 0.5 * step);
  do_work(state, start, state.velocity, 0.5 * step);
  if (!is_physical(state))
    return false;

  state.time = begin + 0.5 * step;
  add_forces(state);
  accelerate(state, start, step);
  walls_.apply(state.velocity, begin + step);
  dealii::AlignedVector<double> mean = state.velocity;
  for (std::size_t i = 0; i < mean.size(); ++i)
    mean[i] = 0.5 * (mean[i] + start.velocity[i]);
  move(state, start, mean, step);
  do_work(state, start, mean, step);
  if (!is_physical(state))
    return false;
  book_work(state, start, mean, step);
  state.time = begin + step;
  return true;
}


double LagrangeStep::advance(AleState &state,
                             const double largest_step,
                             const double courant,
                             const unsigned int largest_retries)
{
  const Start start{state.position, state.velocity, state.energy};
  const double begin = state.time;
  double step = largest_step;
  for (unsigned int retry = 0; retry <= largest_retries; ++retry)
  {
    add_forces(state);
    if (retry == 0)
    {
      const double rate =
        dealii::Utilities::MPI::max(signal_rate_, space_->communicator());
      step = std::min(step, courant / rate);
    }
    if (try_step(state, start, step))
      return step;
    if (retry == largest_retries)
    {
      const AleState failed = state;
      state.position = start.position;
      state.velocity = start.velocity;
      state.energy = start.energy;
      state.time = begin;
      give_up(failed, step);
    }
    state.position = start.position;
    state.velocity = start.velocity;
    state.energy = start.energy;
    state.time = begin;
    step *= 0.5;
  }
  return step;
}
} // namespace contrecoup::ale
