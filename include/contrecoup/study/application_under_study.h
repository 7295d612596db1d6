// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/child_process.h>
#include <contrecoup/study/factor.h>

#include <map>

namespace contrecoup::study
{
/// Entries of an application, by "Section/Entry".
struct EntryList
{
  std::map<std::string, std::string> values;
  std::map<std::string, std::string> units; ///< of those that have one
};

/// The application of a study, with the parameter file of its variants.
class ApplicationUnderStudy
{
public:
  /**
   * Finds the application in the folder of this program, or at @p name if the
   * name contains a "/".
   * @throws InputError with the nearest name if there is none
   */
  ApplicationUnderStudy(const std::string &name,
                        const std::string &parameter_file,
                        unsigned int ranks);

  /// All entries of the application with their values after the parameter file
  /// and @p settings; starts the program.
  /// @throws InputError with the application's message when it refuses an
  /// entry or a value
  EntryList entries(const Settings &settings) const;

  /// The application's message about a command that failed.
  /// @throws SystemError if a signal ended it, or the system failed
  std::string refusal(const ProcessText &text) const;

  /// Command line of a run, with mpirun for several ranks.
  std::vector<std::string> command(const Settings &settings,
                                   const std::string &output_folder) const;

  const std::string &name() const;

  /// Version, git revision and a fingerprint of the program file; starts the
  /// program.
  std::string version() const;

  unsigned int ranks() const;

private:
  std::string name_;
  std::string program_;
  std::string parameter_file_;
  unsigned int ranks_;
};

/// Hash of a text (FNV-1a), 16 hexadecimal digits.
std::string fingerprint(const std::string &text);
} // namespace contrecoup::study
