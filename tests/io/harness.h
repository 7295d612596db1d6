// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// Results of a run of the oscillator.
  struct Result
  {
    int code = 0;
    std::string out; ///< of this rank
    std::string err; ///< of this rank
  };

  /// Runs the oscillator with these arguments on all ranks, by default so that
  /// the screen gets all lines of the log.
  Result run_oscillator(const std::vector<std::string> &arguments,
                        bool verbose = true);

  /// The same with the parameter file of scene() and `--output folder`.
  Result run_scene(const std::string &folder,
                   const std::vector<std::string> &arguments = {});

  /// The path of a file in a folder that belongs to this number of ranks.
  std::string local(const std::string &name);

  /// Writes a parameter file on the first rank and returns its path.
  std::string scene();

  /// Removes a folder on the first rank and waits for that.
  void remove(const std::string &folder);

  /// The content of a file; empty if there is none.
  std::string content(const std::string &file);

  bool exists(const std::string &path);
  bool is_first_rank();
  int n_ranks();

  /// Lets no file grow past a size while it lives, as a full disk would.
  class FullDisk
  {
  public:
    explicit FullDisk(unsigned long largest_file);
    ~FullDisk();

  private:
    unsigned long old_limit_;
    void (*old_handler_)(int);
  };
} // namespace io
} // namespace contrecoup
