// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/study_result.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup::study
{
/// Warnings by the run that has them.
using WarningsByRun =
  std::vector<std::pair<std::string, std::vector<std::string>>>;

/// "RUN; RUN: WARNING", each warning once.
/// @param most number of lines, of which the last one counts the others
std::vector<std::string> told_warnings(const WarningsByRun &runs,
                                       std::size_t most);

/// The results as CSV, one row per variant.
std::string to_csv(const StudyParameters &parameters,
                   const StudyResult &result);

/// The results as Markdown, with conclusions.
std::string to_markdown(const StudyParameters &parameters,
                        const StudyResult &result);

/// The results as JSON, for plot.py study.
std::string to_json(const StudyParameters &parameters,
                    const StudyResult &result);

/// Table of all outputs of the run in @p folder: "output,value,unit".
std::string outputs_csv(const std::string &folder);

/// The recommendation in words for screen and table, several lines.
std::vector<std::string> recommendation(const StudyParameters &parameters,
                                        const StudyResult &result);

/**
 * A parameter file that runs a variant without the study.
 * @param used_file content of the variant's parameters.prm: all entries
 * @param base entries of the parameter file of the study; source of subsection
 * "Output", which the study overrides
 */
std::string recommended_file(const StudyParameters &parameters,
                             const StudyResult &result,
                             const std::string &used_file,
                             const std::map<std::string, std::string> &base);
} // namespace contrecoup::study
