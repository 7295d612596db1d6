// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file/file_digest.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Patterns of the names that a run writes into its folder, see
  /// find_files(). A name ending in "/" is a folder with its own manifest.
  struct FileNames
  {
    /// do not change after the run has finished
    std::vector<std::string> results;
    /// may change: logs, pictures, checkpoints
    std::vector<std::string> others;
  };

  FileNames operator+(FileNames first, const FileNames &second);

  /// Field files of all outputs and ranks, in every format, with names that
  /// begin with @p stem.
  FileNames field_files(const std::string &stem);

  /// Pictures with these names, which may be redrawn at any time.
  FileNames picture_files(const std::vector<std::string> &names);

  /// Input of a run: entries with values, and the files that they name.
  struct RunInput
  {
    std::map<std::string, std::string> entries;
    std::map<std::string, FileDigest> files;
  };

  /// Reads the files named by entries, in order to detect changes.
  RunInput make_run_input(const std::map<std::string, std::string> &entries);

  /// Difference in one clause that names the entry; empty if none.
  std::string difference(const RunInput &before, const RunInput &now);

  /**
   * Records which files of a folder belong to Contrecoup. "manifest.json"
   * lists all files that a run may write before it writes them, so that they
   * are recognised even after kill -9; at the end it holds size and CRC-32 of
   * each result. No other file in the folder is ever changed or removed. For
   * use by one rank.
   */
  class Manifest
  {
  public:
    /// Name of the file.
    static constexpr const char *name = "manifest.json";

    /// Reads the manifest of @p folder; without one, no file there is
    /// Contrecoup's.
    /// @throws InputError when "manifest.json" is damaged or foreign
    explicit Manifest(const std::string &folder);

    bool exists() const
    {
      return !application_.empty();
    }
    const std::string &application() const
    {
      return application_;
    }
    /// One of "started", "stopped", "failed", "finished".
    const std::string &status() const
    {
      return status_;
    }
    const RunInput &input() const
    {
      return input_;
    }

    /// Existing files with these names that are not Contrecoup's.
    std::vector<std::string> foreign_files(const FileNames &names) const;

    /// Existing files that are Contrecoup's, including those of folders with
    /// their own manifest.
    std::vector<std::string> own_files() const;

    /// Records these names for a new run, then removes the files of an earlier
    /// run.
    void begin(const std::string &application,
               const FileNames &names,
               const RunInput &input);

    /// Continues the recorded run: keeps existing files.
    void resume(const std::string &application,
                const FileNames &names,
                const RunInput &input);

    /// Sets the status of the run; if it is finished, also size and CRC-32 of
    /// each result.
    void set_status(const std::string &status);

    /// First damaged or missing result of a finished run, as one clause; empty
    /// if there is none. Reads all results.
    std::string damage() const;

    /// Removes all files that are Contrecoup's, the manifest last.
    void remove_all();

  private:
    void read(const std::string &text);
    void write() const;
    std::vector<std::string> files_here() const;
    /// Administrative files of the folder, such as manifest and lock.
    std::vector<std::string> files_about() const;
    std::string path(const std::string &file) const
    {
      return folder_ + "/" + file;
    }

    std::string folder_;
    std::string application_;
    std::string status_;
    FileNames names_;
    RunInput input_;
    std::map<std::string, FileDigest> results_;
  };
} // namespace io
} // namespace contrecoup
