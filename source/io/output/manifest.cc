// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/file/name_patterns.h>
#include <contrecoup/io/output/folder_lock.h>
#include <contrecoup/io/output/manifest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <set>

namespace contrecoup
{
namespace io
{
  namespace
  {
    namespace fs = std::filesystem;
    void add_missing(std::vector<std::string> &names,
                     const std::vector<std::string> &more)
    {
      for (const std::string &name : more)
        if (std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
    }

    Json to_json(const std::map<std::string, FileDigest> &files)
    {
      Json json = Json::object();
      for (const auto &[file, digest] : files)
        json[file] = {{"bytes", digest.bytes}, {"crc32", digest.crc32}};
      return json;
    }

    std::map<std::string, FileDigest> digests(const Json &json)
    {
      std::map<std::string, FileDigest> files;
      for (const auto &item : json.items())
      {
        FileDigest &digest = files[item.key()];
        item.value().at("bytes").get_to(digest.bytes);
        item.value().at("crc32").get_to(digest.crc32);
      }
      return files;
    }

    /// A damaged manifest must not name files outside its folder, or itself.
    void require_inside(const std::string &name)
    {
      bool is_inside = !name.empty() && name[0] != '/' && name.size() < 4096;
      for (const std::string &part : split(name, '/'))
        is_inside = is_inside && part != ".." && part != ".";
      if (!is_inside)
        throw InputError("the name \"" + name + "\" is not of this folder");
    }

    /// All file patterns.
    std::vector<std::string> patterns(const FileNames &names)
    {
      std::vector<std::string> all = names.results;
      add_missing(all, names.others);
      all.erase(std::remove_if(
                  all.begin(),
                  all.end(),
                  [](const std::string &name) { return name.back() == '/'; }),
                all.end());
      return all;
    }

    /// Folders with their own manifest.
    std::vector<std::string> folders(const FileNames &names)
    {
      std::vector<std::string> found;
      for (const std::string &name : names.others)
        if (name.back() == '/')
          found.push_back(name.substr(0, name.size() - 1));
      return found;
    }
  } // namespace

  FileNames operator+(FileNames first, const FileNames &second)
  {
    add_missing(first.results, second.results);
    add_missing(first.others, second.others);
    return first;
  }

  FileNames field_files(const std::string &stem)
  {
    FileNames names;
    for (const char *ending :
         {"_#.vtu", "_#.#.vtu", "_#.pvtu", "_#.h5", "_#.xdmf"})
      names.results.push_back("fields/" + stem + ending);
    return names;
  }

  FileNames picture_files(const std::vector<std::string> &names)
  {
    FileNames pictures;
    for (const std::string &name : names)
      pictures.others.push_back("pictures/" + name);
    return pictures;
  }

  RunInput make_run_input(const std::map<std::string, std::string> &entries)
  {
    RunInput input;
    input.entries = entries;
    std::error_code ignored;
    // Entries contain absolute file names at this point.
    for (const auto &item : entries)
      if (!item.second.empty() && item.second[0] == '/' &&
          fs::is_regular_file(item.second, ignored))
        input.files[item.second] = digest_of(item.second);
    return input;
  }

  std::string difference(const RunInput &before, const RunInput &now)
  {
    for (const auto &[entry, value] : now.entries)
    {
      const auto other = before.entries.find(entry);
      if (other == before.entries.end())
        return "there was no entry \"" + entry + "\"";
      if (other->second != value)
        return "\"" + entry + "\" was \"" + other->second + "\" and is now \"" +
               value + "\"";
    }
    for (const auto &item : before.entries)
      if (now.entries.find(item.first) == now.entries.end())
        return "the entry \"" + item.first + "\" = \"" + item.second +
               "\" is now missing";
    for (const auto &[file, digest] : now.files)
    {
      const auto other = before.files.find(file);
      if (other == before.files.end() || !(other->second == digest))
        return "the file \"" + file + "\" has changed";
    }
    return "";
  }

  Manifest::Manifest(const std::string &folder)
    : folder_(folder)
  {
    std::error_code ignored;
    const std::string file = path(name);
    if (!fs::exists(fs::symlink_status(file, ignored)))
      return;
    read_json(file, formats::manifest);
    try
    {
      read(read_file(file));
    }
    catch (const std::exception &)
    {
      throw InputError("\"" + file +
                       "\" is damaged or was not written by Contrecoup, "
                       "which needs this name; move it away, or give "
                       "another folder");
    }
  }

