// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/numerics/element/hex8_corner_weights.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::ale
{
void LagrangeStep::reinit(
  const HexSpace &space,
  const std::vector<Region> &regions,
  const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls,
  const Acceleration &acceleration,
  const ContactPlanes &planes,
  const InterfaceCoupling &coupling)
{
  space_ = &space;
  acceleration_ = acceleration;
  walls_.reinit(space, space.positions(node_width), walls);
  ties_.reinit(space);
  forces_.reinit(space, regions);
  node_exchange_.reinit(space.nodes(), node_width);
  planes_ = planes;
  planes_.reinit(space,
                 space.positions(node_width),
                 [&](const dealii::types::boundary_id boundary) {
                   return walls.count(boundary) == 0;
                 });
  coupling_ = coupling;
  coupling_.reinit(space, regions, walls_);
  contact_ = ContactMeasures();
  force_.resize(node_exchange_.size());
  work_ = slip_work_ = 0.;
  has_forces_ = false;
}


void LagrangeStep::start(AleState &state)
{
  dealii::AlignedVector<double> masses(node_exchange_.size());
  std::array<double, 8> weights;
  weights.fill(0.125);
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
  {
    if (state.wedge.active())
      weights = hex_corner_weights(corners_of(space_->cell(c), state.position));
    for (unsigned int i = 0; i < 8; ++i)
      masses[node_width * space_->cell(c)[i] + 3] += weights[i] * state.mass[c];
  }
  node_exchange_.compress_add(masses);
  node_exchange_.update_ghost_values(masses);
  node_exchange_.update_ghost_values(state.velocity);
  for (std::size_t n = 0; n < space_->n_nodes(); ++n)
    state.velocity[node_width * n + 3] = 1. / masses[node_width * n + 3];
  walls_.apply(state.velocity, state.time);
  ties_.find_normals(state.position, walls_);
  ties_.apply(state.velocity);
}


void LagrangeStep::add_forces(AleState &state, const double step)
{
  force_.fill(0.);
  forces_.compute(state, step, force_);
  node_exchange_.compress_add(force_);
}


void LagrangeStep::accelerate(AleState &state,
                              const Start &start,
                              const double step) const
{
  const auto body = acceleration_(state.time);
  for (std::size_t n = 0; n < space_->n_locally_owned_nodes(); ++n)
  {
    const double *before = &start.velocity[node_width * n];
    double *after = &state.velocity[node_width * n];
    for (unsigned int d = 0; d < 3; ++d)
      after[d] =
        before[d] + step * (force_[node_width * n + d] * before[3] + body[d]);
    after[3] = before[3];
  }
  node_exchange_.update_ghost_values(state.velocity);
}


void LagrangeStep::move(AleState &state,
                        const Start &start,
                        const double step) const
{
  for (std::size_t n = 0; n < space_->n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
      state.position[node_width * n + d] =
        start.position[node_width * n + d] +
        step * state.velocity[node_width * n + d];
}


bool LagrangeStep::all(const bool good) const
{
  return dealii::Utilities::MPI::min(good ? 1 : 0, space_->communicator()) == 1;
}


double LagrangeStep::move_by_mean(AleState &state,
                                  const Start &start,
                                  const double step)
{
  mean_.resize_fast(state.velocity.size());
  double work = 0.;
  for (std::size_t n = 0; n < space_->n_nodes(); ++n)
  {
    const std::size_t i = node_width * n;
    double change_of_energy = 0., work_of_forces = 0.;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double after = state.velocity[i + d],
                   before = start.velocity[i + d];
      const double mean = 0.5 * (after + before);
      mean_[i + d] = mean;
      state.position[i + d] = start.position[i + d] + step * mean;
      change_of_energy += mean * (after - before);
      work_of_forces += mean * force_[i + d];
    }
    if (n < space_->n_locally_owned_nodes())
      work += change_of_energy / state.velocity[i + 3] - step * work_of_forces;
  }
  return work;
}


void LagrangeStep::add_contact(const ContactMeasures &now)
{
  contact_.force = now.force;
  contact_.area = now.area;
  contact_.work += now.work;
  contact_.friction_work += now.friction_work;
  contact_.sliding_work += now.sliding_work;
}


bool LagrangeStep::try_step(AleState &state,
                            const Start &start,
                            const double step)
{
  // These forces are those of the start of the step.
  if (!coupling_.balance(start.velocity, true, force_))
    return false;
  const double begin = state.time;
  state.time = begin + 0.25 * step;
  accelerate(state, start, 0.5 * step);
  walls_.apply(state.velocity, begin + 0.5 * step);
  ties_.apply(state.velocity);
  planes_.apply(state.velocity, start.position);
  move(state, start, 0.5 * step);
  forces_.add_work(
    start.energy, state.velocity, 0.5 * step, state.energy, true);

  state.time = begin + 0.5 * step;
  add_forces(state, step);
  if (!all(forces_.has_volumes()) ||
      !coupling_.balance(start.velocity, false, force_))
    return false;
  accelerate(state, start, step);
  walls_.apply(state.velocity, begin + step);
  ties_.apply(state.velocity);
  planes_.apply(state.velocity, start.position);
  const double work = move_by_mean(state, start, step);
  const bool is_finite =
    forces_.add_work(start.energy, mean_, step, state.energy, false);
  // Forces for the start of the next step.
  add_forces(state, 0.);
  if (!all(is_finite && forces_.has_volumes()))
    return false;
  work_ += work;
  slip_work_ += ties_.work(mean_);
  coupling_.finish_step(mean_, step);
  if (!planes_.empty())
    add_contact(planes_.measures(mean_, state.velocity, step));
  state.time = begin + step;
  return true;
}


double LagrangeStep::advance(AleState &state,
                             const double largest_step,
                             const double courant,
                             const unsigned int largest_retries,
                             const bool state_is_unchanged)
{
  if (!state_is_unchanged || !has_forces_)
    add_forces(state, 0.);
  has_forces_ = false;
  const double rate =
    dealii::Utilities::MPI::max(forces_.signal_rate(), space_->communicator());
  if (!(state.time + courant / rate > state.time))
    give_up_signals(state, courant / rate);
  Start &start = start_;
  start.swap_from(state);
  ties_.find_normals(start.position, walls_);
  const double begin = state.time;
  double step = std::min(largest_step, courant / rate);
  for (unsigned int retry = 0; retry <= largest_retries; ++retry)
  {
    n_retries_ = retry;
    if (retry > 0)
      add_forces(state, 0.);
    has_forces_ = try_step(state, start, step);
    if (has_forces_)
      return step;
    if (retry == largest_retries || coupling_.has_diverged() ||
        !(begin + 0.5 * step > begin))
    {
      const AleState failed = state;
      start.give_back(state);
      state.time = begin;
      throw_step_failure(failed, step);
    }
    start.give_back(state);
    state.time = begin;
    step *= 0.5;
  }
  return step;
}
} // namespace contrecoup::ale
