// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/coupling/task/task_files.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/output/folder_lock.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace contrecoup::coupling
{
namespace
{
  namespace fs = std::filesystem;
  bool exists(const std::string &path)
  {
    std::error_code ignored;
    return fs::exists(fs::symlink_status(path, ignored));
  }


  void rename(const std::string &from, const std::string &to)
  {
    std::error_code error;
    fs::rename(from, to, error);
    if (error)
      throw SystemError("cannot rename \"" + from + "\" to \"" + to +
                        "\": " + error.message());
  }


  /// Moves files that are not in @p own to the same path in another folder,
  /// unless that exists.
  void move_others(const fs::path &from,
                   const fs::path &to,
                   const std::vector<std::string> &own)
  {
    std::vector<fs::path> others;
    std::error_code ignored;
    for (const auto &item : fs::recursive_directory_iterator(from, ignored))
    {
      const fs::path file = item.path().lexically_relative(from);
      if ((item.is_symlink(ignored) || !item.is_directory(ignored)) &&
          std::find(own.begin(), own.end(), file.string()) == own.end())
        others.push_back(file);
    }
    for (const fs::path &file : others)
      if (!exists((to / file).string()))
      {
        fs::create_directories((to / file).parent_path());
        rename((from / file).string(), (to / file).string());
      }
  }


  /// Removes empty folders.
  void remove_empty(const fs::path &folder)
  {
    std::error_code ignored;
    std::vector<fs::path> inner;
    for (const auto &item : fs::directory_iterator(folder, ignored))
      if (item.is_directory(ignored) && !item.is_symlink(ignored))
        inner.push_back(item.path());
    for (const fs::path &path : inner)
      remove_empty(path);
    fs::remove(folder, ignored);
  }
} // namespace


TaskFiles::TaskFiles(const std::string &scene_folder, const std::string &name)
  : scene_folder_(scene_folder)
  , name_(name)
{}


io::FileNames TaskFiles::names(const std::string &task)
{
  io::FileNames names;
  for (const char *ending : {".prm",
                             ".new.prm",
                             ".stage.json",
                             ".new.stage.json",
                             "/",
                             ".new/",
                             ".old/"})
    names.others.push_back(task + ending);
  return names;
}


std::string TaskFiles::folder(const bool uses_new_folder) const
{
  return path(uses_new_folder ? ".new" : "");
}


std::string TaskFiles::parameter_file(const bool uses_new_folder) const
{
  return path(uses_new_folder ? ".new.prm" : ".prm");
}


std::string TaskFiles::record_file(const bool uses_new_folder) const
{
  return path(uses_new_folder ? ".new.stage.json" : ".stage.json");
}


TaskRecord TaskFiles::read_record(const bool uses_new_folder) const
{
  if (!exists(record_file(uses_new_folder)))
    return {};
  const io::Json json =
    io::read_json(record_file(uses_new_folder), io::formats::stage);
  try
  {
    TaskRecord record;
    json.at("key").get_to(record.key);
    json.at("status").get_to(record.status);
    json.at("wall_seconds").get_to(record.wall_seconds);
    json.at("core_seconds").get_to(record.core_seconds);
    json.at("peak_memory").get_to(record.peak_memory);
    json.at("disk").get_to(record.disk);
    return record;
  }
  catch (const io::Json::exception &)
  {
    show_line("\"" + record_file(uses_new_folder) +
              "\" is damaged; the stage counts as not begun");
    return {};
  }
}


void TaskFiles::write_record(const bool uses_new_folder,
                             const TaskRecord &record) const
{
  const io::Json json = {{"format", io::formats::stage.number},
                         {"key", record.key},
                         {"status", record.status},
                         {"wall_seconds", record.wall_seconds},
                         {"core_seconds", record.core_seconds},
                         {"peak_memory", record.peak_memory},
                         {"disk", record.disk}};
  io::write_file(record_file(uses_new_folder),
                 [&](std::ostream &out) { out << json.dump(2) << "\n"; });
}


std::string TaskFiles::find_damage() const
{
  try
  {
    const io::Manifest manifest(folder(false));
    if (!manifest.exists())
      return "\"" + folder(false) + "/" + io::Manifest::name + "\" is missing";
    if (manifest.status() != "finished")
      return "the run in \"" + folder(false) + "\" is " + manifest.status();
    return manifest.damage();
  }
  catch (const InputError &error)
  {
    return error.what();
  }
}


bool TaskFiles::has_checkpoint(const bool uses_new_folder) const
{
  std::error_code ignored;
  for (const auto &entry :
       fs::directory_iterator(folder(uses_new_folder) + "/checkpoint", ignored))
    if (fs::exists(entry.path() / "complete.json", ignored))
      return true;
  return false;
}


void TaskFiles::replace() const
{
  if (exists(folder(true)))
  {
    if (exists(folder(false)))
    {
      clear_old();
      rename(folder(false), path(".old"));
    }
    rename(folder(true), folder(false));
  }
  if (exists(parameter_file(true)))
    rename(parameter_file(true), parameter_file(false));
  rename(record_file(true), record_file(false));
  clear_old();
}


void TaskFiles::complete_replace() const
{
  if (read_record(true).status == "finished")
    replace();
  else
    clear_old();
}


void TaskFiles::clear_old() const
{
  const std::string old = path(".old");
  if (!exists(old) || !exists(folder(false)))
    return;
  io::Manifest manifest(old);
  if (manifest.exists())
  {
    std::vector<std::string> own = manifest.own_files();
    own.insert(own.end(), {io::Manifest::name, io::FolderLock::name});
    move_others(old, folder(false), own);
    manifest.remove_all();
    remove_empty(old);
  }
  if (exists(old))
    show_line("note: \"" + old +
              "\" keeps files that Contrecoup has not written");
}
} // namespace contrecoup::coupling
