// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/base/system/collective.h>
#include <contrecoup/io/output/manifest.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Description of an application, given by its main().
  struct ApplicationDescription
  {
    std::string name;
    std::string purpose; ///< one sentence

    /// Declares the entries of the solver. "Time" and "Output" exist already.
    std::function<void(dealii::ParameterHandler &)> declare_parameters;

    /// Parses the entries and creates the solver, without large allocations.
    /// Throws InputError for an invalid scene.
    std::function<std::unique_ptr<Simulation>(dealii::ParameterHandler &,
                                              MPI_Comm)>
      create;

    /// Entries that may differ on --resume in addition to those of the run
    /// loop: "Section/Entry", or "Section/" for a whole subsection.
    std::vector<std::string> free_on_resume = {};

    /// Changes the entries so that cells are 2^levels times as large, for
    /// trial runs; returns false if impossible. Empty: no trial runs.
    std::function<bool(dealii::ParameterHandler &, unsigned int levels)>
      coarsen = {};

    /// Script that draws a finished run, see draw(), if the solver's entry
    /// "Output/Pictures" asks for it. Empty: none.
    std::string pictures = {};

    /// Files that the solver writes into the output folder for these entries,
    /// in addition to checkpoints and the files of every run. Empty: none.
    std::function<FileNames(const dealii::ParameterHandler &)> files = {};

    /// Receives the cost estimate of --check instead of the terminal, for
    /// applications that run this one as a part. Empty: not used.
    std::function<void(const CostEstimate &)> on_cost_estimate = {};

    /// Part of the usual processor time that --check may spend on trial runs;
    /// 0: none, the estimate of the solver counts.
    double trial_share = 1.;

    /// Whether all steps are like the first one, unless the body deforms.
    bool keeps_first_step = false;

    /// Whether the body strikes something, which coarse trials do not show as
    /// it is. Empty: never.
    std::function<bool(const dealii::ParameterHandler &)> strikes = {};

    /// Whether the mesh changes during the run. Empty: never.
    std::function<bool(const dealii::ParameterHandler &)> adapts = {};

    /// Lines about choices that a run would take without complaint, as
    /// warnings; not asked for in parts of another application. Empty: none.
    std::function<std::vector<std::string>(dealii::ParameterHandler &)>
      oversights = {};

    /// Numbers in the tables of a run with these entries: "FILE.csv:ROW:COLUMN"
    /// with "*" for any letters. Empty: any in the tables among `files`.
    std::function<std::vector<std::string>(dealii::ParameterHandler &)> tables =
      {};
  };

  /**
   * Runs an application: command line, parameters, run loop, output folder,
   * errors. Initialises MPI if necessary. Returns the exit code; writes one
   * line to stderr unless it is 0.
   */
  int run_application(int argc,
                      char **argv,
                      const ApplicationDescription &description);

  /**
   * As run_application() within a program that has initialised MPI; returns
   * the failure instead of printing it. Collective.
   * @param arguments as passed to main(), program name first
   */
  Failure run_within(const std::vector<std::string> &arguments,
                     const ApplicationDescription &description);

  /// Initialises MPI if necessary and runs @p work for the command line on all
  /// ranks, see run_each().
  int run_with_mpi(
    int argc,
    char **argv,
    const std::function<Failure(const std::vector<std::string> &)> &work);
} // namespace io
} // namespace contrecoup
