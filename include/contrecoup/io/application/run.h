// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/run_loop.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/output/output_folder.h>
#include <contrecoup/io/run/command_line.h>

#include <chrono>
#include <string>

namespace contrecoup
{
namespace io
{
  /// Runs a solver in its output folder: cost check, setup or restart, run
  /// loop, summary. Every function is collective.
  class Run
  {
  public:
    Run(const CommandLine &command,
        const ApplicationDescription &description,
        dealii::ParameterHandler &prm,
        Simulation &simulation,
        Collective &collective);

    /// Prints the plan and the cost of the run; writes nothing.
    /// @throws InputError when the mesh does not fit into memory
    void check();

    /// Executes the run. @throws InputError, NumericsError, SystemError
    void execute();

  private:
    CostEstimate estimate();
    unsigned int n_ranks() const;
    void write_check(const CostEstimate &cost);
    /// Gives the plan what only an initial state tells, that of a coarse mesh.
    void complete_plan();
    /// Shows which entries have no effect, and other oversights.
    void warn();
    void prepare();
    /// Warns of results that a longer run may have.
    void warn_of_gaps(bool is_finished);
    /// Warns where more than a few steps were halved.
    void warn_of_retries() const;
    void summarise(const std::string &status, const std::string &message);
    /// Returns false on the first rank if they could not be drawn.
    bool draw_pictures() const;

    const CommandLine &command_;
    const ApplicationDescription &description_;
    dealii::ParameterHandler &prm_;
    std::string parameter_text_;
    TimeParameters time_;
    Simulation &simulation_;
    Collective &collective_;
    OutputFolder folder_;
    RunState state_;
    std::vector<Assumption> plan_;

    std::chrono::steady_clock::time_point begin_ =
      std::chrono::steady_clock::now();
  };
} // namespace io
} // namespace contrecoup
