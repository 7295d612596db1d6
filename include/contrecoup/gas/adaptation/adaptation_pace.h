// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/adaptation/adaptation_parameters.h>

#include <cstdint>
#include <iosfwd>

namespace contrecoup::gas
{
/**
 * Counts steps until the octree has to adapt again: as many as the parameters
 * say, and fewer where a front could else cross the buffer of leaves ahead of
 * it. Where a rigid body has smaller leaves than fronts may have, the step is
 * so short that a front needs many of them to cross one of its own leaves.
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
  /// @param share of the buffer that a front may have crossed, in parts of what
  /// it crosses where leaves that set the step size have their smallest size,
  /// see TimeStepper::Rates [-]
  void add_step(const double travel)
  {
    ++n_steps_;
    travel_ += travel;
    last_travel_ = travel;
  }

  /// Whether a front may else leave the buffer in the step that comes, if it
  /// is like the last one.
  bool is_due() const
  {
    return (longest_ > 0 && n_steps_ >= longest_) ||
           (n_steps_ > 0 && travel_ + last_travel_ > buffer_steps_);
  }

  /// Begins to count anew at time @p time [s].
  void restart(const double time)
  {
    n_steps_ = 0;
    travel_ = 0.;
    last_travel_ = 0.;
    start_ = time;
  }

  /// Time when it began to count [s].
  double start() const
  {
    return start_;
  }

  /// Writes what it has counted.
  void save(std::ostream &stream) const;
  /// Reads what save() wrote.
  void load(std::istream &stream);

private:
  unsigned int longest_ = 0; ///< steps; 0: no such limit
  double buffer_steps_ = 1.; ///< see AdaptationParameters
  std::uint64_t n_steps_ = 0;
  double travel_ = 0.; ///< sum of the shares
  double last_travel_ = 0.;
  double start_ = 0.; ///< see start()
};
} // namespace contrecoup::gas
