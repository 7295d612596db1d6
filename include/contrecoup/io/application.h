// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/io/manifest.h>

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
  /// An application as its main() describes it.
  struct ApplicationDescription
  {
    std::string name;
    std::string purpose; ///< one sentence

    /// Declares every entry of the solver; "Time" and "Output" are there.
    std::function<void(dealii::ParameterHandler &)> declare_parameters;

    /// Parses the entries and makes the solver, which allocates nothing
    /// large yet. Throws InputError for a scene that makes no sense.
    std::function<std::unique_ptr<Simulation>(dealii::ParameterHandler &,
                                              MPI_Comm)>
      create;

    /// Entries that may differ on --resume besides those of the run loop,
    /// as "Section/Entry", or "Section/" for a whole subsection.
    std::vector<std::string> free_on_resume = {};

    /// Changes the entries so that the scene's cells are 2^levels times as
    /// large, for trial runs; returns false when they cannot be. Empty: never.
    std::function<bool(dealii::ParameterHandler &, unsigned int levels)>
      coarsen = {};

    /// Script that draws a finished run where the entry "Output/Pictures",
    /// which is then among the solver's, says so, see draw(). Empty: none.
    std::string pictures = {};

    /// The files that the solver writes into the output folder, for these
    /// entries, besides its checkpoints and what every run writes. Empty: none.
    std::function<FileNames(const dealii::ParameterHandler &)> files = {};

    /// Takes what --check finds, from whoever runs the application as a part of
    /// something larger, and says itself what that is. Empty: nobody.
    std::function<void(const CostEstimate &)> take_cost = {};
  };

  /**
   * Everything between main() and the solver: command line, parameters, run
   * loop, output folder, errors. Initialises MPI unless that was done.
   * Returns the exit code; writes one line to stderr unless it is 0.
   */
  int run_application(int argc,
                      char **argv,
                      const ApplicationDescription &description);

  /**
   * The same within a program that has started MPI: tells what went wrong
   * instead of writing it. Collective.
   * @param arguments as main() gets them, the program's name first
   */
  Failure run_within(const std::vector<std::string> &arguments,
                     const ApplicationDescription &description);

  /// Starts MPI unless that was done and does the @p work of the command line
  /// on all ranks, see run_each().
  int run_with_mpi(
    int argc,
    char **argv,
    const std::function<Failure(const std::vector<std::string> &)> &work);
} // namespace io
} // namespace contrecoup
