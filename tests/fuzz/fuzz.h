// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace contrecoup::fuzz
{
/// A reader of files and a small file that it accepts.
struct Reader
{
  std::string name;

  /// Path of the file below a folder of its own; its ending may matter.
  std::string file;

  /// Writes a valid input into a folder, other files that it needs as well.
  std::function<void(const std::string &folder)> prepare;

  /// Reads the file and uses what it found. May throw InputError, nothing
  /// else: a damaged file is neither the numerics' nor the machine's fault.
  std::function<void(const std::string &path)> read;

  /// Another version of the file, as mutate() makes, which is taken if empty.
  std::function<std::string(const std::string &content, std::uint64_t number)>
    mutate = {};

  /// How many versions there are besides the file itself; 0: any number.
  std::uint64_t versions = 0;
};

/**
 * Another version of a file, the same for the same number: some bytes or words
 * changed, left out, repeated or cut off. Number 0 is the file itself.
 */
std::string mutate(const std::string &content, std::uint64_t number);

/**
 * Feeds mutated files to readers, each in a process of its own, and reports
 * how many there were and those that crash it, take longer than a minute, ask
 * for more than two gigabytes, or throw what they must not; such files are kept
 * in fuzz_failures.
 *
 * Arguments: [--inputs N] (10,000), [--seconds S] for each reader at most but
 * [--least N] inputs (100), [--reader NAME] alone, [--replay FILE] through that
 * one.
 *
 * @return exit code: 0 when there were no such files, else 1
 */
int run(int argc, char **argv, const std::vector<Reader> &readers);
} // namespace contrecoup::fuzz
