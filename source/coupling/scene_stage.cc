// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/log.h>
#include <contrecoup/base/text.h>
#include <contrecoup/coupling/scene_stage.h>
#include <contrecoup/coupling/source_digest.h>
#include <contrecoup/io/checked_file.h>
#include <contrecoup/io/temporary_folder.h>

#include <deal.II/base/mpi.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <nlohmann/json.hpp>

#include <chrono>
#include <filesystem>
#include <sstream>

namespace contrecoup::coupling
{
namespace
{
  namespace fs = std::filesystem;
  using Json = nlohmann::ordered_json;

  /// The content of every file that the values of a parameter file name.
  std::string contents_of_files(const std::string &text)
  {
    std::string contents;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
      const std::size_t equals = line.find(" = ");
      if (equals == std::string::npos)
        continue;
      const std::string value = trim(line.substr(equals + 3));
      std::error_code ignored;
      if (!value.empty() && value[0] == '/' &&
          fs::is_regular_file(value, ignored))
        contents += short_key(io::read_file(value)) + "\n";
    }
    return contents;
  }


  double size_of_folder(const std::string &folder)
  {
    double size = 0.;
    std::error_code ignored;
    for (const auto &entry : fs::recursive_directory_iterator(folder, ignored))
      if (entry.is_regular_file(ignored))
        size += static_cast<double>(entry.file_size(ignored));
    return size;
  }


  bool is_first_rank()
  {
    return dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
  }


  /// A number of a JSON object, or 0.
  double number(const Json &object, const char *name)
  {
    return object.contains(name) && object[name].is_number()
             ? object[name].get<double>()
             : 0.;
  }
} // namespace


std::string short_key(const std::string &text)
{
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(text));
}


SceneStage::SceneStage(const std::string &name,
                       const std::string &scene_folder,
                       const std::string &text,
                       const std::vector<std::string> &upstream,
                       const bool can_resume,
                       const Runner &runner)
  : name_(name)
  , scene_folder_(scene_folder)
  , text_(text)
  , can_resume_(can_resume)
  , runner_(runner)
{
  record_.key = short_key(source_digest(name) + "\n" + text +
                          contents_of_files(text) + join(upstream, "\n"));
  read_record();
}


bool SceneStage::has_record() const
{
  return fs::exists(file(".stage.json"));
}


void SceneStage::read_record()
{
  if (!has_record())
    return;
  const Json json =
    Json::parse(io::read_file(file(".stage.json")), nullptr, false);
  // A damaged record, or one of something else, is none.
  if (!json.is_object() || json.value("key", "") != record_.key)
    return;
  record_.status = json.value("status", "");
  record_.wall_seconds = number(json, "wall_seconds");
  record_.core_seconds = number(json, "core_seconds");
  record_.peak_memory = number(json, "peak_memory");
  record_.disk = number(json, "disk");
}


void SceneStage::write_record() const
{
  const Json json = {{"key", record_.key},
                     {"status", record_.status},
                     {"wall_seconds", record_.wall_seconds},
                     {"core_seconds", record_.core_seconds},
                     {"peak_memory", record_.peak_memory},
                     {"disk", record_.disk}};
  io::write_file(file(".stage.json"),
                 [&](std::ostream &out) { out << json.dump(2) << "\n"; });
}


bool SceneStage::has_checkpoint() const
{
  std::error_code ignored;
  for (const auto &entry :
       fs::directory_iterator(folder() + "/checkpoint", ignored))
    if (fs::exists(entry.path() / "complete.json", ignored))
      return true;
  return false;
}


void SceneStage::take_summary(const double wall_seconds)
{
  const Json json =
    Json::parse(io::read_file(folder() + "/summary.json"), nullptr, false);
  if (!json.is_object())
    throw SystemError("cannot read \"" + folder() + "/summary.json\"");
  const Json &performance = json["performance"];
  record_.status = json.value("status", "failed");
  record_.wall_seconds += wall_seconds;
  const double cores = number(performance, "core_seconds");
  record_.core_seconds += cores > 0. ? cores : wall_seconds;
  record_.peak_memory =
    std::max(record_.peak_memory, number(performance, "peak_memory_bytes"));
  record_.disk = size_of_folder(folder());
}


void SceneStage::check(Collective &collective)
{
  // Every rank has its own, for there may be no folder that all of them see.
  const io::TemporaryFolder temporary;
  const std::string path = temporary.path() + "/" + name_ + ".prm";
  collective.run(
    [&]() { io::write_file(path, [&](std::ostream &out) { out << text_; }); });
  const Failure failure =
    runner_({name_, path, "--output", folder(), "--check"});
  if (failure.code != ExitCode::done)
    throw_failure({failure.code, "stage " + name_ + ": " + failure.message});
}


bool SceneStage::run(const bool resume, Collective &collective)
{
  if (is_finished())
    return true;
  std::vector<std::string> words = {name_, file(".prm"), "--output", folder()};
  words.insert(words.end(), arguments_.begin(), arguments_.end());
  const bool goes_on = collective.run_with_flags([&]() {
    return is_first_rank() && resume && can_resume_ &&
               !record_.status.empty() && has_checkpoint()
             ? 1U
             : 0U;
  }) != 0;
  if (goes_on)
    words.push_back("--resume");
  collective.run([&]() {
    if (!is_first_rank())
      return;
    if (!goes_on)
    {
      const std::string key = record_.key;
      record_ = {};
      record_.key = key;
      // What another scene or an earlier start left would be taken for
      // this one's.
      io::remove_quietly(folder());
    }
    record_.status = "started";
    io::write_file(file(".prm"), [&](std::ostream &out) { out << text_; });
    write_record();
  });
  const auto begin = std::chrono::steady_clock::now();
  const Failure failure = runner_(words);
  const double wall_seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
  if (failure.code != ExitCode::done)
    throw_failure({failure.code, "stage " + name_ + ": " + failure.message});
  const unsigned int finished = collective.run_with_flags([&]() {
    if (!is_first_rank())
      return 0U;
    take_summary(wall_seconds);
    write_record();
    return is_finished() ? 1U : 0U;
  });
  return finished != 0;
}
} // namespace contrecoup::coupling
