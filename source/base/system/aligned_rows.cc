// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/aligned_rows.h>

#include <algorithm>

namespace contrecoup
{
std::vector<std::string>
aligned_rows(const std::vector<std::vector<std::string>> &rows)
{
  std::vector<std::size_t> width;
  for (const auto &row : rows)
  {
    width.resize(std::max(width.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i)
      width[i] = std::max(width[i], row[i].size());
  }
  std::vector<std::string> lines;
  for (const auto &row : rows)
  {
    std::string line = " ";
    for (std::size_t i = 0; i < row.size(); ++i)
      line +=
        " " + row[i] +
        (i + 1 < row.size() ? std::string(width[i] - row[i].size() + 1, ' ')
                            : "");
    lines.push_back(line);
  }
  return lines;
}
} // namespace contrecoup
