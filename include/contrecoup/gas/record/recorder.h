// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/scene/gas_scene.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>

#include <array>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/// State of the gas at the end of a time step, with the mesh that holds it, as
/// passed to the recorders.
template <int dim>
struct GasSnapshot
{
  const GasScene<dim> &scene;
  const LeafMesh<dim> &mesh;
  const GasField &field;
  const CutLeaves<dim> &cut_leaves; ///< valid only if the scene has a body
  const QuietLeaves<dim> &quiet_leaves;
  double time = 0.; ///< end of the step [s]
  double step = 0.; ///< size of the step [s]
  std::uint64_t step_number = 0;
  std::array<double, 6> wall_force = {}; ///< see TimeStepper::Result
};


/// Blast record of an earlier stage at a position [m]; empty where that stage
/// has none.
template <int dim>
using KnownRecord =
  std::function<std::optional<BlastRecord<double>>(const dealii::Point<dim> &)>;


/**
 * Interface of the objects that observe the gas after each time step and keep a
 * record of it. A derived class overrides the functions that it needs, declares
 * its entries of the parameter file by a static function declare_parameters(),
 * and is listed in Recorders. All recorders exist in every run: one that is
 * off returns at once. All functions except load() and save() are collective.
 * The first rank of MPI_COMM_WORLD writes files: in 1-D each rank has all of
 * the mesh, and a communicator of its own.
 */
template <int dim>
class Recorder
{
public:
  virtual ~Recorder() = default;

  static void declare_parameters(dealii::ParameterHandler & /*prm*/)
  {}
  /// @throws InputError for entries that the scene does not allow.
  virtual void parse_parameters(dealii::ParameterHandler &prm,
                                const GasScene<dim> &scene) = 0;

  /// Sets the output folder of the run, for files that grow or that finish()
  /// writes; LoadGauges shows how a table continues after a checkpoint. Not
  /// called for a first stage, which has none.
  virtual void set_output_folder(const std::string & /*folder*/)
  {}

  /// Updates references to leaves. Called before begin(), after load(), and
  /// after each change of the mesh, when leaves may be on other ranks than
  /// before: first combine the records that only the owner of a leaf kept.
  virtual void mesh_changed(const GasSnapshot<dim> & /*gas*/)
  {}

  /// Records the initial state.
  virtual void begin(const GasSnapshot<dim> & /*gas*/)
  {}

  /// Continues the records of a first stage. Called after begin().
  virtual void inherit(const KnownRecord<dim> & /*record*/,
                       const GasSnapshot<dim> & /*gas*/)
  {}

  /// Records the state at the end of a time step.
  virtual void add_step(const GasSnapshot<dim> & /*gas*/)
  {}

  /// Writes results at each output of fields into @p folder, fields/ in the
  /// output folder.
  virtual void write(const GasSnapshot<dim> & /*gas*/,
                     const std::string & /*folder*/)
  {}

  /// Combines the records of all ranks, so that each rank has all of them, and
  /// appends buffered samples to the result files. Called before save().
  virtual void reduce_over_ranks()
  {}

  /// Writes the record to a checkpoint: numbers to @p stream, copies of large
  /// files to @p folder. Called by the first rank only.
  virtual void save(std::ostream & /*stream*/,
                    const std::string & /*folder*/) const
  {}
  /// Reads what save() wrote. Called by every rank.
  virtual void load(std::istream & /*stream*/, const std::string & /*folder*/)
  {}

  /// Completes the record at the end of the run; not called in trial runs.
  virtual void finish()
  {}

  /// See Simulation::gaps(), at the end @p time [s] of the record. Called after
  /// reduce_over_ranks().
  virtual std::vector<std::string> gaps(const double /*time*/) const
  {
    return {};
  }

  /// Values for "results" in summary.json.
  virtual std::vector<NamedValue> results(const GasSnapshot<dim> &) const
  {
    return {};
  }
  /// Values for "checks" in summary.json.
  virtual std::vector<NamedValue> checks(const GasSnapshot<dim> &) const
  {
    return {};
  }
  /// Differences from the reference solution, for "errors" in summary.json.
  virtual std::vector<NamedValue> errors(const GasSnapshot<dim> &) const
  {
    return {};
  }
  /// Lines for the log at the end of the run.
  virtual std::vector<std::string> report(const GasSnapshot<dim> &) const
  {
    return {};
  }
};
} // namespace contrecoup::gas
