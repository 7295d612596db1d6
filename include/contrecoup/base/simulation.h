// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/remaining_time.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
/// What one time step did.
struct StepReport
{
  /// Step size taken [s].
  double step_size = 0.;
  /// Unknowns updated, all ranks and Runge-Kutta stages together [-].
  double updates = 0.;
  /// Times that the step was cut back because a state turned unphysical.
  unsigned int retries = 0;
};

/// A named number with its unit, for histories and the summary.
struct NamedValue
{
  std::string name;
  std::string unit;
  double value = 0.;
  /// Whether a closed run keeps it: its first and last value and relative
  /// change then stand under "conservation" in the summary.
  bool conserved = false;
};

/// What a run would cost, for --check and the printed plan.
struct CostEstimate
{
  double cells = 0.;    ///< mesh cells, all ranks [-]
  double unknowns = 0.; ///< unknowns, all ranks [-]
  double steps = 0.;    ///< time steps to the end time [-]
  double memory = 0.;   ///< peak memory, all ranks [byte]
  double seconds = 0.;  ///< wall time [s]
  double output = 0.;   ///< results on disk, no checkpoints [byte]
};

/**
 * Something that a run leaves out or takes for granted, with the number that
 * tells whether it may: estimated before the run, measured by it.
 */
struct Assumption
{
  std::string name;     ///< in the summary
  std::string decision; ///< what is done, in a few words
  std::string quantity; ///< what the number is, in a few words
  std::string unit;
  /// The number; NaN: not known.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// What it may be at most, or at least; NaN: it is for information.
  double limit = std::numeric_limits<double>::quiet_NaN();
  bool is_least = false; ///< whether the limit is the least
  std::string entry;     ///< of the parameter file that decides otherwise

  /// Whether the number is known and beyond its limit.
  bool fails() const
  {
    return is_least ? value < limit : value > limit;
  }
};

/**
 * One solver as the run loop sees it: setup, advance, adapt, output, and a
 * state that can be saved and restored. Every function is collective.
 */
class Simulation
{
public:
  virtual ~Simulation() = default;

  /// Checks the scene and estimates its cost without allocating its fields.
  /// @throws InputError when the scene is impossible.
  virtual CostEstimate estimate() = 0;

  /// Builds mesh and initial state at time 0.
  virtual void setup() = 0;

  /// Builds mesh and state from the files that save() left in @p folder.
  /// @throws InputError when they belong to another scene.
  virtual void restore(const std::string &folder) = 0;

  /// Writes mesh and state into the existing @p folder.
  virtual void save(const std::string &folder) = 0;

  /// Says where the run keeps its results, before setup() or restore().
  virtual void set_output_folder(const std::string & /*folder*/)
  {}

  /// Simulated time [s].
  virtual double time() const = 0;

  /// Goes one step ahead, by at most @p largest_step [s].
  /// @throws NumericsError when no step size keeps the state physical.
  virtual StepReport advance(double largest_step) = 0;

  /// Adapts the mesh if the solver finds it due. Returns whether it changed.
  virtual bool adapt() = 0;

  /// Conserved totals, energies, extrema: one row of history.csv. Names and
  /// order never change during a run.
  virtual std::vector<NamedValue> history() = 0;

  /// Probe values at this time: one row of probes.csv; empty without probes.
  virtual std::vector<NamedValue> probes() = 0;

  /// Writes the fields of output number @p index into @p folder, and
  /// returns the file that the .pvd collection should name (empty: none).
  virtual std::string write_fields(const std::string &folder,
                                   unsigned int index) = 0;

  /// Errors against the scene's reference, for the summary; may be empty.
  virtual std::vector<NamedValue> errors() = 0;

  /// Measured modelling assumptions, for the summary; may be empty.
  virtual std::vector<NamedValue> assumptions() = 0;

  /// What the run will leave out and take for granted, as estimated from the
  /// scene; may be asked before setup().
  virtual std::vector<Assumption> plan()
  {
    return {};
  }

  /// The same with the numbers that the run found, in the same order; only
  /// for what it could measure.
  virtual std::vector<Assumption> audit()
  {
    return {};
  }

  /// The work that is left until @p end_time [s], as the state of the run and
  /// its parameters let expect it, NaN where they do not; empty: as much in a
  /// second of simulated time as lately.
  virtual WorkForecast expected_work(const double /*end_time*/)
  {
    return {};
  }

  /// When the stage at work is expected to hand over to one whose work cannot
  /// be known before it begins [s], NaN: not known; nullopt: no stage does.
  virtual std::optional<double> expected_hand_over()
  {
    return std::nullopt;
  }

  /// Space dimensions of the mesh that is at work [-]: the cost of its cells
  /// grows with these.
  virtual unsigned int dimension() const
  {
    return 3;
  }

  /// Writes what belongs to the end of a run into the output folder; called
  /// once, when the end time is reached.
  virtual void finish(const std::string & /*folder*/)
  {}

  /// Number of cells and of unknowns, all ranks.
  virtual std::pair<std::uint64_t, std::uint64_t> size() const = 0;
};
} // namespace contrecoup
