// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/application/run.h>
#include <contrecoup/io/application/run_entries.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    using dealii::ParameterHandler;

    std::string text_on_request(const CommandLine &command,
                                const ApplicationDescription &description)
    {
      return requested_text(
        command,
        description.name,
        description.purpose,
        "Runs on several cores with mpirun -np N " + description.name +
          " FILE.prm ...",
        [&](ParameterHandler &prm) { declare_entries(description, prm); });
    }

    /// Creates the solver and runs it, or describes the run.
    void run_solver(const CommandLine &command,
                    ParameterHandler &prm,
                    const ApplicationDescription &description,
                    Collective &collective)
    {
      std::unique_ptr<Simulation> simulation;
      collective.run(
        [&]() {
          simulation = description.create(prm, collective.communicator());
        },
        ExitCode::bad_input);
      Run run(command, description, prm, *simulation, collective);
      if (!command.check)
        run.execute();
      else
      {
        run.check();
        SignalGuard::require_no_stop();
      }
    }

    void execute(const std::vector<std::string> &arguments,
                 const ApplicationDescription &description,
                 Collective &collective)
    {
      CommandLine command;
      ParameterHandler prm;
      std::string text;
      collective.run(
        [&]() {
          std::vector<const char *> argv;
          for (const std::string &word : arguments)
            argv.push_back(word.c_str());
          command = parse_command_line(
            static_cast<int>(argv.size()), argv.data(), description.name);
          text = text_on_request(command, description);
          if (!text.empty())
            return;
          declare_entries(description, prm);
          read_parameters(command, prm);
        },
        ExitCode::bad_input);
      if (text.empty())
        run_solver(command, prm, description, collective);
      else
        collective.run([&]() {
          if (dealii::Utilities::MPI::this_mpi_process(
                collective.communicator()) == 0)
            print_requested(text);
        });
    }

    /// Runs @p work on all ranks with a log of its own, and returns its
    /// failure.
    Failure attempt(const std::function<void(Collective &)> &work)
    {
      Failure failure;
      {
        // The outer Collective terminates what the inner one cannot agree on.
        Collective outer(MPI_COMM_WORLD);
        Collective inner(MPI_COMM_WORLD);
        try
        {
          outer.run([&]() {
            Log::instance().close();
            Log::instance().set_active(
              dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
            Timers::instance().reset();
            work(inner);
          });
        }
        catch (...)
        {
          failure =
            to_failure(std::current_exception(), ExitCode::system_failed);
        }
      }
      Log::instance().close();
      return failure;
    }
  } // namespace

  void declare_entries(const ApplicationDescription &description,
                       dealii::ParameterHandler &prm)
  {
    TimeParameters::declare_parameters(prm);
    description.declare_parameters(prm);
  }

  Failure run_within(const std::vector<std::string> &arguments,
                     const ApplicationDescription &description)
  {
    return attempt([&](Collective &collective) {
      execute(arguments, description, collective);
    });
  }

  Failure run_entries(CommandLine command,
                      dealii::ParameterHandler &prm,
                      const ApplicationDescription &description)
  {
    // The run leaves its entries there.
    if (command.parameter_file.empty())
      command.parameter_file = command.output_folder + "/parameters.prm";
    return attempt([&](Collective &collective) {
      run_solver(command, prm, description, collective);
    });
  }

  int run_with_mpi(
    int argc,
    char **argv,
    const std::function<Failure(const std::vector<std::string> &)> &work)
  {
    dealii::deal_II_exceptions::disable_abort_on_exception();
    dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();

    const SignalGuard before_mpi;
    const std::vector<std::string> arguments(argv, argv + argc);
    // Without mpirun, a singleton needs no daemon; only processes that spawn
    // further ranks do.
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    // Open MPI 5 does not start without a home folder; nothing is kept in one
    // that is none.
    const bool has_home = std::getenv("HOME") != nullptr;
    setenv("HOME", "/", 0);
    int initialised = 0;
    MPI_Initialized(&initialised);
    std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
    // PETSc, where deal.II has it, warns of options that are not its own.
    argc = std::min(argc, 1);
    if (initialised == 0)
      mpi = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(
        argc, argv, 1);
    if (!has_home)
      unsetenv("HOME");
    const bool is_first =
      dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
    if (const int signal = dealii::Utilities::MPI::max(
          SignalGuard::stop_signal(), MPI_COMM_WORLD))
    {
      const Stopped stop(signal);
      if (is_first)
        std::cout << stop.what() << " before the start" << std::endl;
      return static_cast<int>(
        to_failure(std::make_exception_ptr(stop), ExitCode::system_failed)
          .code);
    }
    // MPI takes SIGTERM back.
    const SignalGuard signals;
    return run_each(arguments, work, is_first);
  }

  int run_application(int argc,
                      char **argv,
                      const ApplicationDescription &description)
  {
    return run_with_mpi(
      argc, argv, [&](const std::vector<std::string> &arguments) {
        return run_within(arguments, description);
      });
  }
} // namespace io
} // namespace contrecoup
