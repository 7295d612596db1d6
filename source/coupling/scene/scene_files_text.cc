// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/scene_files.h>

#include <map>
#include <set>
#include <sstream>

namespace contrecoup::coupling
{
namespace
{
  std::string path_of(const Assignment &assignment)
  {
    return join(assignment.sections, "/") + "/" + assignment.entry;
  }

  /// The numbers of a list; empty if it holds anything else.
  std::vector<double> numbers_in(const std::string &text)
  {
    std::vector<double> numbers;
    for (const std::string &word : split(text, ','))
    {
      std::istringstream input(word);
      double number = 0.;
      if (!(input >> number) || !input.eof())
        return {};
      numbers.push_back(number);
    }
    return numbers;
  }

  bool is_same(const std::string &a, const std::string &b)
  {
    const std::vector<double> numbers = numbers_in(a);
    return a == b || (!numbers.empty() && numbers == numbers_in(b));
  }

  /// Entry of the scene alone that may determine an entry of a stage, because
  /// the scene's plan and report state it; empty: there is none.
  std::string owner_of(const std::string &path,
                       const std::vector<Assignment> &entries)
  {
    if (begins_with(path, "Body/") || begins_with(path, "Tissues/Tissue "))
      return path;
    const std::string tissues = "Materials/Tissue ";
    if (begins_with(path, tissues))
      return "Tissues/Tissue " + path.substr(tissues.size());
    for (const Assignment &entry : entries)
      for (const char *const own : {"Charge/", "Body", "Tissues/"})
        if (path_of(entry) == path && begins_with(entry.origin, own))
          return entry.origin;
    return path == "Mesh/Element size"   ? "Scene/Element size"
           : path == "Rigid body/Levels" ? "Scene/Cell size"
           : path == "Method/Subcells"   ? "Scene/Cell size"
                                         : "";
  }

  /// @throws InputError for an entry of the blast with which neither plan nor
  /// tables nor verdicts of a scene are right
  void require_of_scene(const std::string &stage,
                        const std::string &path,
                        const Assignment &assignment)
  {
    const bool is_state = begins_with(path, "Initial state/");
    if (is_state || (begins_with(path, "Charges/Charge ") &&
                     !begins_with(path, "Charges/Charge 1/")))
      throw InputError(
        assignment.origin + ": " + stage + "/" + path +
        ": plan, tables and verdicts of a scene hold for " +
        (is_state ? "air at rest at sea level" : "its one charge") +
        "; blast takes it with blast/parameters.prm of a finished scene's "
        "output folder and First stage/Kind = none (of a scene with "
        "Scene/Symmetry = none, if it differs between both sides of y = 0), "
        "and biomechanics the loads.h5 of that run with "
        "biomechanics/parameters.prm and Loads/Recorded/File");
  }

  /// Whether the scene takes the user's value for its own, see OwnGrid.
  bool takes_from_user(const std::string &stage, const std::string &path)
  {
    return stage == "Blast" &&
           (path == "Domain/Lower corner" || path == "Domain/Upper corner" ||
            path == "Domain/Coarse leaves");
  }

  /// Entries of the user with another value than @p before, in a subsection
  /// that the user adds, such as a support, or that the scene takes.
  /// @throws InputError for those that the scene alone may determine
  std::vector<ChangedEntry>
  find_changes(const std::string &stage,
               const std::vector<Assignment> &of_user,
               const std::vector<Assignment> &entries,
               const std::map<std::string, std::string> &before,
               const std::map<std::string, std::string> &after)
  {
    std::vector<ChangedEntry> changes;
    std::set<std::string> listed;
    for (const Assignment &assignment : of_user)
    {
      const std::string path = path_of(assignment);
      const auto old = before.find(path), now = after.find(path);
      const bool is_added = old == before.end();
      const bool is_kept =
        now != after.end() && !is_added && is_same(old->second, now->second);
      if (now == after.end() || (is_kept && !takes_from_user(stage, path)))
        continue;
      require_of_scene(stage, path, assignment);
      const std::string otherwise = is_kept    ? "chosen by the scene"
                                    : is_added ? "not set"
                                    : old->second.empty() ? "empty"
                                                          : old->second;
      if (const std::string owner = owner_of(path, entries); !owner.empty())
        throw InputError(
          assignment.origin + ": " + stage + "/" + path + " = " + now->second +
          " contradicts " + owner + " of the scene, which " +
          (is_added || old->second.empty() ? "does not set it"
                                           : "makes it " + otherwise) +
          "; set " + owner);
      const std::string &section = assignment.sections[0];
      if (section != "Output" && section != "Pictures" && section != "Probes" &&
          listed.insert(path).second)
        changes.push_back({stage + "/" + path, now->second, otherwise, true});
    }
    return changes;
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
  // Sections that the scene describes by a section of its own.
  const std::map<std::string, std::string> sections = {{"Charges", "Charge"},
                                                       {"Rigid body", "Body"}};
  dealii::ParameterHandler prm;
  declare(prm);
  const SceneWords words(name, entries, sections, wrote, prm);
  std::map<std::string, std::string> before;
  try
  {
    apply_assignments(all, prm);
    before = parameter_values(prm);
    apply_assignments(of_user, prm);
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
                  {},
                  {}};
  apply_assignments(given, prm);
  for (const std::string &line : find_unused(prm, of_user))
    result.unused.push_back(words(line));
  if (!changes)
    result.changes =
      find_changes(name, of_user, entries, before, result.values);
  return result;
}
} // namespace contrecoup::coupling