  void Manifest::read(const std::string &text)
  {
    const Json json = Json::parse(text);
    json.at("names").at("results").get_to(names_.results);
    json.at("names").at("others").get_to(names_.others);
    json.at("status").get_to(status_);
    json.at("entries").get_to(input_.entries);
    input_.files = digests(json.at("input_files"));
    results_ = digests(json.at("results"));
    for (const auto *const names : {&names_.results, &names_.others})
      for (const std::string &one : *names)
        require_inside(one);
    for (const auto &result : results_)
      require_inside(result.first);
    // Read last, because exists() tests it.
    json.at("application").get_to(application_);
  }

  void Manifest::write() const
  {
    const Json json = {
      {"application", application_},
      {"format", formats::manifest.number},
      {"version", version()},
      {"git_revision", git_revision()},
      {"status", status_},
      {"names", {{"results", names_.results}, {"others", names_.others}}},
      {"results", to_json(results_)},
      {"input_files", to_json(input_.files)},
      {"entries", input_.entries}};
    write_file(path(name),
               [&](std::ostream &out) { out << json.dump(1) << '\n'; });
    sync(path(name));
  }

  std::vector<std::string> Manifest::foreign_files(const FileNames &names) const
  {
    std::vector<std::string> foreign;
    const std::vector<std::string> own = files_here();
    const std::vector<std::string> all = find_files(folder_, patterns(names));
    std::set_difference(all.begin(),
                        all.end(),
                        own.begin(),
                        own.end(),
                        std::back_inserter(foreign));
    // A file with the name of a folder.
    std::set<std::string> parents;
    for (const std::string &pattern : patterns(names))
      if (const std::size_t slash = pattern.find('/');
          slash != std::string::npos)
        parents.insert(pattern.substr(0, slash));
    for (const std::string &folder : folders(names))
      parents.insert(folder);
    std::error_code ignored;
    for (const std::string &parent : parents)
      if (fs::exists(fs::symlink_status(path(parent), ignored)) &&
          !fs::is_directory(path(parent), ignored))
        foreign.push_back(parent);
    // A folder of another run.
    const std::vector<std::string> known = folders(names_);
    for (const std::string &folder : folders(names))
      if (fs::exists(path(folder + "/" + name), ignored) &&
          std::find(known.begin(), known.end(), folder) == known.end())
        foreign.push_back(folder + "/");
    // A folder with the name of a file.
    for (const std::string &pattern : patterns(names))
      if (fs::is_directory(path(pattern), ignored))
        foreign.push_back(pattern + "/");
    return foreign;
  }

  std::vector<std::string> Manifest::files_here() const
  {
    FileNames names = names_;
    // After a finished run, further files with names of results are foreign.
    if (status_ == "finished")
    {
      names.results.clear();
      for (const auto &item : results_)
        names.results.push_back(item.first);
    }
    return find_files(folder_, patterns(names));
  }

  std::vector<std::string> Manifest::own_files() const
  {
    std::vector<std::string> files = files_here();
    for (const std::string &folder : folders(names_))
    {
      const Manifest inner(path(folder));
      if (!inner.exists())
        continue;
      for (const std::string &file : inner.own_files())
        files.push_back(folder + "/" + file);
      for (const std::string &file : inner.files_about())
        files.push_back(folder + "/" + file);
    }
    return files;
  }

  std::vector<std::string> Manifest::files_about() const
  {
    return find_files(folder_, {name, FolderLock::name});
  }

  void Manifest::begin(const std::string &application,
                       const FileNames &names,
                       const RunInput &input)
  {
    const std::vector<std::string> old_files = own_files();
    resume(application, names, input);
    remove_files(folder_, old_files);
    names_ = names;
    write();
  }

  void Manifest::resume(const std::string &application,
                        const FileNames &names,
                        const RunInput &input)
  {
    application_ = application;
    status_ = "started";
    names_ = names + names_;
    input_ = input;
    results_.clear();
    write();
  }

  void Manifest::set_status(const std::string &status)
  {
    status_ = status;
    results_.clear();
    if (status == "finished")
      for (const std::string &file : find_files(folder_, names_.results))
        results_[file] = digest_of(path(file));
    write();
  }

  std::string Manifest::damage() const
  {
    for (const auto &[file, digest] : results_)
    {
      std::error_code error;
      const auto size = fs::file_size(path(file), error);
      if (error)
        return "the file \"" + path(file) + "\" is missing";
      if (size != digest.bytes)
        return "the file \"" + path(file) + "\" has " + std::to_string(size) +
               " bytes instead of " + std::to_string(digest.bytes);
      if (!(digest_of(path(file)) == digest))
        return "the content of the file \"" + path(file) + "\" has changed";
    }
    return "";
  }

  void Manifest::remove_all()
  {
    remove_files(folder_, own_files());
    remove_files(folder_, files_about());
    *this = Manifest(folder_);
  }
} // namespace io
} // namespace contrecoup
