// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation_parameters.h>

#include <cstdint>
#include <iosfwd>

namespace contrecoup::gas
{
/**
 * Counts steps until the octree must be adapted again: after the number of
 * steps that the parameters prescribe, or earlier if a front could otherwise
 * cross the AMR buffer. At a rigid body whose leaves are smaller than those at
 * fronts, the step is so short that a front needs many steps to cross one leaf.
 */
class AdaptationPace
{
public:
  AdaptationPace() = default;
  explicit AdaptationPace(const AdaptationParameters &parameters)
    : longest_(parameters.interval)
    , buffer_steps_(parameters.buffer_steps)
  {}

  /// Counts a step.
  /// @param travel distance that a front may have moved in the step, as a
  /// fraction of that in a step which leaves at fronts limit, not smaller ones
  /// at a body: Rates::front_rate over Rates::all of TimeStepper [-]
  void add_step(const double travel)
  {
    ++n_steps_;
    travel_ += travel;
    last_travel_ = travel;
  }

  /// Whether a front may leave the AMR buffer in the next step, if that is like
  /// the last one, or the prescribed number of steps is reached.
  bool is_due() const
  {
    return (longest_ > 0 && n_steps_ >= longest_) ||
           (n_steps_ > 0 && travel_ + last_travel_ > buffer_steps_);
  }

  /// Restarts the count at @p time [s].
  void restart(const double time)
  {
    n_steps_ = 0;
    travel_ = 0.;
    last_travel_ = 0.;
    start_ = time;
  }

  /// Time of the last restart [s].
  double start() const
  {
    return start_;
  }

  /// Writes the count to a checkpoint.
  void save(std::ostream &stream) const;
  /// Reads what save() wrote.
  void load(std::istream &stream);

private:
  unsigned int longest_ = 0; ///< steps; 0: no such limit
  double buffer_steps_ = 1.; ///< see AdaptationParameters
  std::uint64_t n_steps_ = 0;
  double travel_ = 0.; ///< sum over the steps since the restart [-]
  double last_travel_ = 0.;
  double start_ = 0.; ///< see start()
};
} // namespace contrecoup::gas
