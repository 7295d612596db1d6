// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/name_patterns.h>

#include <cctype>
#include <filesystem>
#include <set>

namespace contrecoup
{
namespace io
{
  namespace
  {
    namespace fs = std::filesystem;

    bool is_digit(const char letter)
    {
      return std::isdigit(static_cast<unsigned char>(letter)) != 0;
    }

    bool matches(const char *name, const char *pattern)
    {
      if (*pattern == '\0')
        return *name == '\0';
      if (*pattern == '*')
        return matches(name, pattern + 1) ||
               (*name != '\0' && matches(name + 1, pattern));
      if (*pattern == '#')
        return is_digit(*name) &&
               (matches(name + 1, pattern) || matches(name + 1, pattern + 1));
      return *name == *pattern && matches(name + 1, pattern + 1);
    }

    bool is_exact(const std::string &pattern)
    {
      return pattern.find_first_of("*#") == std::string::npos;
    }

    /// Names in a folder that match one component of a pattern.
    std::vector<std::string> names_in(const fs::path &folder,
                                      const std::string &pattern)
    {
      std::error_code ignored;
      std::vector<std::string> names;
      // User folders may be large: list a folder only if necessary.
      if (is_exact(pattern))
      {
        if (fs::exists(fs::symlink_status(folder / pattern, ignored)))
          names.push_back(pattern);
      }
      else
        for (const auto &item : fs::directory_iterator(folder, ignored))
          if (io::matches(item.path().filename().string(), pattern))
            names.push_back(item.path().filename().string());
      return names;
    }

    /// Adds files below @p folder / @p below that match the components of a
    /// pattern from index @p depth on.
    void add_files(const fs::path &folder,
                   const fs::path &below,
                   const std::vector<std::string> &parts,
                   const std::size_t depth,
                   std::set<std::string> &files)
    {
      std::error_code ignored;
      const bool is_last = depth + 1 == parts.size();
      for (const std::string &name : names_in(folder / below, parts[depth]))
      {
        const bool is_folder = fs::is_directory(folder / below / name, ignored);
        if (is_last && !is_folder)
          files.insert((below / name).string());
        else if (!is_last && is_folder)
          add_files(folder, below / name, parts, depth + 1, files);
      }
    }
  } // namespace

  bool matches(const std::string &name, const std::string &pattern)
  {
    return matches(name.c_str(), pattern.c_str());
  }

  std::vector<std::string> find_files(const std::string &folder,
                                      const std::vector<std::string> &patterns)
  {
    std::set<std::string> files;
    for (const std::string &pattern : patterns)
      for (const char *ending : {"", ".partial"})
        add_files(folder, "", split(pattern + ending, '/'), 0, files);
    return {files.begin(), files.end()};
  }

  void remove_files(const std::string &folder,
                    const std::vector<std::string> &files)
  {
    std::set<fs::path> parents;
    for (const std::string &file : files)
    {
      std::error_code error;
      fs::remove(fs::path(folder) / file, error);
      if (error)
        throw SystemError("cannot remove \"" + folder + "/" + file +
                          "\": " + error.message());
      for (fs::path parent = fs::path(file).parent_path(); !parent.empty();
           parent = parent.parent_path())
        parents.insert(parent);
    }
    // Remove inner folders first; remove() keeps folders that are not empty.
    std::error_code ignored;
    for (auto parent = parents.rbegin(); parent != parents.rend(); ++parent)
      fs::remove(fs::path(folder) / *parent, ignored);
  }
} // namespace io
} // namespace contrecoup
