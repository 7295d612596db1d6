// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/solid/body/mesh_description.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * Interface of the objects that observe a body after each time step and keep a
 * record of it. A derived class overrides the functions that it needs, declares
 * its entries by a static function declare_parameters(), and is listed in
 * SolidRecorders. All recorders exist in every run: one that is off returns at
 * once. All functions are collective.
 */
template <typename Real>
class SolidRecorder
{
public:
  virtual ~SolidRecorder() = default;

  static void declare_parameters(dealii::ParameterHandler & /*prm*/)
  {}
  /// @throws InputError for entries that contradict each other
  virtual void parse_parameters(dealii::ParameterHandler & /*prm*/,
                                const MeshDescription & /*mesh*/)
  {}

  /// Finds the selected places in the mesh. @throws InputError where an entry
  /// selects nothing
  virtual void check(const SolidMesh & /*mesh*/, MPI_Comm /*communicator*/)
  {}

  /// Prepares an empty record. @p body must outlive the recorder.
  virtual void reinit(const SolidBody<Real> &body) = 0;

  /// Records the initial state.
  virtual void begin(const SolidBody<Real> & /*body*/)
  {}

  /// Records the state at the end of a time step.
  virtual void record(const SolidBody<Real> &body) = 0;

  /// Columns of history.csv at the present.
  virtual std::vector<NamedValue>
  history(const SolidBody<Real> & /*body*/) const
  {
    return {};
  }
  /// Values for "results" in summary.json.
  virtual std::vector<NamedValue>
  results(const SolidBody<Real> & /*body*/) const
  {
    return {};
  }
  /// Differences from expected values, for "errors" in summary.json.
  virtual std::vector<NamedValue> errors() const
  {
    return {};
  }
  /// See Simulation::gaps().
  virtual std::vector<std::string> gaps() const
  {
    return {};
  }

  /// Saves this rank's part of the record to @p folder, or restores what any
  /// number of ranks saved, after reinit().
  /// @throws InputError for files of another scene
  virtual void save(const SolidBody<Real> &body,
                    const std::string &folder) const = 0;
  virtual void restore(const SolidBody<Real> &body,
                       const std::string &folder) = 0;
};
} // namespace contrecoup::solid
