// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/scene/scene_application.h>
#include <contrecoup/coupling/scene/scene_run.h>
#include <contrecoup/io/run/command_line.h>

namespace contrecoup::coupling
{
namespace
{
  void print_estimate(const io::CommandLine &command,
                      dealii::ParameterHandler &prm,
                      Collective &collective)
  {
    collective.run(
      [&]() {
        const PlannedScene scene(prm, io::assignments_of(command, prm));
        for (const std::string &line : scene.first_answer())
          show_line(line);
      },
      ExitCode::bad_input);
  }


  void execute(const std::vector<std::string> &arguments,
               Collective &collective)
  {
    const bool is_first_rank =
      dealii::Utilities::MPI::this_mpi_process(collective.communicator()) == 0;
    Log::instance().close();
    Log::instance().set_active(is_first_rank);
    io::CommandLine command;
    dealii::ParameterHandler prm;
    std::string text;
    collective.run(
      [&]() {
        std::vector<const char *> words;
        for (const std::string &word : arguments)
          words.push_back(word.c_str());
        command = io::parse_command_line(
          static_cast<int>(words.size()), words.data(), "scene");
        text = io::requested_text(
          command,
          "scene",
          "Follows a blast from the charge to the injuries of a body, in "
          "stages that are kept, and reports on it.",
          "Runs on several cores with mpirun -np N scene FILE.prm ...",
          SceneParameters::declare_parameters);
        if (!text.empty())
          return;
        SceneParameters::declare_parameters(prm);
        io::read_parameters(command, prm);
      },
      ExitCode::bad_input);
    if (!text.empty())
    {
      collective.run([&]() {
        if (is_first_rank)
          io::print_requested(text);
      });
      return;
    }
    if (command.estimate)
    {
      print_estimate(command, prm, collective);
      return;
    }
    SceneRun run(command, prm, collective);
    if (command.check)
      run.check();
    else
      run.execute();
  }
} // namespace


Failure run_scene(const std::vector<std::string> &arguments)
{
  Failure failure;
  {
    // The outer Collective ends errors on which the inner one could not agree.
    Collective outer(MPI_COMM_WORLD);
    Collective inner(MPI_COMM_WORLD);
    try
    {
      outer.run([&]() { execute(arguments, inner); });
    }
    catch (...)
    {
      failure = to_failure(std::current_exception(), ExitCode::system_failed);
    }
  }
  Log::instance().close();
  return failure;
}
} // namespace contrecoup::coupling
