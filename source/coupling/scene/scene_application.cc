// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/scene/scene_application.h>
#include <contrecoup/coupling/scene/scene_parameters.h>
#include <contrecoup/coupling/scene/scene_run.h>
#include <contrecoup/coupling/scene/scene_tasks.h>
#include <contrecoup/io/run/command_line.h>

#include <algorithm>
#include <sstream>

namespace contrecoup::coupling
{
namespace
{
  /// A text of --print-parameters whose entries of stages are comments where
  /// they stand at their default: as a file it would replace the choices of
  /// the scene by the defaults of the stages.
  std::string comment_stage_defaults(const std::string &text)
  {
    std::istringstream lines(text);
    std::string result;
    unsigned int depth = 0;
    bool is_of_stage = false, differs = false;
    for (std::string line; std::getline(lines, line);)
    {
      const std::size_t start =
        std::min(line.find_first_not_of(' '), line.size());
      const std::string words = line.substr(start);
      if (words.compare(0, 11, "subsection ") == 0)
      {
        if (depth++ == 0)
          is_of_stage = SceneParameters::is_stage(words.substr(11));
        if (depth == 1 && is_of_stage)
          result += "# The scene chooses what is not written here.\n";
      }
      else if (words == "end")
        --depth;
      else if (words.compare(0, 1, "#") == 0)
        differs = differs || words.find("Default: ") != std::string::npos;
      else if (words.compare(0, 4, "set ") == 0)
      {
        if (depth > 0 && is_of_stage && !differs)
          line.insert(start, "# ");
        differs = false;
      }
      result += line + "\n";
    }
    return result;
  }


  void print_estimate(const io::CommandLine &command,
                      dealii::ParameterHandler &prm,
                      Collective &collective)
  {
    collective.run(
      [&]() {
        const PlannedScene scene(prm, io::assignments_of(command, prm));
        // A scene that a run refuses gets no answer.
        make_tasks(scene, command, prm, collective);
        for (const std::string &line : scene.first_answer())
          show_line(line);
        warn_of_entries(scene, command, prm, collective);
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
        if (command.print_parameters && command.form == ParameterForm::text)
          text = comment_stage_defaults(text);
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
