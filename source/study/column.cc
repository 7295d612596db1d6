// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/study/column.h>

#include <boost/algorithm/string/predicate.hpp>
#include <fnmatch.h>

#include <algorithm>
#include <set>

namespace contrecoup::study
{
namespace
{
  /// Removes @p end from @p text; returns whether it was there.
  bool take_end(std::string &text, const std::string &end)
  {
    if (text.size() <= end.size() ||
        text.compare(text.size() - end.size(), end.size(), end) != 0)
      return false;
    text = trim(text.substr(0, text.size() - end.size()));
    return true;
  }

  ColumnRequest parse_column(std::string text)
  {
    ColumnRequest request;
    request.may_be_missing = take_end(text, " if any");
    const std::size_t as = text.find(" as ");
    request.address = trim(text.substr(0, as));
    if (as != std::string::npos)
      request.label = trim(text.substr(as + 4));
    if (request.is_pattern() && !request.label.empty())
      throw InputError("Study/Columns: \"" + request.address +
                       "\" names several outputs, which cannot all be called "
                       "\"" +
                       request.label + "\"");
    parse_address(request.address, "Study/Columns");
    return request;
  }

  /// Title of an output: the end of its address.
  std::string title_of(const std::string &address, const bool with_folder)
  {
    const OutputAddress parts = parse_address(address, "");
    std::string title = parts.place;
    const std::size_t colon = title.rfind(':');
    if (colon == std::string::npos)
    {
      const std::size_t dot = title.rfind('.');
      // Members of an assumption say nothing without its name.
      const bool is_deep = std::count(title.begin(), title.end(), '.') > 1;
      title = title.substr(is_deep                    ? title.find('.') + 1
                           : dot == std::string::npos ? 0
                                                      : dot + 1);
    }
    else
      take_end(title, ":value");
    for (char &letter : title)
      if (letter == '_' || letter == ':' || letter == '.')
        letter = ' ';
    return (with_folder && !parts.folder.empty() ? parts.folder + " " : "") +
           title;
  }

  /// Titles that no other column and no factor has: with its folder, or the
  /// whole address, where a shorter one is taken.
  void name(const std::vector<ColumnRequest> &requests,
            const std::vector<std::string> &factors,
            std::vector<Column> &columns)
  {
    for (Column &column : columns)
    {
      const auto is_taken = [&](const bool with_folder) {
        const std::string title = title_of(column.address, with_folder);
        return std::any_of(factors.begin(),
                           factors.end(),
                           [&](const std::string &factor) {
                             return boost::algorithm::iequals(factor, title);
                           }) ||
               std::any_of(
                 columns.begin(), columns.end(), [&](const Column &other) {
                   return &other != &column &&
                          title_of(other.address, with_folder) == title;
                 });
      };
      column.title = !is_taken(false)  ? title_of(column.address, false)
                     : !is_taken(true) ? title_of(column.address, true)
                                       : column.address;
      for (const ColumnRequest &request : requests)
        if (request.address == column.address && !request.label.empty())
          column.title = request.label;
    }
  }

  bool has(const RunOutputs &run, const std::string &address)
  {
    const auto &names = run.names();
    return std::find(names.begin(), names.end(), address) != names.end();
  }

  [[noreturn]] void refuse(const ColumnRequest &request,
                           const std::vector<const RunOutputs *> &runs)
  {
    std::vector<std::string> known;
    for (const RunOutputs *run : runs)
      known.insert(known.end(), run->names().begin(), run->names().end());
    throw InputError(
      "Study/Columns: no run has " +
      std::string(request.is_pattern() ? "an output like" : "the output") +
      " \"" + request.address + "\"" + suggest_address(request.address, known) +
      "; outputs.csv in the output folder lists what a run has");
  }

  /// Addresses of the outputs that are asked for.
  std::vector<std::string> matching(const ColumnRequest &request,
                                    const std::vector<const RunOutputs *> &runs)
  {
    std::vector<std::string> found;
    for (const RunOutputs *run : runs)
      if (!request.is_pattern())
      {
        if (found.empty() && has(*run, request.address))
          found.push_back(request.address);
      }
      else
        for (const std::string &address : run->names())
          if (fnmatch(request.address.c_str(), address.c_str(), 0) == 0)
            found.push_back(address);
    return found;
  }
} // namespace

std::vector<ColumnRequest> parse_columns(const std::string &text)
{
  std::vector<ColumnRequest> requests;
  std::set<std::string> known;
  for (const std::string &part : split(text, ';'))
    if (!part.empty())
    {
      requests.push_back(parse_column(part));
      if (!known.insert(requests.back().address).second)
        throw InputError("Study/Columns names \"" + requests.back().address +
                         "\" twice");
    }
  return requests;
}

std::vector<Column> find_columns(const std::vector<ColumnRequest> &requests,
                                 const std::vector<const RunOutputs *> &runs,
                                 const std::vector<std::string> &factors)
{
  std::vector<Column> columns;
  std::set<std::string> taken;
  for (const ColumnRequest &request : requests)
  {
    std::vector<std::string> found = matching(request, runs);
    if (found.empty() && !runs.empty() && !request.may_be_missing)
      refuse(request, runs);
    if (found.empty() && !request.is_pattern())
      found.push_back(request.address);
    for (const std::string &address : found)
      if (taken.insert(address).second)
        columns.push_back({address, "", ""});
  }
  for (Column &column : columns)
    for (const RunOutputs *run : runs)
      if (column.unit.empty() && has(*run, column.address))
        column.unit = run->at(column.address).unit;
  name(requests, factors, columns);
  return columns;
}

std::string title_with_unit(const Column &column)
{
  return column.title + (column.unit.empty() ? "" : " [" + column.unit + "]");
}
} // namespace contrecoup::study
