// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/application/run.h>
#include <contrecoup/io/run/command_line.h>

#include <deal.II/base/exceptions.h>

#include <cstdlib>

namespace contrecoup
{
namespace io
{
  namespace
  {
    using dealii::ParameterHandler;

    void declare(const ApplicationDescription &description,
                 ParameterHandler &prm)
    {
      TimeParameters::declare_parameters(prm);
      description.declare_parameters(prm);
    }

    std::string text_on_request(const CommandLine &command,
                                const ApplicationDescription &description)
    {
      return requested_text(
        command,
        description.name,
        description.purpose,
        "Runs on several cores with mpirun -np N " + description.name +
          " FILE.prm ...",
        [&](ParameterHandler &prm) { declare(description, prm); });
    }

    void execute(const int argc,
                 char **argv,
                 const ApplicationDescription &description,
                 Collective &collective)
    {
      const MPI_Comm all = collective.communicator();
      const bool first_rank =
        dealii::Utilities::MPI::this_mpi_process(all) == 0;
      Log::instance().close();
      Log::instance().set_active(first_rank);
      Timers::instance().reset();

      CommandLine command;
      ParameterHandler prm;
      std::unique_ptr<Simulation> simulation;
      std::string text;
      collective.run(
        [&]() {
          command = parse_command_line(argc, argv, description.name);
          text = text_on_request(command, description);
          if (!text.empty())
            return;
          declare(description, prm);
          read_parameters(command, prm);
        },
        ExitCode::bad_input);
      if (!text.empty())
      {
        collective.run([&]() {
          if (first_rank)
            print_requested(text);
        });
        return;
      }
      collective.run([&]() { simulation = description.create(prm, all); },
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
  } // namespace

  Failure run_within(const std::vector<std::string> &arguments,
                     const ApplicationDescription &description)
  {
    std::vector<std::string> words = arguments;
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    const int argc = static_cast<int>(argv.size());
    Failure failure;
    {
      // The outer Collective terminates what the inner one cannot agree on.
      Collective outer(MPI_COMM_WORLD);
      Collective inner(MPI_COMM_WORLD);
      try
      {
        outer.run([&]() { execute(argc, argv.data(), description, inner); });
      }
      catch (...)
      {
        failure = to_failure(std::current_exception(), ExitCode::system_failed);
      }
    }
    Log::instance().close();
    return failure;
  }

  int run_with_mpi(
    int argc,
    char **argv,
    const std::function<Failure(const std::vector<std::string> &)> &work)
  {
    dealii::deal_II_exceptions::disable_abort_on_exception();
    dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();

    const std::vector<std::string> arguments(argv, argv + argc);
    // Without mpirun, a singleton needs no daemon; only processes that spawn
    // further ranks do.
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    int initialised = 0;
    MPI_Initialized(&initialised);
    std::unique_ptr<dealii::Utilities::MPI::MPI_InitFinalize> mpi;
    if (initialised == 0)
      mpi = std::make_unique<dealii::Utilities::MPI::MPI_InitFinalize>(
        argc, argv, 1);
    const SignalGuard signals;
    return run_each(arguments,
                    work,
                    dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) ==
                      0);
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
