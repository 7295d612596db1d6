// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/study_result.h>

namespace contrecoup::study
{
/// The table as CSV: one row for each variant.
std::string to_csv(const StudyParameters &parameters,
                   const StudyResult &result);

/// The table in Markdown, with what is to be learned from it.
std::string to_markdown(const StudyParameters &parameters,
                        const StudyResult &result);

/// All of it for plot.py study.
std::string to_json(const StudyParameters &parameters,
                    const StudyResult &result);

/// The recommendation in words, for screen and table; several lines.
std::vector<std::string> recommendation(const StudyParameters &parameters,
                                        const StudyResult &result);

/**
 * A parameter file that runs a variant on its own.
 * @param used content of the variant's parameters.prm: every entry
 * @param base entries of the base file; those of subsection "Output" are
 *   taken from here, since a study has its own
 */
std::string recommended_file(const StudyParameters &parameters,
                             const StudyResult &result,
                             const std::string &used_file,
                             const std::map<std::string, std::string> &base);
} // namespace contrecoup::study
