// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/study/run_outputs.h>

#include <string>
#include <vector>

namespace contrecoup::study
{
/// Outputs that the user wants in the tables, an entry of Study/Columns.
struct ColumnRequest
{
  std::string address;         ///< see RunOutputs; "*" stands for any letters
  std::string label;           ///< title; empty: from the address
  bool may_be_missing = false; ///< in some runs

  bool is_pattern() const
  {
    return address.find('*') != std::string::npos;
  }
};

/// A column of the tables: one output of all runs.
struct Column
{
  std::string address;
  std::string title; ///< for readers
  std::string unit;  ///< empty: none
};

/**
 * Parses "ADDRESS; ADDRESS as TITLE; ADDRESS if any".
 * @throws InputError for a text that is no address and for two equal columns
 */
std::vector<ColumnRequest> parse_columns(const std::string &text);

/**
 * The columns that the finished runs have.
 * @param runs outputs of the finished runs
 * @param factors names that no column may have for a title of its own
 * @throws InputError, with the nearest address, for one that no run has, unless
 * it may be missing
 */
std::vector<Column> find_columns(const std::vector<ColumnRequest> &requests,
                                 const std::vector<const RunOutputs *> &runs,
                                 const std::vector<std::string> &factors = {});

/// Title with unit, "HIC15" or "lung load [Pa s]".
std::string title_with_unit(const Column &column);
} // namespace contrecoup::study
