// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <string>
#include <vector>

namespace contrecoup::study
{
/// A number that a run left.
struct RunOutput
{
  double value = 0.; ///< NaN where the run could not compute it
  std::string unit;  ///< empty: none
  /// Whether it is of a load that the end of the run cuts off.
  bool is_lower_limit = false;
};

/**
 * The numbers in the output folder of a run, by their addresses:
 *   results.injury_hic15            path in summary.json
 *   blast/results.loads_chest_peak  the same in the folder of a scene's stage
 *   scene.json:distance             path in another JSON file
 *   blast/gauge_measures.csv:chest:peak    table, name of a row, column
 *   probes.csv:arrival:probe_1_pressure    feature of a column over time
 * The features of a column over time are first, last, largest, smallest, and
 * those of a Curve: peak, lowest, impulse, arrival.
 */
class RunOutputs
{
public:
  /// @param folder output folder of a finished run
  explicit RunOutputs(const std::string &folder);

  /// @throws InputError, with the nearest address, where the run has no such
  /// number
  RunOutput at(const std::string &address) const;

  /// Addresses of all numbers.
  const std::vector<std::string> &names() const
  {
    return names_;
  }

private:
  void add_files(const std::string &folder, const std::string &subfolder);
  void add_object(const nlohmann::json &node,
                  const std::string &begin,
                  const std::string &path,
                  const std::string &unit);
  void add_table(const std::string &file, const std::string &begin);
  void add(const std::string &address, double value, const std::string &unit);
  /// Marks outputs that grow with the load next to an output "cut off" of 1.
  void mark_lower_limits();

  std::map<std::string, RunOutput> values_;
  std::vector<std::string> names_;
};

/// Parts of an address.
struct OutputAddress
{
  std::string folder; ///< of the stage of a scene; empty: that of the run
  std::string file;   ///< name of the file
  std::string place;  ///< path in the file, or "ROW:COLUMN"
};

/// @throws InputError, naming @p where, for a text that is no address
OutputAddress parse_address(const std::string &text, const std::string &where);

/// Suggestion for an unknown address, the nearest of @p known in the file that
/// it names, else of all: "; did you mean ...?". Empty if none is near.
std::string suggest_address(const std::string &address,
                            const std::vector<std::string> &known);
} // namespace contrecoup::study
