// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/temporary_folder.h>
#include <contrecoup/study/application_under_study.h>

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>

namespace contrecoup::study
{
namespace
{
  namespace fs = std::filesystem;

  bool is_program(const fs::path &file)
  {
    return fs::is_regular_file(file) && access(file.c_str(), X_OK) == 0;
  }

  /// Path of a program in the folder of this program.
  std::string find_program(const std::string &name)
  {
    if (name.find('/') != std::string::npos)
    {
      if (!is_program(name))
        throw InputError("Study/Application: \"" + name +
                         "\" is not a program");
      return name;
    }
    const fs::path own = fs::read_symlink("/proc/self/exe");
    if (!name.empty() && is_program(own.parent_path() / name))
      return (own.parent_path() / name).string();
    std::vector<std::string> known;
    for (const auto &entry : fs::directory_iterator(own.parent_path()))
      if (is_program(entry.path()) && entry.path() != own)
        known.push_back(entry.path().filename().string());
    throw InputError("Study/Application: there is no application \"" + name +
                     "\" in \"" + own.parent_path().string() + "\"" +
                     suggestion(name, known));
  }

  /// Units of the entries in a text of --print-parameters, where the comment
  /// before an entry begins with its unit, "# [kg] Mass ...".
  std::map<std::string, std::string> units_in(const std::string &text)
  {
    std::map<std::string, std::string> units;
    std::vector<std::string> sections;
    std::string unit;
    for (const std::string &line : split(text, '\n'))
      if (line.compare(0, 3, "# [") == 0)
        unit = line.substr(3, line.find(']') - 3);
      else if (line.compare(0, 11, "subsection ") == 0)
        sections.push_back(trim(line.substr(11)));
      else if (line == "end" && !sections.empty())
        sections.pop_back();
      else if (line.compare(0, 4, "set ") == 0)
      {
        std::vector<std::string> path = sections;
        path.push_back(trim(line.substr(4, line.find('=') - 4)));
        if (!unit.empty() && unit != "-")
          units[join(path, "/")] = unit;
        unit.clear();
      }
      else if (line.compare(0, 1, "#") != 0)
        unit.clear();
    return units;
  }
} // namespace

std::string fingerprint(const std::string &text)
{
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char letter : text)
    hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211ULL;
  char digits[17];
  std::snprintf(
    digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

ApplicationUnderStudy::ApplicationUnderStudy(const std::string &name,
                                             const std::string &parameter_file,
                                             const unsigned int ranks)
  : name_(fs::path(name).filename().string())
  , program_(find_program(name))
  , parameter_file_(parameter_file)
  , ranks_(ranks)
{}

std::string ApplicationUnderStudy::refusal(const ProcessText &text) const
{
  if (text.end.signal != 0)
    throw SystemError(name_ + " was ended by signal " +
                      std::to_string(text.end.signal));
  if (text.end.exit_code == static_cast<int>(ExitCode::system_failed))
    throw SystemError(name_ + ": " + text.errors);
  // Remove "--set: ", which the user of a study did not write.
  const std::string origin = "--set: ";
  const bool of_override = text.errors.compare(0, origin.size(), origin) == 0;
  return name_ + ": " + text.errors.substr(of_override ? origin.size() : 0);
}

EntryList ApplicationUnderStudy::entries(const Settings &settings) const
{
  std::vector<std::string> words = {program_, parameter_file_};
  for (const auto &[entry, value] : settings)
    words.insert(words.end(), {"--set", entry + "=" + value});
  words.emplace_back("--print-parameters");
  const io::TemporaryFolder folder;
  const ProcessText text = run_process(words, folder.path());
  if (text.end.exit_code != 0 || text.end.signal != 0)
    throw InputError(refusal(text));
  const std::string file = folder.path() + "/parameters.prm";
  io::write_file(file, [&](std::ostream &out) { out << text.output; });
  EntryList list;
  list.units = units_in(text.output);
  for (const Assignment &assignment : read_assignments(file))
  {
    const std::string path = join(assignment.sections, "/") + "/";
    // Skip pattern subsections, which are no actual entries.
    if (path.find(" */") == std::string::npos)
      list.values[(path == "/" ? "" : path) + assignment.entry] =
        assignment.value;
  }
  return list;
}

std::vector<std::string>
ApplicationUnderStudy::command(const Settings &settings,
                               const std::string &output_folder) const
{
  std::vector<std::string> words;
  if (ranks_ > 1)
    words = {"mpirun", "-np", std::to_string(ranks_)};
  words.insert(words.end(), {program_, parameter_file_});
  for (const auto &[entry, value] : settings)
    words.insert(words.end(), {"--set", entry + "=" + value});
  words.insert(words.end(), {"--output", output_folder});
  return words;
}

const std::string &ApplicationUnderStudy::name() const
{
  return name_;
}

std::string ApplicationUnderStudy::version() const
{
  const io::TemporaryFolder folder;
  const ProcessText text = run_process({program_, "--version"}, folder.path());
  if (text.end.exit_code != 0 || text.end.signal != 0)
    throw InputError("Study/Application: \"" + program_ +
                     " --version\" failed: " + text.errors);
  return one_line(text.output) + " " + fingerprint(io::read_file(program_));
}

unsigned int ApplicationUnderStudy::ranks() const
{
  return ranks_;
}
} // namespace contrecoup::study
