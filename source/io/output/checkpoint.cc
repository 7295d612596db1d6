// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_digest.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/name_patterns.h>
#include <contrecoup/io/output/checkpoint.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <map>
#include <vector>

namespace contrecoup
{
namespace io
{
  namespace
  {
    namespace fs = std::filesystem;
    const char *const marker = "complete.json";
    const char *const run_file = "run.json";

    /// Names of files that solvers and this class write into a checkpoint.
    const std::vector<std::string> file_names = {"*.bin", "*.json", "*.h5"};

    /// Checkpoint folders by number.
    std::map<unsigned long, fs::path> numbered(const std::string &folder)
    {
      std::map<unsigned long, fs::path> found;
      std::error_code error;
      for (const auto &item : fs::directory_iterator(folder, error))
      {
        const std::string name = item.path().filename().string();
        if (item.is_directory() && name.size() >= 4 && name.size() <= 9 &&
            name.find_first_not_of("0123456789") == std::string::npos)
          found[std::stoul(name)] = item.path();
      }
      return found;
    }

    bool is_complete(const fs::path &checkpoint)
    {
      return fs::exists(checkpoint / marker);
    }

    void write_marker(const fs::path &checkpoint)
    {
      Json files = Json::object();
      for (const auto &item : fs::directory_iterator(checkpoint))
      {
        sync(item.path().string());
        const FileDigest digest = digest_of(item.path().string());
        files[item.path().filename().string()] = {{"bytes", digest.bytes},
                                                  {"crc32", digest.crc32}};
      }
      write_file((checkpoint / marker).string(), [&](std::ostream &out) {
        out << Json{{"files", files}}.dump(1) << '\n';
      });
      sync((checkpoint / marker).string());
      sync(checkpoint.string());
    }

    /// Damage of a checkpoint as one clause; empty if undamaged.
    std::string damage(const fs::path &checkpoint)
    {
      if (!is_complete(checkpoint))
        return "it is incomplete: the run ended while writing it";
      const Json list =
        Json::parse(read_file((checkpoint / marker).string()), nullptr, false);
      const std::string broken =
        "the file \"" + std::string(marker) + "\" is damaged";
      if (!list.is_object() || !list.contains("files") ||
          !list["files"].is_object())
        return broken;
      for (const auto &item : list["files"].items())
      {
        const fs::path file = checkpoint / item.key();
        const Json &want = item.value();
        for (const char *const name : {"bytes", "crc32"})
          if (!want.is_object() || !want.contains(name) ||
              !want[name].is_number_unsigned())
            return broken;
        std::error_code error;
        const auto size = fs::file_size(file, error);
        if (error)
          return "the file \"" + item.key() + "\" is missing";
        const auto bytes = want["bytes"].get<std::uint64_t>();
        if (size != bytes)
          return "the file \"" + item.key() + "\" has " + std::to_string(size) +
                 " bytes instead of " + std::to_string(bytes);
        if (digest_of(file.string()).crc32 !=
            want["crc32"].get<std::uint64_t>())
          return "the content of the file \"" + item.key() + "\" is damaged";
      }
      return "";
    }

    void remove_checkpoint(const fs::path &checkpoint)
    {
      const std::string folder = checkpoint.parent_path().string();
      std::vector<std::string> patterns;
      for (const std::string &file : file_names)
        patterns.push_back(checkpoint.filename().string() + "/" + file);
      remove_files(folder, find_files(folder, patterns));
    }

    void remove_old(const std::string &folder)
    {
      constexpr unsigned int kept = 2;
      unsigned int complete = 0;
      const auto all = numbered(folder);
      for (auto item = all.rbegin(); item != all.rend(); ++item)
      {
        if (is_complete(item->second) && complete < kept)
          ++complete;
        else
          remove_checkpoint(item->second);
      }
    }
  } // namespace

  Checkpoints::Checkpoints(const std::string &folder, Collective &collective)
    : folder_(folder)
    , collective_(collective)
  {}

  void Checkpoints::write(const std::string &run,
                          const std::function<void(const std::string &)> &save)
  {
    namespace MPI = dealii::Utilities::MPI;
    const MPI_Comm all = collective_.communicator();
    const bool first_rank = MPI::this_mpi_process(all) == 0;
    std::string checkpoint;
    try
    {
      collective_.run([&]() {
        if (!first_rank)
          return;
        const auto existing = numbered(folder_);
        unsigned long next =
          existing.empty() ? 1 : existing.rbegin()->first + 1;
        char name[24];
        std::snprintf(name, sizeof(name), "%04lu", next);
        checkpoint = folder_ + "/" + name;
        std::error_code error;
        fs::create_directories(checkpoint, error);
        if (error)
          throw SystemError("cannot make the folder \"" + checkpoint +
                            "\": " + error.message());
      });
      checkpoint = broadcast_text(all, checkpoint, 0);
      collective_.run([&]() { save(checkpoint); });
      collective_.run([&]() {
        if (!first_rank)
          return;
        write_file(checkpoint + "/" + run_file,
                   [&](std::ostream &out) { out << run; });
        write_marker(checkpoint);
        remove_old(folder_);
      });
    }
    catch (...)
    {
      if (first_rank && !checkpoint.empty())
        remove_quietly(checkpoint);
      throw;
    }
  }

  std::optional<Checkpoints::Found> Checkpoints::newest() const
  {
    namespace MPI = dealii::Utilities::MPI;
    const MPI_Comm all = collective_.communicator();
    Found found;
    collective_.run(
      [&]() {
        if (MPI::this_mpi_process(all) != 0)
          return;
        std::string first_damage;
        const auto existing = numbered(folder_);
        for (auto item = existing.rbegin(); item != existing.rend(); ++item)
        {
          const std::string path = item->second.string();
          const std::string problem = damage(item->second);
          if (problem.empty())
          {
            found = {path, read_file(path + "/" + run_file)};
            if (!first_damage.empty())
              show_line(first_damage + "; using \"" + path + "\"");
            return;
          }
          if (first_damage.empty())
            first_damage = "checkpoint \"" + path + "\": " + problem;
        }
        if (!first_damage.empty())
          throw InputError(first_damage + "; there is no other to resume "
                                          "from");
      },
      ExitCode::bad_input);
    found.folder = broadcast_text(all, found.folder, 0);
    found.run = broadcast_text(all, found.run, 0);
    if (found.folder.empty())
      return std::nullopt;
    return found;
  }

  bool Checkpoints::has_complete() const
  {
    for (const auto &item : numbered(folder_))
      if (is_complete(item.second))
        return true;
    return false;
  }

  FileNames Checkpoints::files(const std::string &folder)
  {
    FileNames names;
    for (const std::string &file : file_names)
      names.others.push_back(folder + "/#/" + file);
    return names;
  }
} // namespace io
} // namespace contrecoup
