// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/io/application/tool.h>

#include <deal.II/base/exceptions.h>

#include <cstdlib>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Whether this is a rank above 0 of an mpirun.
    bool is_surplus_rank()
    {
      for (const char *name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK"})
        if (const char *rank = std::getenv(name))
          return std::string(rank) != "0";
      return false;
    }

    void
    execute(const int argc, char **argv, const ToolDescription &description)
    {
      const CommandLine command =
        parse_command_line(argc, argv, description.name);
      const std::string text =
        requested_text(command,
                       description.name,
                       description.purpose,
                       "Starts what it needs on several cores itself.",
                       description.declare_parameters);
      if (!text.empty())
      {
        print_requested(text);
        return;
      }
      dealii::ParameterHandler prm;
      description.declare_parameters(prm);
      read_parameters(command, prm);
      description.execute(command, prm);
    }
  } // namespace

  Failure run_within(const std::vector<std::string> &arguments,
                     const ToolDescription &description)
  {
    std::vector<std::string> words = arguments;
    std::vector<char *> argv;
    for (std::string &word : words)
      argv.push_back(word.data());
    Failure failure;
    try
    {
      execute(static_cast<int>(argv.size()), argv.data(), description);
    }
    catch (...)
    {
      failure = to_failure(std::current_exception(), ExitCode::system_failed);
    }
    Log::instance().close();
    return failure;
  }

  int run_tool(const int argc, char **argv, const ToolDescription &description)
  {
    const SignalGuard signals;
    if (is_surplus_rank())
      return 0;
    dealii::deal_II_exceptions::disable_abort_on_exception();
    dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
    return run_each(
      std::vector<std::string>(argv, argv + argc),
      [&](const std::vector<std::string> &arguments) {
        return run_within(arguments, description);
      },
      true);
  }
} // namespace io
} // namespace contrecoup
