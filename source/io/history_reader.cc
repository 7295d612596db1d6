// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/text.h>
#include <contrecoup/io/history_reader.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace contrecoup
{
namespace io
{
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
    std::ifstream input(file);
    std::string line;
    if (!std::getline(input, line))
      throw InputError("there is no table \"" + file + "\"");
    HistoryTable table;
    for (const std::string &entry : split(line, ','))
      table.names.push_back(trim(entry.substr(0, entry.find('['))));
    table.columns.resize(table.names.size());
    while (std::getline(input, line))
    {
      const std::vector<std::string> row = split(line, ',');
      if (row.size() != table.names.size())
        throw InputError("\"" + file + "\": a row has " +
                         std::to_string(row.size()) + " numbers for " +
                         std::to_string(table.names.size()) + " columns");
      for (std::size_t i = 0; i < row.size(); ++i)
        table.columns[i].push_back(std::strtod(row[i].c_str(), nullptr));
    }
    return table;
  }
} // namespace io
} // namespace contrecoup
