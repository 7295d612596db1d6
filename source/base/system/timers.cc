// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/timers.h>

#include <boost/serialization/map.hpp>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace contrecoup
{
Timers &Timers::instance()
{
  static Timers timers;
  return timers;
}

void Timers::reset()
{
  // Keep the entries: a scope of a caller may refer to one.
  for (auto &item : entries_)
    item.second = Entry();
}

Timers::Entry &Timers::entry(const std::string &name)
{
  return entries_[name];
}

std::map<std::string, double> Timers::largest(const MPI_Comm communicator) const
{
  std::map<std::string, double> own;
  for (const auto &[name, entry] : entries_)
    if (entry.calls > 0)
      own[name] = entry.seconds;
  std::map<std::string, double> result;
  for (const auto &of_rank :
       dealii::Utilities::MPI::all_gather(communicator, own))
    for (const auto &[name, seconds] : of_rank)
      result[name] = std::max(result[name], seconds);
  return result;
}

std::string Timers::table(const MPI_Comm communicator, const double total) const
{
  const auto seconds = largest(communicator);
  using Row = std::pair<std::string, double>;
  std::vector<Row> rows(seconds.begin(), seconds.end());
  std::sort(rows.begin(), rows.end(), [](const Row &a, const Row &b) {
    return a.second > b.second;
  });
  std::string text;
  for (const Row &row : rows)
  {
    char line[120];
    std::snprintf(line,
                  sizeof(line),
                  "%s  %-28s %10.3f s %6.1f %%",
                  text.empty() ? "" : "\n",
                  row.first.c_str(),
                  row.second,
                  total > 0. ? 100. * row.second / total : 0.);
    text += line;
  }
  return text;
}

TimerScope::TimerScope(const std::string &name)
  : entry_(Timers::instance().entry(name))
  , begin_(std::chrono::steady_clock::now())
{}

TimerScope::~TimerScope()
{
  entry_.seconds +=
    std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_)
      .count();
  ++entry_.calls;
}
} // namespace contrecoup
