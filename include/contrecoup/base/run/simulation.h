// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/remaining_time.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup
{
/// Result of a time step.
struct StepReport
{
  /// Size of the step [s].
  double step_size = 0.;
  /// Unknowns updated, all ranks and Runge-Kutta stages together [-].
  double updates = 0.;
  /// Number of step size reductions after an unphysical state.
  unsigned int retries = 0;
};

/// A named value with unit, for history and summary.
struct NamedValue
{
  std::string name;
  std::string unit;
  double value = 0.;
  /// Whether the value is conserved in a closed domain: the summary then lists
  /// first value, last value and relative change under "conservation".
  bool conserved = false;
};

/// Cost estimate of a run, for --check and the printed plan.
struct CostEstimate
{
  double cells = 0.;    ///< mesh cells, all ranks [-]
  double unknowns = 0.; ///< unknowns, all ranks [-]
  double steps = 0.;    ///< time steps to the end time [-]
  double memory = 0.;   ///< peak memory, all ranks [byte]
  double seconds = 0.;  ///< wall time [s]
  double output = 0.;   ///< results and checkpoints on disk [byte]
  std::string gap;      ///< reason for unknown figures, which are 0
};

/// A file of one field output.
struct FieldFile
{
  std::string part; ///< what it shows, such as "skin"; empty: everything
  std::string file; ///< name, without folder
};

/// A modelling assumption or simplification of a run, with a figure that tells
/// whether it is justified: estimated before the run, measured by the run.
struct Assumption
{
  std::string name;     ///< in the summary
  std::string decision; ///< the modelling choice, in a few words
  std::string quantity; ///< meaning of the value, in a few words
  std::string unit;
  /// Figure; NaN: unknown.
  double value = std::numeric_limits<double>::quiet_NaN();
  /// Upper or lower limit of the figure; NaN: for information only.
  double limit = std::numeric_limits<double>::quiet_NaN();
  bool is_lower_limit = false; ///< otherwise an upper limit
  std::string entry;           ///< parameter entry that changes the decision
  /// In an audit: the figure of the plan, as the run does not measure it.
  bool is_estimate = false;

  /// Whether the figure is known and violates its limit.
  bool fails() const
  {
    return is_lower_limit ? value < limit : value > limit;
  }

  void measure(const double figure)
  {
    value = figure;
    is_estimate = false;
  }
};

/// The items of a plan as those of an audit that has not measured them.
inline std::vector<Assumption> unmeasured(std::vector<Assumption> plan)
{
  for (Assumption &item : plan)
    item.is_estimate = true;
  return plan;
}

/// Interface of a solver for the run loop: setup, advance, adapt, output, save
/// and restore. Every function is collective.
class Simulation
{
public:
  virtual ~Simulation() = default;

  /// Checks the scene and estimates its cost without allocating fields.
  /// @throws InputError for an invalid scene
  virtual CostEstimate estimate() = 0;

  /// Builds mesh and initial state at time 0.
  virtual void setup() = 0;

  /// Restores mesh and state from files of save() in @p folder.
  /// @throws InputError when they belong to another scene
  virtual void restore(const std::string &folder) = 0;

  /// Saves mesh and state to the existing @p folder.
  virtual void save(const std::string &folder) = 0;

  /// Sets the output folder of the run; called before setup() or restore().
  virtual void set_output_folder(const std::string & /*folder*/)
  {}

  /// Simulated time [s].
  virtual double time() const = 0;

  /// Makes one step of at most @p largest_step [s].
  /// @throws NumericsError when no step size gives a physical state
  virtual StepReport advance(double largest_step) = 0;

  /// Adapts the mesh if due. Returns whether the mesh changed.
  virtual bool adapt() = 0;

  /// One row of history.csv: conserved totals, energies, extrema. Names and
  /// order must not change during a run.
  virtual std::vector<NamedValue> history() = 0;

  /// One row of probes.csv: current values at probes; empty without probes.
  virtual std::vector<NamedValue> probes() = 0;

  /// Writes field output number @p index into @p folder; returns the files for
  /// the .pvd collection, which the first rank must know.
  virtual std::vector<FieldFile> write_fields(const std::string &folder,
                                              unsigned int index) = 0;

  /// Errors against the reference solution, for the summary; may be empty.
  virtual std::vector<NamedValue> errors() = 0;

  /// Results for the summary; may be empty.
  virtual std::vector<NamedValue> results()
  {
    return {};
  }

  /// Figures that tell whether the results can be trusted, for the summary: of
  /// energy, time step, mesh and recording; may be empty.
  virtual std::vector<NamedValue> checks()
  {
    return {};
  }

  /// Assumptions of the run, estimated from the scene; may be called before
  /// setup().
  virtual std::vector<Assumption> plan()
  {
    return {};
  }

  /// The assumptions of plan(), in the same order, with measured values; only
  /// those that the run could measure.
  virtual std::vector<Assumption> audit()
  {
    return {};
  }

  /// Forecast of the remaining work until @p end_time [s], from state and
  /// parameters, NaN where unknown; empty: constant recent work per second of
  /// simulated time.
  virtual WorkForecast expected_work(const double /*end_time*/)
  {
    return {};
  }

  /// Expected time at which the running stage hands over to a stage whose work
  /// is unknown until it begins [s], NaN: unknown; nullopt: no such stage.
  virtual std::optional<double> expected_hand_over()
  {
    return std::nullopt;
  }

  /// Space dimensions of the current mesh [-], which determine how its cost
  /// grows with refinement.
  virtual unsigned int dimension() const
  {
    return 3;
  }

  /// Results that the run lacks until now, as it is too short or stopped: a
  /// clause each, of which the run warns when it ends.
  virtual std::vector<std::string> gaps()
  {
    return {};
  }

  /// Writes final results to the output folder; called once, at the end time.
  virtual void finish(const std::string & /*folder*/)
  {}

  /// Number of cells and of unknowns, all ranks.
  virtual std::pair<std::uint64_t, std::uint64_t> size() const = 0;
};
} // namespace contrecoup
