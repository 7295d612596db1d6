// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/study/factor.h>
#include <contrecoup/study/table.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace contrecoup::study
{
namespace
{
  std::vector<std::string> cells(const std::string &line)
  {
    std::vector<std::string> parts = {""};
    bool is_quoted = false;
    for (const char letter : line)
      if (letter == '"')
        is_quoted = !is_quoted;
      else if (letter == ',' && !is_quoted)
        parts.emplace_back();
      else
        parts.back() += letter;
    for (std::string &part : parts)
      part = trim(part);
    return parts;
  }
} // namespace

bool TableHead::is_history() const
{
  // The number of the step may precede the time.
  return names.front() == "time" || (names.size() > 1 && names[1] == "time");
}

std::string Table::row_name(const std::size_t row) const
{
  std::vector<std::string> texts;
  for (const std::string &cell : rows[row])
  {
    if (!std::isnan(leading_number(cell)) || cell == "nan" || cell.empty())
      break;
    texts.push_back(cell);
  }
  return texts.empty() ? rows[row].front() : join(texts, " ");
}

TableHead read_head(const std::string &file)
{
  require_readable("the table", file);
  std::ifstream input(file);
  std::string line;
  if (!std::getline(input, line) || trim(line).empty())
    throw InputError("cannot read the table \"" + file + "\": it is empty");
  TableHead head;
  for (const std::string &title : cells(line))
  {
    const std::size_t bracket = title.find(" [");
    const bool has_unit = bracket != std::string::npos && title.back() == ']';
    head.names.push_back(has_unit ? title.substr(0, bracket) : title);
    head.units.push_back(
      has_unit ? title.substr(bracket + 2, title.size() - bracket - 3) : "");
  }
  return head;
}

Table read_table(const std::string &file)
{
  Table table;
  static_cast<TableHead &>(table) = read_head(file);
  std::istringstream input(read_text("the table", file));
  std::string line;
  std::getline(input, line);
  while (std::getline(input, line))
  {
    table.rows.push_back(cells(line));
    if (table.rows.back().size() != table.names.size())
      throw InputError(
        "\"" + file + "\", line " + std::to_string(table.rows.size() + 1) +
        ": the row has " + std::to_string(table.rows.back().size()) +
        " cells for " + std::to_string(table.names.size()) + " columns");
  }
  return table;
}
} // namespace contrecoup::study
