// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file_digest.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// The names of what a run writes into its folder, as patterns: see
  /// find_files(). A name that ends in "/" is a folder with a manifest of its
  /// own.
  struct FileNames
  {
    std::vector<std::string> results; ///< never change once it has finished
    std::vector<std::string> others;  ///< may: logs, pictures, checkpoints
  };

  FileNames operator+(FileNames first, const FileNames &second);

  /// The fields of all outputs and ranks, in every format, of files whose names
  /// begin with @p stem.
  FileNames field_files(const std::string &stem);

  /// Pictures of these names, which may be drawn again at any time.
  FileNames picture_files(const std::vector<std::string> &names);

  /// What a run was asked for: entries and their values, and the files that
  /// these name.
  struct RunInput
  {
    std::map<std::string, std::string> entries;
    std::map<std::string, FileDigest> files;
  };

  /// Reads the files that are values of entries, so that a change is noticed.
  RunInput make_run_input(const std::map<std::string, std::string> &entries);

  /// What differs, in one clause that names the entry; empty if nothing does.
  std::string difference(const RunInput &before, const RunInput &now);

  /**
   * What of a folder is Contrecoup's: the file "manifest.json" names, before
   * they are written, all files that a run may write, so that they are known
   * for its own even after kill -9, and at the end has size and CRC-32 of each
   * result. Nothing else in the folder is ever written to or removed. Used by
   * one rank.
   */
  class Manifest
  {
  public:
    /// The file.
    static constexpr const char *name = "manifest.json";

    /// Reads that of @p folder; without one, nothing there is Contrecoup's.
    /// @throws InputError when "manifest.json" is damaged or something else's
    explicit Manifest(const std::string &folder);

    bool is_there() const
    {
      return !application_.empty();
    }
    const std::string &application() const
    {
      return application_;
    }
    /// started, stopped, failed or finished.
    const std::string &status() const
    {
      return status_;
    }
    const RunInput &input() const
    {
      return input_;
    }

    /// Existing files of these names that are not Contrecoup's.
    std::vector<std::string> foreign_files(const FileNames &names) const;

    /// Existing files that are Contrecoup's, with those of folders that have
    /// a manifest of their own.
    std::vector<std::string> own_files() const;

    /// Says first that files of these names will be Contrecoup's, and then
    /// removes what an earlier run left.
    void begin(const std::string &application,
               const FileNames &names,
               const RunInput &input);

    /// Goes on with the run that wrote it: keeps what there is.
    void go_on(const std::string &application,
               const FileNames &names,
               const RunInput &input);

    /// Says how the run stands; when it has finished, with size and CRC-32 of
    /// each result.
    void set_status(const std::string &status);

    /// The first result of a finished run that is not there as it was written,
    /// in one clause; empty if all are. Reads every one.
    std::string damage() const;

    /// Removes every file that is Contrecoup's, in the end the manifest.
    void remove_all();

  private:
    void read(const std::string &text);
    void write() const;
    std::vector<std::string> files_here() const;
    /// Files about the folder itself, which are no content.
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
