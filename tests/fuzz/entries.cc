// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

// Every entry of shipped parameter files in turn is set to values that users
// write by mistake, and the application is asked to --check that. It must
// accept the file or refuse it in one line, and write nothing. Each number that
// is declared must have bounds on both sides. Arguments are
// those of fuzz::run(), and --all for all files of quickstart and verification
// instead of quickstarts alone. With CONTRECOUP_FUZZ_MESSAGES=FILE the lines
// of refusals are kept there, for somebody to read.

#include <contrecoup/ale/run/head_impact_application.h>
#include <contrecoup/base/parameters/declared_tree.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/coupling/application/biomechanics_application.h>
#include <contrecoup/coupling/application/blast_application.h>
#include <contrecoup/coupling/scene/scene_application.h>
#include <contrecoup/coupling/scene/scene_parameters.h>
#include <contrecoup/io/application/application.h>
#include <contrecoup/io/application/tool.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/study/study_parameters.h>

#include <deal.II/base/exceptions.h>

#include "fuzz.h"
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <random>

using namespace contrecoup;

namespace
{
namespace fs = std::filesystem;
using Change = std::pair<std::string, std::string>; ///< entry and value

constexpr std::size_t longest_message = 1000;

struct Application
{
  std::function<void(dealii::ParameterHandler &)> declare;
  std::function<Failure(const std::vector<std::string> &)> run;
};

Application of_solver(const io::ApplicationDescription &description)
{
  return {[description](dealii::ParameterHandler &prm) {
            TimeParameters::declare_parameters(prm);
            description.declare_parameters(prm);
          },
          [description](const std::vector<std::string> &arguments) {
            return io::run_within(arguments, description);
          }};
}

/// A study starts other programs, so that its entries are parsed alone.
Application of_study()
{
  const auto parse = [](const io::CommandLine &,
                        dealii::ParameterHandler &prm) {
    study::StudyParameters().parse_parameters(prm);
  };
  const io::ToolDescription tool{
    "study", "", study::StudyParameters::declare_parameters, parse};
  return {tool.declare_parameters,
          [tool](const std::vector<std::string> &arguments) {
            return io::run_within(arguments, tool);
          }};
}

const std::map<std::string, Application> &applications()
{
  const io::ToolDescription anatomy = coupling::anatomy_application();
  static const std::map<std::string, Application> all{
    {"anatomy",
     {anatomy.declare_parameters,
      [anatomy](const std::vector<std::string> &arguments) {
        return io::run_within(arguments, anatomy);
      }}},
    {"biomechanics", of_solver(coupling::biomechanics_application())},
    {"blast", of_solver(coupling::blast_application())},
    {"head_impact", of_solver(ale::head_impact_application())},
    {"scene",
     {coupling::SceneParameters::declare_parameters, coupling::run_scene}},
    {"study", of_study()}};
  return all;
}

/// Mistakes that may be written into an entry of any kind.
const std::vector<std::string> mistakes{"",
                                        "-1",
                                        "0",
                                        "1e300",
                                        "-1e300",
                                        "1e-300",
                                        "1e400",
                                        "1e9",
                                        "-1e9",
                                        "2147483647",
                                        "-2147483648",
                                        "4294967296",
                                        "nan",
                                        "inf",
                                        "-inf",
                                        "0.5 m",
                                        "1,5",
                                        "1, 2, 3, 4, 5, 6, 7",
                                        "1, 2; 3",
                                        "; ; ,",
                                        "text",
                                        "yes",
                                        "sqrt(-1)",
                                        "1/t",
                                        "x +",
                                        "/nowhere/file",
                                        ".",
                                        "/dev/null",
                                        "%s%n",
                                        "\xC3\xA4",
                                        std::string(100000, 'x')};

/// The mistakes, and the other words of a selection.
std::vector<std::string> values_for(const std::string &description)
{
  std::vector<std::string> values = mistakes;
  if (description.find("[Selection ") == 0)
    for (const std::string &word :
         split(declared::between(description, "[Selection ", "]"), '|'))
      values.push_back(word);
  return values;
}

void collect(const declared::Tree &node,
             const std::string &path,
             std::vector<Change> &changes)
{
  for (const std::string &name : declared::names(node, true))
    for (const std::string &value :
         values_for(node[name]["pattern_description"].get<std::string>()))
      changes.push_back({path + name, value});
  for (const std::string &name : declared::names(node, false))
    if (!declared::is_pattern(name))
      collect(node[name], path + name + "/", changes);
}

/// Every mistake in every entry, in an order that is always the same.
std::vector<Change> changes_of(const Application &application,
                               const std::string &file)
{
  dealii::ParameterHandler prm;
  application.declare(prm);
  apply_assignments(read_assignments(file), prm);
  std::vector<Change> changes;
  collect(declared::tree_of(prm), "", changes);
  std::mt19937 random(1);
  // std::shuffle may differ from one library to another.
  for (std::size_t i = changes.size(); i > 1; --i)
    std::swap(changes[i - 1], changes[random() % i]);
  return changes;
}

std::string assignment(const Change &change)
{
  std::vector<std::string> path = split(change.first, '/');
  std::string text = "set " + path.back() + " = " + change.second + "\n";
  path.pop_back();
  for (auto section = path.rbegin(); section != path.rend(); ++section)
    text = "subsection " + *section + "\n" + text + "end\n";
  return text;
}

void keep_message(const std::string &path, const std::string &message)
{
  const char *const file = std::getenv("CONTRECOUP_FUZZ_MESSAGES");
  if (file == nullptr)
    return;
  const std::string text = io::read_file(path);
  std::ofstream(file, std::ios::app)
    << one_line(text.substr(text.find('\n') + 1)).substr(0, 200) << " -> "
    << message << '\n';
}

/// @throws InputError when the application refuses the file as it should, and
///   std::runtime_error when it does anything else but accept it
void check(const std::string &name, const std::string &path)
{
  dealii::deal_II_exceptions::disable_abort_on_exception();
  dealii::deal_II_exceptions::suppress_stacktrace_in_exceptions();
  const fs::path folder = fs::path(path).parent_path();
  const std::string output = (folder / "output").string();
  const std::string errors = (folder / "errors").string();
  if (std::freopen(errors.c_str(), "w", stderr) == nullptr)
    throw std::runtime_error("cannot redirect the standard error");
  const Failure failure =
    applications().at(name).run({name, path, "--output", output, "--check"});
  std::fflush(stderr);
  if (fs::exists(output))
    throw std::runtime_error("--check wrote " + output);
  if (fs::file_size(errors) > 0)
    throw std::runtime_error("it wrote besides its message: " +
                             one_line(io::read_file(errors)));
  if (failure.code == ExitCode::done)
    return;
  if (failure.code != ExitCode::bad_input)
    throw std::runtime_error("exit code " +
                             std::to_string(static_cast<int>(failure.code)) +
                             ": " + failure.message);
  if (failure.message.size() > longest_message)
    throw std::runtime_error("a message of " +
                             std::to_string(failure.message.size()) +
                             " characters: " + failure.message);
  keep_message(path, failure.message);
  throw InputError(failure.message);
}

/// Numbers of a tree of entries that may be as large or small as a double.
unsigned int unbounded_entries(const declared::Tree &node,
                               const std::string &path)
{
  unsigned int count = 0;
  for (const std::string &name : declared::names(node, true))
    if (node[name]["pattern_description"].get<std::string>().find(
          "MAX_DOUBLE") != std::string::npos)
    {
      std::cout << path << name << " has no bounds\n";
      ++count;
    }
  for (const std::string &name : declared::names(node, false))
    count += unbounded_entries(node[name], path + name + "/");
  return count;
}

fuzz::Reader reader_of(const std::string &name, const std::string &file)
{
  const auto changes = std::make_shared<std::vector<Change>>(
    changes_of(applications().at(name), file));
  const fs::path root = fs::path(CONTRECOUP_PARAMETER_FILES);
  fuzz::Reader reader;
  reader.name = fs::path(file).lexically_relative(root).string();
  reader.file = "run.prm";
  reader.prepare = [file](const std::string &folder) {
    std::ofstream(folder + "/run.prm") << "include " << file << "\n";
  };
  reader.read = [name](const std::string &path) { check(name, path); };
  reader.mutate = [changes](const std::string &content,
                            const std::uint64_t number) {
    return number == 0 ? content : content + assignment((*changes)[number - 1]);
  };
  reader.versions = changes->size();
  return reader;
}

std::vector<fuzz::Reader> all_readers(const bool quickstarts_alone)
{
  std::vector<fuzz::Reader> readers;
  for (const auto &one : applications())
  {
    std::vector<std::string> files;
    for (const auto &item : fs::recursive_directory_iterator(
           fs::path(CONTRECOUP_PARAMETER_FILES) / one.first))
    {
      const std::string path = item.path().string();
      const bool is_quickstart =
        item.path().filename().string().find("quickstart") == 0;
      const bool is_verification =
        path.find("/verification/") != std::string::npos;
      if (item.path().extension() == ".prm" &&
          (is_quickstart || (is_verification && !quickstarts_alone)))
        files.push_back(path);
    }
    std::sort(files.begin(), files.end());
    for (const std::string &file : files)
      readers.push_back(reader_of(one.first, file));
  }
  return readers;
}
} // namespace


int main(int argc, char **argv)
{
  // Trial runs are of no interest here, nor what was found before.
  setenv("CONTRECOUP_CHECK_SECONDS", "0", 1);
  setenv("XDG_CACHE_HOME", (fs::current_path() / "fuzz_cache").c_str(), 1);
  std::vector<char *> words;
  bool all = false;
  for (int i = 0; i < argc; ++i)
    if (std::string(argv[i]) == "--all")
      all = true;
    else
      words.push_back(argv[i]);
  unsigned int unbounded_ones = 0;
  for (const auto &[name, application] : applications())
  {
    dealii::ParameterHandler prm;
    application.declare(prm);
    unbounded_ones += unbounded_entries(declared::tree_of(prm), name + ": ");
  }
  const int failed =
    fuzz::run(static_cast<int>(words.size()), words.data(), all_readers(!all));
  return unbounded_ones > 0 ? 1 : failed;
}
