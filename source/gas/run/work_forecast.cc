// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/run/work_forecast.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
namespace
{
  /// Number of intervals of the forecast.
  constexpr unsigned int n_intervals = 16;
} // namespace


template <int dim>
WorkForecaster<dim>::WorkForecaster(const LeafMesh<dim> &mesh,
                                    const TimeStepper<dim> &stepper,
                                    const QuietLeaves<dim> &quiet_leaves,
                                    const Adaptation<dim> &adaptation,
                                    const dealii::Point<dim> &centre,
                                    std::function<double(double)> front,
                                    const double sound_speed)
  : mesh_(mesh)
  , adaptation_(adaptation)
  , front_(std::move(front))
  , sound_speed_(sound_speed)
  , leaves_(mesh.n_owned())
{
  for (unsigned int i = 0; i < leaves_.size(); ++i)
  {
    const auto &cell = mesh.cell(i);
    Leaf &leaf = leaves_[i];
    leaf.reached_at = cell->center().distance(centre) - 0.5 * cell->diameter();
    leaf.diameter = cell->diameter();
    leaf.rate = stepper.signal_rate(i);
    leaf.is_active = quiet_leaves.is_active(i / mesh.width());
    leaf.level = cell->level();
    leaf.min_level = adaptation.levels().min_level_near_body(i);
    leaf.merges_now = merges(i, adaptation.time());
  }
}


template <int dim>
unsigned int WorkForecaster<dim>::merges(const unsigned int leaf,
                                         const double time) const
{
  const unsigned int level = std::max(
    adaptation_.levels().max_level(leaf, time), leaves_[leaf].min_level);
  return std::max(leaves_[leaf].level, level) - level;
}


template <int dim>
double WorkForecaster<dim>::signal_factor(const double time) const
{
  // Rankine-Hugoniot relations of air.
  constexpr double gamma = 1.4;
  const double step = 1e-3 * time;
  const double mach =
    (front_(time + step) - front_(time)) / (step * sound_speed_);
  if (!(mach > 1.))
    return 1.;
  const double square = mach * mach;
  const double velocity = 2. / (gamma + 1.) * (mach - 1. / mach);
  const double heat = (1. + 2. * gamma / (gamma + 1.) * (square - 1.)) *
                      (2. + (gamma - 1.) * square) / ((gamma + 1.) * square);
  return velocity / dim + std::sqrt(heat);
}


template <int dim>
WorkForecast WorkForecaster<dim>::forecast(const double time,
                                           const double end_time) const
{
  const auto &communicator = mesh_.communicator();
  std::vector<double> counts(n_intervals, 0.), rates(n_intervals, 0.);
  for (unsigned int k = 0; k < n_intervals; ++k)
  {
    const double then = time + (end_time - time) * (k + 0.5) / n_intervals;
    const double factor = signal_factor(then);
    const double front = front_(then);
    for (unsigned int i = 0; i < leaves_.size(); ++i)
    {
      const Leaf &leaf = leaves_[i];
      if (leaf.is_active || !(leaf.reached_at < front))
      {
        const unsigned int more =
          std::max(merges(i, then), leaf.merges_now) - leaf.merges_now;
        const double size = std::ldexp(1., int(more));
        counts[k] += leaf.is_active ? std::pow(size, -dim) : 0.;
        // Hot products keep their sound speed when the front slows down.
        rates[k] = std::max(rates[k], leaf.rate / size);
        continue;
      }
      // The front refines leaves to the largest level; leaves behind it are not
      // coarsened.
      const unsigned int most = adaptation_.levels().max_level(i, then);
      const double size =
        std::ldexp(1., int(std::max(most, leaf.level) - leaf.level));
      const bool is_at_front = front - leaf.reached_at < leaf.diameter;
      counts[k] += is_at_front ? std::pow(size, dim - 1) : 1.;
      rates[k] = std::max(rates[k], leaf.rate * factor * size);
    }
  }
  dealii::Utilities::MPI::sum(counts, communicator, counts);
  dealii::Utilities::MPI::max(rates, communicator, rates);
  WorkForecast result;
  for (unsigned int k = 0; k < n_intervals; ++k)
    result.emplace_back(time + (end_time - time) * (k + 1.) / n_intervals,
                        counts[k] * rates[k]);
  return result;
}


template class WorkForecaster<1>;
template class WorkForecaster<2>;
template class WorkForecaster<3>;
} // namespace contrecoup::gas
