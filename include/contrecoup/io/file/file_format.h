// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace contrecoup
{
namespace io
{
  /// JSON with its members in the order in which they were written.
  using Json = nlohmann::ordered_json;

  /// A kind of files with the number of its format. The number grows with each
  /// change that programs of before would misread; what is only added leaves
  /// it.
  struct FileFormat
  {
    const char *name;
    int number;
  };

  /// All formats that Contrecoup writes, but for report.json, which the drawing
  /// program writes (applications/plot/readers/formats.py).
  namespace formats
  {
    constexpr FileFormat loads{"loads", 1};       ///< loads.h5
    constexpr FileFormat profile{"profile", 1};   ///< of Output/Profile file
    constexpr FileFormat summary{"summary", 1};   ///< summary.json
    constexpr FileFormat scene{"scene", 1};       ///< scene.json
    constexpr FileFormat study{"study", 1};       ///< study.json
    constexpr FileFormat manifest{"manifest", 1}; ///< manifest.json
    constexpr FileFormat stage{"stage", 1};       ///< STAGE.stage.json
    constexpr FileFormat outcome{"outcome", 1};   ///< outcome.json of a variant
    constexpr FileFormat forecast{"forecast", 1}; ///< CONTRECOUP_CHECK_FILE
    /// run.json and the solvers' files, which this number alone can read.
    constexpr FileFormat checkpoint{"checkpoint", 22};
  } // namespace formats

  /// "contrecoup loads 1", the attribute "format" of files other than JSON.
  std::string format_text(const FileFormat &format);

  /// @param found attribute of @p file, see format_text()
  /// @throws InputError when it is of another kind or a newer number
  void require_format(const FileFormat &format,
                      const std::string &found,
                      const std::string &file);

  /// Content of a JSON file; null if it is missing, discarded if damaged.
  /// @throws InputError when its member "format" is newer
  Json read_json(const std::string &file, const FileFormat &format);
} // namespace io
} // namespace contrecoup
