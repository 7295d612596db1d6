// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/log_words.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/task/scene_task.h>
#include <contrecoup/coupling/task/source_digest.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/temporary_folder.h>

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
  /// Contents of all files that values of a parameter file name.
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


  /// Number of a JSON object, 0 if missing.
  double number_or_zero(const io::Json &object, const char *name)
  {
    return object.contains(name) && object[name].is_number()
             ? object[name].get<double>()
             : 0.;
  }
} // namespace


// g++ 14 takes the end of a block, which SHA-1 fills, for all of it.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wstringop-overflow"
std::string short_key(const std::string &text)
{
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(text));
}
#pragma GCC diagnostic pop


SceneTask::SceneTask(const TaskDescription &description)
  : description_(description)
  , files_(description.scene_folder, description.name)
{
  record_.key = short_key(
    source_digest(description.application) + "\n" + description.text +
    contents_of_files(description.text) + join(description.upstream, "\n"));
}


void SceneTask::prepare() const
{
  files_.complete_replace();
  const auto foreign = io::Manifest(folder()).foreign_files(description_.files);
  if (!foreign.empty())
    throw InputError("\"" + folder() + "/" + foreign.front() +
                     "\" was written by no run of Contrecoup, and stage " +
                     name() + " would overwrite it; give another --output");
}


SceneTask::Status SceneTask::find_status()
{
  Status status;
  const std::string key = record_.key;
  const TaskRecord now = files_.read_record(false);
  const TaskRecord beside = files_.read_record(true);
  status.has_record = !now.status.empty() || !beside.status.empty();
  const bool was_finished = now.status == "finished";
  if (was_finished)
  {
    const std::string damage = files_.find_damage();
    status.is_damaged = !damage.empty();
    status.is_finished = damage.empty() && now.key == key;
    status.has_other_key = damage.empty() && now.key != key;
    if (!damage.empty())
      show_line("stage " + name() + " has to be made anew: " + damage);
  }
  status.uses_new_folder = was_finished;
  const TaskRecord &begun = was_finished ? beside : now;
  status.is_started = !status.is_finished && begun.key == key;
  status.has_checkpoint =
    !begun.status.empty() && files_.has_checkpoint(status.uses_new_folder);
  if (status.is_finished)
    record_ = now;
  else if (status.is_started)
    record_ = begun;
  return status;
}


void SceneTask::inspect(Collective &collective)
{
  collective.run([&]() {
    if (is_first_rank())
      status_ = find_status();
  });
  status_ =
    dealii::Utilities::MPI::broadcast(collective.communicator(), status_, 0);
}


void SceneTask::take_summary(const double wall_seconds)
{
  const std::string folder = files_.folder(status_.uses_new_folder);
  const io::Json json =
    io::read_json(folder + "/summary.json", io::formats::summary);
  if (!json.is_object())
    throw SystemError("cannot read \"" + folder + "/summary.json\"");
  const io::Json performance = json.value("performance", io::Json::object());
  const io::Json status = json.value("status", io::Json());
  record_.status = status.is_string() ? status.get<std::string>() : "failed";
  // Time of all starts; this one began before its summary counts.
  record_.wall_seconds =
    std::max(wall_seconds, number_or_zero(json, "wall_seconds"));
  const double cores = number_or_zero(performance, "core_seconds");
  record_.core_seconds = cores > 0. ? cores : wall_seconds;
  record_.peak_memory = std::max(
    record_.peak_memory, number_or_zero(performance, "peak_memory_bytes"));
  record_.disk = size_of_folder(folder);
}


Failure SceneTask::call(const std::vector<std::string> &arguments,
                        const double trial_share,
                        CostEstimate &cost) const
{
  const LogWords in_log(description_.words);
  Failure failure = description_.runner(arguments, trial_share, cost);
  failure.message = description_.words(failure.message);
  return failure;
}


CostEstimate SceneTask::check(const double trial_share, Collective &collective)
{
  // Each rank uses its own folder: a folder visible to all ranks may not
  // exist.
  const io::TemporaryFolder temporary;
  const std::string path = temporary.path() + "/" + name() + ".prm";
  collective.run([&]() {
    io::write_file(path, [&](std::ostream &out) { out << description_.text; });
  });
  CostEstimate cost;
  std::vector<std::string> words = {
    name(), path, "--output", folder(), "--check"};
  words.insert(words.end(),
               description_.check_arguments.begin(),
               description_.check_arguments.end());
  const Failure failure = call(words, trial_share, cost);
  if (failure.code != ExitCode::done)
    throw_failure({failure.code, "stage " + name() + ": " + failure.message});
  return cost;
}


void SceneTask::begin(const bool goes_on)
{
  if (!goes_on)
  {
    const std::string key = record_.key;
    record_ = {};
    record_.key = key;
  }
  record_.status = "started";
  io::write_file(files_.parameter_file(status_.uses_new_folder),
                 [&](std::ostream &out) { out << description_.text; });
  files_.write_record(status_.uses_new_folder, record_);
}


void SceneTask::end(const double wall_seconds)
{
  // A stopped tool has no summary.
  if (is_stop(stop_) && !description_.can_resume)
    record_.status = "stopped";
  else
    take_summary(wall_seconds);
  files_.write_record(status_.uses_new_folder, record_);
  status_.is_finished = record_.status == "finished";
  if (status_.is_finished && status_.uses_new_folder)
    files_.replace();
}


bool SceneTask::run(const bool resume, Collective &collective)
{
  if (is_finished())
    return true;
  const bool goes_on = resume && description_.can_resume &&
                       status_.has_checkpoint && status_.is_started;
  std::vector<std::string> words = {
    name(),
    files_.parameter_file(status_.uses_new_folder),
    "--output",
    files_.folder(status_.uses_new_folder),
    goes_on ? "--resume" : "--overwrite"};
  std::vector<std::string> late;
  collective.run([&]() {
    if (!is_first_rank())
      return;
    if (description_.find_late_arguments)
      late = description_.find_late_arguments();
    begin(goes_on);
  });
  late = dealii::Utilities::MPI::broadcast(collective.communicator(), late, 0);
  for (const auto *list : {&description_.arguments, &late})
    words.insert(words.end(), list->begin(), list->end());
  const auto begin = std::chrono::steady_clock::now();
  CostEstimate unused;
  const Failure failure = call(words, 0., unused);
  const double wall_seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
      .count();
  if (is_stop(failure))
    stop_ = failure;
  else if (failure.code != ExitCode::done)
    throw_failure({failure.code, "stage " + name() + ": " + failure.message});
  const unsigned int finished = collective.run_with_flags([&]() {
    if (is_first_rank())
      end(wall_seconds);
    return is_finished() ? 1U : 0U;
  });
  status_.is_finished = finished != 0;
  return is_finished();
}
} // namespace contrecoup::coupling
