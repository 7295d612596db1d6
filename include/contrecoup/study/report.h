// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/study_result.h>

namespace contrecoup::study
{
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
