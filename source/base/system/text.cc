// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace contrecoup
{
namespace
{
  std::string lower(std::string text)
  {
    for (char &letter : text)
      letter =
        static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return text;
  }
} // namespace

bool begins_with(const std::string &text, const std::string &beginning)
{
  return text.compare(0, beginning.size(), beginning) == 0;
}


std::string trim(const std::string &text)
{
  const char *white = " \t\r\n";
  const auto first = text.find_first_not_of(white);
  if (first == std::string::npos)
    return "";
  return text.substr(first, text.find_last_not_of(white) - first + 1);
}

std::vector<std::string> split(const std::string &text, const char separator)
{
  std::vector<std::string> parts;
  if (trim(text).empty())
    return parts;
  std::size_t begin = 0;
  while (true)
  {
    const std::size_t end = text.find(separator, begin);
    parts.push_back(trim(text.substr(begin, end - begin)));
    if (end == std::string::npos)
      return parts;
    begin = end + 1;
  }
}

std::string join(const std::vector<std::string> &parts,
                 const std::string &separator)
{
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i > 0 ? separator : "") + parts[i];
  return text;
}

std::string one_line(const std::string &text)
{
  std::istringstream words(text);
  std::vector<std::string> parts;
  for (std::string word; words >> word;)
    parts.push_back(word);
  return join(parts, " ");
}

std::vector<std::string> wrap(const std::string &text, const std::size_t width)
{
  std::istringstream words(text);
  std::vector<std::string> lines;
  for (std::string word; words >> word;)
    if (lines.empty() || lines.back().size() + 1 + word.size() > width)
      lines.push_back(word);
    else
      lines.back() += " " + word;
  return lines;
}

std::size_t edit_distance(const std::string &first, const std::string &second)
{
  const std::string a = lower(first), b = lower(second);
  std::vector<std::vector<std::size_t>> d(
    a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j)
    {
      if (i == 0 || j == 0)
      {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t exchange = (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min(
        {d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + exchange});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string nearest(const std::string &name,
                    const std::vector<std::string> &candidates)
{
  // Longer texts are no names, and their edit distance is expensive.
  constexpr std::size_t longest_name = 100;
  // Fewer letters begin too many names.
  constexpr std::size_t shortest_beginning = 3;

  std::string best;
  if (name.size() > longest_name)
    return best;
  const bool may_begin = name.size() >= shortest_beginning;
  bool is_beginning = false;
  std::size_t smallest = std::max<std::size_t>(2, name.size() / 2) + 1;
  for (const std::string &candidate : candidates)
  {
    const bool begins = may_begin && begins_with(lower(candidate), lower(name));
    const std::size_t distance = edit_distance(name, candidate);
    if (begins == is_beginning ? distance < smallest : begins)
    {
      is_beginning = begins;
      smallest = distance;
      best = candidate;
    }
  }
  return best;
}

std::string suggestion(const std::string &name,
                       const std::vector<std::string> &candidates)
{
  constexpr std::size_t short_list = 12;

  std::string text;
  const std::string best = nearest(name, candidates);
  if (!best.empty())
    text += "; did you mean \"" + best + "\"?";
  if (!candidates.empty() && candidates.size() <= short_list)
    text += (best.empty() ? "; known are: " : " Known are: ") +
            join(candidates, ", ");
  return text;
}

std::string exact(const double value)
{
  char buffer[40];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), value).ptr;
  return {buffer, end};
}

std::string brief(const double value, const int digits)
{
  // The C library prints "-nan" for sqrt(-1).
  if (std::isnan(value))
    return "not a number";
  if (std::isinf(value))
    return value > 0. ? "infinite" : "negative and infinite";
  char buffer[64];
  // The sum has no negative zero.
  std::snprintf(buffer, sizeof(buffer), "%.*g", digits, value + 0.);
  return buffer;
}

std::string duration(const double seconds)
{
  char buffer[64];
  if (!std::isfinite(seconds) || seconds > 1e9)
    return "very long";
  const auto whole = static_cast<long long>(std::llround(seconds));
  if (seconds < 10.)
    std::snprintf(buffer, sizeof(buffer), "%.2g s", seconds);
  else if (whole < 60)
    std::snprintf(buffer, sizeof(buffer), "%lld s", whole);
  else if (whole < 3600)
    std::snprintf(
      buffer, sizeof(buffer), "%lld min %02lld s", whole / 60, whole % 60);
  else
    std::snprintf(buffer,
                  sizeof(buffer),
                  "%lld h %02lld min",
                  whole / 3600,
                  whole / 60 % 60);
  return buffer;
}

std::string bytes(double count)
{
  const char *units[] = {"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
  unsigned int unit = 0;
  while (count >= 1024. && unit < 5)
  {
    count /= 1024.;
    ++unit;
  }
  return brief(count, 3 + (count >= 1000.)) + " " + units[unit];
}
} // namespace contrecoup
