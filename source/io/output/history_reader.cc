// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/readable_file.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/output/history_reader.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Parses a number; unknown values are written as nan.
    double number_in(const std::string &word,
                     const std::string &file,
                     const unsigned int line,
                     const std::string &column)
    {
      char *end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (word.empty() || *end != '\0')
        throw InputError("\"" + file + "\", line " + std::to_string(line) +
                         ": the column \"" + column + "\" has " +
                         quotation(word) + " instead of a number");
      return number;
    }
  } // namespace


  const std::vector<double> &HistoryTable::column(const std::string &name,
                                                  const std::string &file) const
  {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      throw InputError("\"" + file + "\" has no column \"" + name + "\"" +
                       suggestion(name, names));
    return columns[found - names.begin()];
  }


  HistoryTable read_history(const std::string &file)
  {
    std::istringstream input(read_text("the table", file));
    std::string line;
    if (!std::getline(input, line))
      throw InputError("cannot read the table \"" + file + "\": it is empty");
    HistoryTable table;
    for (const std::string &entry : split(line, ','))
      table.names.push_back(trim(entry.substr(0, entry.find('['))));
    table.columns.resize(table.names.size());
    for (unsigned int number = 2; std::getline(input, line); ++number)
    {
      const std::vector<std::string> row = split(line, ',');
      if (row.size() != table.names.size())
        throw InputError("\"" + file + "\", line " + std::to_string(number) +
                         ": the row has " + std::to_string(row.size()) +
                         " numbers for " + std::to_string(table.names.size()) +
                         " columns");
      for (std::size_t i = 0; i < row.size(); ++i)
        table.columns[i].push_back(
          number_in(row[i], file, number, table.names[i]));
    }
    return table;
  }
} // namespace io
} // namespace contrecoup
