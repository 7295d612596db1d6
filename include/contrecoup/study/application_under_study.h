// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/factor.h>

#include <map>

namespace contrecoup::study
{
/// The application that a study runs, with the base file of its variants.
class ApplicationUnderStudy
{
public:
  /**
   * Finds the application beside this program's own file, or at @p name if
   * that has a "/".
   * @throws InputError, with the names that there are, if there is none
   */
  ApplicationUnderStudy(const std::string &name,
                        const std::string &parameter_file,
                        unsigned int ranks);

  /// Every entry of the base file, "Section/Entry" and value, with
  /// @p settings. @throws InputError with the application's own line when it
  ///   refuses an entry or a value.
  std::map<std::string, std::string> entries(const Settings &settings) const;

  /// What --check prints. @throws InputError with the application's own line
  std::string plan(const Settings &settings) const;

  /// The command line of a run. Several ranks are started by mpirun.
  std::vector<std::string> command(const Settings &settings,
                                   const std::string &output_folder) const;

  const std::string &name() const;

  /// Version, git revision and a fingerprint of the program's file; starts it.
  std::string version() const;

  unsigned int ranks() const;

private:
  std::string ask(const Settings &settings, const std::string &option) const;

  std::string name_;
  std::string program_;
  std::string parameter_file_;
  unsigned int ranks_;
};

/// A number of 16 hexadecimal digits that differs for different texts
/// (FNV-1a).
std::string fingerprint(const std::string &text);
} // namespace contrecoup::study
