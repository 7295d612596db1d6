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
/// The gas at the end of a step, as recorders see it.
template <int dim>
struct GasSnapshot
{
  const GasScene<dim> &scene;
  const LeafMesh<dim> &mesh;
  const GasField &field;
  const CutLeaves<dim> &cut_leaves; ///< only where the scene has a body
  const QuietLeaves<dim> &quiet_leaves;
  double time = 0.; ///< [s]
  double step = 0.; ///< [s]
  std::uint64_t step_number = 0;
  std::array<double, 6> wall_force = {}; ///< see TimeStepper::Result
};


/// What is known of the blast at a place, if anything is.
template <int dim>
using KnownRecord =
  std::function<std::optional<BlastRecord<double>>(const dealii::Point<dim> &)>;


/**
 * Something that is measured as a run goes. A new recorder overrides what it
 * needs, and is named once, in RecorderList; its entries of the parameter file
 * are declared by a static function declare_parameters(). Every function is
 * collective but load() and save().
 */
template <int dim>
class Recorder
{
public:
  virtual ~Recorder() = default;

  static void declare_parameters(dealii::ParameterHandler & /*prm*/)
  {}
  /// @throws InputError for entries that do not go with the scene.
  virtual void parse_parameters(dealii::ParameterHandler &prm,
                                const GasScene<dim> &scene) = 0;

  /// Says where files of results go. Trial runs have no such folder.
  virtual void set_output_folder(const std::string & /*folder*/)
  {}

  /// Finds leaves again: called before begin(), after load(), and whenever the
  /// mesh changed.
  virtual void mesh_changed(const GasSnapshot<dim> & /*gas*/)
  {}

  /// Takes the initial state.
  virtual void begin(const GasSnapshot<dim> & /*gas*/)
  {}

  /// Goes on from what a first stage knows, after begin().
  virtual void inherit(const KnownRecord<dim> & /*record*/,
                       const GasSnapshot<dim> & /*gas*/)
  {}

  /// Takes the state at the end of a step.
  virtual void add_step(const GasSnapshot<dim> & /*gas*/)
  {}

  /// Writes results that accompany the output of fields.
  virtual void write(const GasSnapshot<dim> & /*gas*/,
                     const std::string & /*folder*/)
  {}

  /// Gives every rank all that is known, and brings files up to date; called
  /// before save().
  virtual void reduce_over_ranks()
  {}

  /// Writes what is known into a checkpoint: into @p stream, and large files
  /// into @p folder. By the first rank.
  virtual void save(std::ostream & /*stream*/,
                    const std::string & /*folder*/) const
  {}
  /// Reads what save() wrote. By every rank.
  virtual void load(std::istream & /*stream*/, const std::string & /*folder*/)
  {}

  /// Ends the record, at the end of the run.
  virtual void finish()
  {}

  /// Numbers for the summary.
  virtual std::vector<NamedValue> measures(const GasSnapshot<dim> &) const
  {
    return {};
  }
  /// Differences from the reference solution, for the summary.
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
