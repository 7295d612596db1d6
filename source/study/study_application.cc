// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/study/study.h>
#include <contrecoup/study/study_application.h>

#include <filesystem>

namespace contrecoup::study
{
namespace
{
  void execute(const io::CommandLine &command, dealii::ParameterHandler &prm)
  {
    io::warn_of_unused(command, prm);
    StudyParameters parameters;
    parameters.parse_parameters(prm);
    if (parameters.title.empty())
      parameters.title =
        std::filesystem::path(command.parameter_file).stem().string();
    Study study(parameters, command.output_folder);
    if (command.check)
      study.check();
    else
      study.execute(command,
                    "# study " + version() + " (" + git_revision() +
                      "): every entry as used\n\n" + parameter_text(prm, false),
                    parameter_values(prm));
  }
} // namespace

io::ToolDescription study_application()
{
  return {"study",
          "Measures what accuracy costs: runs variants of a parameter file "
          "of another application, and compares their errors and costs.",
          StudyParameters::declare_parameters,
          execute};
}
} // namespace contrecoup::study
