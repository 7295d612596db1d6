// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/study/report.h>

#include <cmath>
#include <sstream>

namespace contrecoup::study
{
namespace
{
  std::string describe(const StudyParameters &parameters, const ResultRow &row)
  {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < parameters.factors.size(); ++i)
      parts.push_back(parameters.factors[i].name + " = " +
                      row.variant.labels[i]);
    return join(parts, ", ");
  }

  std::string words_on_cost(const StudyParameters &parameters,
                            const ResultRow &row)
  {
    return parameters.cost == "memory" ? bytes(row.cost)
           : parameters.cost == "updates"
             ? brief(row.cost, 3) + " updates"
             : brief(row.cost, 3) + " " + parameters.cost;
  }

  /// Finished row with the smallest error, or nullptr.
  const ResultRow *most_accurate(const StudyResult &result)
  {
    const ResultRow *best = nullptr;
    for (const ResultRow &row : result.rows)
      if (std::isfinite(row.error) && (!best || row.error < best->error))
        best = &row;
    return best;
  }

  std::string
  value_without_study(const std::string &path,
                      const std::string &value,
                      const std::map<std::string, std::string> &base)
  {
    const bool of_study = path.compare(0, 7, "Output/") == 0;
    const auto found = base.find(path);
    return of_study && found != base.end() ? found->second : value;
  }
} // namespace

std::vector<std::string> recommendation(const StudyParameters &parameters,
                                        const StudyResult &result)
{
  const ResultRow *best = most_accurate(result);
  if (parameters.error.required_error() <= 0. || best == nullptr)
    return {};
  const std::string goal = "the " + parameters.error.title(result.columns) +
                           parameters.error.against() + " at or below " +
                           brief(parameters.error.required_error(), 3);
  if (!result.recommended)
    return {"No variant keeps " + goal + ". The most accurate, " +
            describe(parameters, *best) + ", has " + brief(best->error, 3) +
            " for " + words_on_cost(parameters, *best) + "."};
  const ResultRow &row = result.rows[*result.recommended];
  return {"The cheapest way to keep " + goal + " is " +
          describe(parameters, row) + ": error " + brief(row.error, 3) +
          " for " + words_on_cost(parameters, row) +
          ". It is in recommended.prm."};
}

std::string recommended_file(const StudyParameters &parameters,
                             const StudyResult &result,
                             const std::string &used_file,
                             const std::map<std::string, std::string> &base)
{
  std::ostringstream out;
  for (const std::string &line : recommendation(parameters, result))
    for (const std::string &part : wrap(line, 76))
      out << "# " << part << '\n';
  out << "# Run it with: " << parameters.application << " recommended.prm\n\n";
  std::vector<std::string> sections;
  bool begun = false;
  for (const std::string &line : split(io::read_file(used_file), '\n'))
  {
    const std::string indent(2 * sections.size(), ' ');
    begun = begun || (!line.empty() && line[0] != '#');
    if (!begun)
      continue;
    if (line.compare(0, 11, "subsection ") == 0)
    {
      out << indent << line << '\n';
      sections.push_back(line.substr(11));
    }
    else if (line == "end")
    {
      sections.pop_back();
      out << indent.substr(2) << line << '\n';
    }
    else if (line.compare(0, 4, "set ") == 0)
    {
      const std::size_t equals = line.find('=');
      const std::string entry = trim(line.substr(4, equals - 4));
      const std::string path = join(sections, "/") + "/" + entry;
      out << indent << "set " << entry << " = "
          << value_without_study(path, trim(line.substr(equals + 1)), base)
          << '\n';
    }
    else
      out << line << '\n';
  }
  return out.str();
}
} // namespace contrecoup::study
