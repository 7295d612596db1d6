// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/scene_files.h>

#include <map>

namespace contrecoup::coupling
{
namespace
{
  std::string path_of(const Assignment &assignment)
  {
    return join(assignment.sections, "/") + "/" + assignment.entry;
  }
} // namespace


std::string scene_text(const dealii::ParameterHandler &prm,
                       const std::vector<Assignment> &wrote)
{
  dealii::ParameterHandler own;
  SceneParameters::declare_own(own);
  std::vector<Assignment> values;
  for (const Assignment &assignment : assignments_of(prm))
    if (!SceneParameters::is_of_stage(assignment))
      values.push_back(assignment);
  apply_assignments(values, own);
  std::string text = parameter_text(own, false);
  const std::map<std::string, std::string> all = parameter_values(prm);
  for (const Assignment &assignment : wrote)
    if (SceneParameters::is_of_stage(assignment))
    {
      std::string end;
      for (const std::string &section : assignment.sections)
      {
        text += "\nsubsection " + section;
        end += "\nend";
      }
      // With the absolute names of files.
      text += "\nset " + assignment.entry + " = " +
              all.at(path_of(assignment)) + end + "\n";
    }
  return text;
}


TaskText
task_text(const std::string &name,
          const std::vector<Assignment> &entries,
          const dealii::ParameterHandler &scene,
          const std::vector<Assignment> &wrote,
          const std::function<void(dealii::ParameterHandler &)> &declare,
          const EntryChanges &changes,
          const std::vector<Assignment> &given)
{
  std::vector<Assignment> all = entries;
  for (Assignment &assignment : all)
    assignment.origin = name;
  for (const Assignment &assignment : assignments_of(scene))
    if (!assignment.sections.empty() && assignment.sections[0] == "Body")
      all.push_back(assignment);
  std::vector<Assignment> of_user;
  for (Assignment assignment : wrote)
    if (!assignment.sections.empty() && assignment.sections[0] == name)
    {
      assignment.sections.erase(assignment.sections.begin());
      // The report reads the scene's probes: those of the user follow them.
      if (path_of(assignment) == "Probes/Points")
        for (const Assignment &own : entries)
          if (path_of(own) == path_of(assignment) && !own.value.empty())
            assignment.value = own.value + "; " + assignment.value;
      of_user.push_back(assignment);
    }
  all.insert(all.end(), of_user.begin(), of_user.end());
  // Sections that the scene describes by a section of its own.
  const std::map<std::string, std::string> sections = {{"Charges", "Charge"},
                                                       {"Rigid body", "Body"}};
  dealii::ParameterHandler prm;
  declare(prm);
  const SceneWords words(name, entries, sections, wrote, prm);
  try
  {
    apply_assignments(all, prm);
    if (changes)
      apply_assignments(changes(prm), prm);
  }
  catch (const InputError &error)
  {
    throw InputError(words(error.what()));
  }
  TaskText result{parameter_text(prm, false),
                  words,
                  assignments_of(prm),
                  parameter_values(prm),
                  {}};
  apply_assignments(given, prm);
  for (const std::string &line : find_unused(prm, of_user))
    result.unused.push_back(words(line));
  return result;
}
} // namespace contrecoup::coupling
