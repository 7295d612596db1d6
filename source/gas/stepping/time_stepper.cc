// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/timers.h>
#include <contrecoup/gas/stepping/time_stepper.h>

namespace contrecoup::gas
{
template <int dim>
TimeStepper<dim>::TimeStepper(const LeafMesh<dim> &mesh,
                              const Scheme &scheme,
                              GasOperator<dim> &gas_operator,
                              QuietLeaves<dim> &quiet_leaves)
  : mesh_(mesh)
  , scheme_(scheme)
  , operator_(gas_operator)
  , quiet_leaves_(quiet_leaves)
{}


template <int dim>
void TimeStepper<dim>::reinit(GasField &field)
{
  operator_.reinit();
  exchange_.reinit(mesh_, field.layout());
  precision_ = field.layout().precision;
  visit_precision(precision_, [&](const auto real) {
    signal_rates<std::decay_t<decltype(real)>>().resize(mesh_.first_ghost());
  });
  compute_sensors(field);
  quiet_leaves_.reinit(field, operator_.driven_leaves());
  for (const unsigned int batch : operator_.closed_batches())
    field.copy_to_stages(batch);
}


template <int dim>
void TimeStepper<dim>::analyse(GasField &field)
{
  compute_sensors(field);
  if (quiet_leaves_.have_products())
    quiet_leaves_.reinit(field, operator_.driven_leaves());
}


template <int dim>
void TimeStepper<dim>::compute_sensors(GasField &field)
{
  visit_precision(precision_, [&](const auto real) {
    using Real = std::decay_t<decltype(real)>;
    BasicStage<Real> stage;
    stage.results.state = field.state<Real>();
    stage.results.sensor = field.sensors<Real>();
    stage.results.signal_rate = signal_rates<Real>().data();
    stage.burn = field.burn();
    stage.end_time = field.time();
    operator_.analyse(stage);
  });
}


template <int dim>
typename TimeStepper<dim>::Rates
TimeStepper<dim>::largest_rates(const std::vector<double> &size_ratios) const
{
  std::vector<double> largest = {0., 0.};
  for (unsigned int leaf = 0; leaf < mesh_.n_owned(); ++leaf)
  {
    const double rate = signal_rate(leaf);
    const double ratio = size_ratios.empty() ? 1. : size_ratios[leaf];
    largest[0] = std::max(largest[0], rate);
    largest[1] = std::max(largest[1], ratio * rate);
  }
  dealii::Utilities::MPI::max(largest, mesh_.communicator(), largest);
  return {largest[0], largest[1]};
}


template <int dim>
template <typename Real>
std::optional<unsigned int>
TimeStepper<dim>::try_step(GasField &field,
                           const double time,
                           const double step,
                           const bool bound_velocity_slopes)
{
  const auto &stages = scheme_.time_stepping.stages;
  Real *in = field.state<Real>();
  Real *sensor = field.sensors<Real>();
  unsigned int target = 0;
  unphysical_leaf_ = no_leaf;
  wall_force_.fill(0.);
  for (unsigned int s = 0; s < stages.size(); ++s)
  {
    {
      const TimerScope timer("ghost exchange");
      exchange_.update(in, sensor);
    }
    target = s % 2;
    BasicStage<Real> stage;
    stage.start = field.state<Real>();
    stage.in = in;
    stage.results.state = field.stage<Real>(target);
    stage.a = stages[s].initial_weight;
    stage.step = step;
    stage.time = time + stages[s].time * step;
    stage.end_time = time + step;
    stage.burn = field.burn();
    stage.sensor = sensor;
    stage.results.sensor = field.stage_sensors<Real>(target);
    stage.results.signal_rate =
      s + 1 == stages.size() ? signal_rates<Real>().data() : nullptr;
    stage.bound_velocity_slopes = bound_velocity_slopes;
    stage.results.wall_force = &wall_force_;
    for (unsigned int later = s; later < stages.size(); ++later)
      stage.weight *= 1. - stages[later].initial_weight;
    stage.results.unphysical_leaf = &unphysical_leaf_;
    operator_.apply(stage, quiet_leaves_);
    if (operator_.redistributes())
    {
      exchange_.update(stage.results.state, stage.results.sensor);
      operator_.redistribute(stage, quiet_leaves_);
    }
    in = field.stage<Real>(target);
    sensor = field.stage_sensors<Real>(target);
  }
  // One agreement for all stages: later ones of a bad step do no harm.
  const bool is_bad = unphysical_leaf_ != no_leaf;
  if (dealii::Utilities::MPI::max(is_bad ? 1U : 0U, mesh_.communicator()) > 0)
    return {};
  return target;
}


template <int dim>
typename TimeStepper<dim>::Result
TimeStepper<dim>::advance(GasField &field, const double time, const double step)
{
  const auto try_once = [&](const double length,
                            const bool bound_velocity_slopes) {
    return visit_precision(precision_, [&](const auto real) {
      return try_step<std::decay_t<decltype(real)>>(
        field, time, length, bound_velocity_slopes);
    });
  };
  Result result;
  result.step = step;
  for (;;)
  {
    // First as accurate as the scheme is, then bounded, then shorter.
    auto target = try_once(result.step, false);
    result.bound_velocity_slopes = !target && can_bound_velocity_slopes();
    if (result.bound_velocity_slopes)
      target = try_once(result.step, true);
    if (target)
    {
      field.accept_stage(*target);
      result.wall_force = wall_force_;
      return result;
    }
    if (result.retries == scheme_.largest_retries)
    {
      result.failed = true;
      if (unphysical_leaf_ != no_leaf)
        result.unphysical_leaf = unphysical_leaf_;
      return result;
    }
    ++result.retries;
    result.step *= 0.5;
  }
}


template class TimeStepper<1>;
template class TimeStepper<2>;
template class TimeStepper<3>;
} // namespace contrecoup::gas
