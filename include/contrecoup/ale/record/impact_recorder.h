// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/impact_scene.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/io/file/state_file.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <vector>

namespace contrecoup::ale
{
/// State of an impact at the end of a time step, as both methods have it.
struct ImpactSnapshot
{
  const ImpactScene &impact;
  MPI_Comm communicator;
  double time = 0.; ///< end of the step [s]
  double step = 0.; ///< size of the step; 0: none yet in this run [s]
  /// Contact with rigid walls, of all ranks; nothing without walls.
  std::optional<ContactMeasures> contact = {};
  RunEnd end = {}; ///< what continues at this time
};

/**
 * Interface of the objects that observe an impact after each time step and keep
 * a record of it. A derived class overrides the functions that it needs and is
 * listed in AleRecorders or ParticleRecorders. All recorders exist in every
 * run: one that is off returns at once. All functions are collective.
 * @tparam Snapshot AleSnapshot or ParticleSnapshot
 */
template <typename Snapshot>
class ImpactRecorder
{
public:
  virtual ~ImpactRecorder() = default;

  static void declare_parameters(dealii::ParameterHandler & /*prm*/)
  {}
  /// @throws InputError for entries that contradict each other
  virtual void parse_parameters(dealii::ParameterHandler & /*prm*/,
                                const ImpactScene & /*impact*/)
  {}

  /// Prepares an empty record, at the start or for restore().
  virtual void reinit(const Snapshot & /*now*/)
  {}

  /// Records the initial state.
  virtual void begin(const Snapshot & /*now*/)
  {}

  /// Records the state at the end of a time step.
  virtual void record(const Snapshot & /*now*/)
  {}

  /// Records the state after rezoning, in each step of a moving mesh.
  virtual void record_rezoned(const Snapshot & /*now*/)
  {}

  /// Columns of a row of history.csv, which the call ends.
  virtual std::vector<NamedValue> history(const Snapshot & /*now*/)
  {
    return {};
  }
  /// Values for "results" in summary.json.
  virtual std::vector<NamedValue> results(const Snapshot & /*now*/) const
  {
    return {};
  }
  /// Differences from the reference solution, for "errors" in summary.json.
  virtual std::vector<NamedValue> errors(const Snapshot & /*now*/) const
  {
    return {};
  }

  /// Saves this rank's part of the record, or adds what a rank has saved, after
  /// reinit(). @throws InputError for a record of another scene
  virtual void save(io::StateWriter & /*out*/) const
  {}
  virtual void restore(const Snapshot & /*now*/, io::StateReader & /*in*/)
  {}
};
} // namespace contrecoup::ale
