// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/aligned_rows.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/log_words.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/run/plan_table.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace io
{
  namespace
  {
    using Row = std::vector<std::string>;

    std::string number(const double value, const std::string &unit)
    {
      if (!std::isfinite(value))
        return "unknown";
      return brief(value, 3) + (unit == "-" ? "" : " " + unit);
    }

    std::string limit(const Assumption &item)
    {
      if (std::isnan(item.limit))
        return "";
      return (item.is_lower_limit ? "at least " : "at most ") +
             number(item.limit, item.unit);
    }

    Row cost_row(const std::string &name, const CostEstimate &cost)
    {
      const auto whole = [](const double value) {
        return value < 1e15 ? std::to_string(std::llround(value))
                            : brief(value);
      };
      const auto told = [](const double value, const std::string &text) {
        return value > 0. ? text : "";
      };
      return {name,
              told(cost.cells, whole(cost.cells)),
              told(cost.unknowns, whole(cost.unknowns)),
              told(cost.steps, brief(cost.steps, 3)),
              told(cost.memory, bytes(cost.memory)),
              told(cost.seconds, duration(cost.seconds)),
              told(cost.output, bytes(cost.output))};
    }

    /// Cells of a row of cost_lines(): name, cells, unknowns, steps, memory,
    /// wall time and output.
    constexpr std::size_t first_figure = 1, first_of_all = 4;

    /// "memory and output are", of the cells from @p begin on that @p row
    /// leaves blank; empty: none.
    std::string
    blanks_of(const Row &heading, const Row &row, const std::size_t begin)
    {
      Row blanks;
      for (std::size_t i = begin; i < row.size(); ++i)
        if (row[i].empty())
          blanks.push_back(heading[i]);
      if (blanks.empty())
        return "";
      const std::string last = blanks.back();
      blanks.pop_back();
      return join(blanks, ", ") + (blanks.empty() ? "" : " and ") + last +
             (blanks.empty() && last.back() != 's' ? " is" : " are");
    }

    const std::string mark = "WARNING: ", estimated = "estimated at",
                      measured = "measured at";

    /// Beginning of what is said of an item, @p kind: estimated or measured.
    std::string told(const Assumption &item, const std::string &kind)
    {
      return item.name + ": " + item.quantity + " is " + kind + " ";
    }

    std::string sentence(const Assumption &item, const std::string &kind)
    {
      return told(item, kind) + number(item.value, item.unit) +
             ", allowed is " + limit(item);
    }

    /// Without "WARNING: ".
    std::string warning(const Assumption &item, const std::string &kind)
    {
      return sentence(item, kind) +
             (item.entry.empty() ? "" : "; see " + item.entry);
    }
  } // namespace

  CostEstimate
  total_of(const std::vector<std::pair<std::string, CostEstimate>> &costs)
  {
    CostEstimate total;
    for (const auto &[name, cost] : costs)
    {
      total.cells += cost.cells;
      total.unknowns += cost.unknowns;
      total.steps += cost.steps;
      total.memory = std::max(total.memory, cost.memory);
      total.seconds += cost.seconds;
      total.output += cost.output;
    }
    for (const auto &[name, cost] : costs)
    {
      // The drawing, of known time alone, needs less memory than others.
      const bool has_mesh =
        cost.cells > 0. || cost.steps > 0. || !(cost.seconds > 0.);
      if (has_mesh && !(cost.memory > 0.))
        total.memory = 0.;
      if (has_mesh && !(cost.cells > 0.))
        total.cells = total.unknowns = 0.;
      if (has_mesh && cost.unknowns > 0. && !(cost.steps > 0.))
        total.steps = 0.;
    }
    for (double CostEstimate::*figure :
         {&CostEstimate::seconds, &CostEstimate::output})
      for (const auto &[name, cost] : costs)
        if (!(cost.*figure > 0.))
          total.*figure = 0.;
    return total;
  }

  std::vector<std::string>
  cost_lines(const std::vector<std::pair<std::string, CostEstimate>> &costs)
  {
    const Row heading = {
      "", "cells", "unknowns", "steps", "memory", "wall time", "output"};
    std::vector<Row> rows = {heading};
    Row gaps, lacking;
    for (const auto &[name, cost] : costs)
    {
      const Row row = cost_row(name, cost);
      rows.push_back(row);
      const std::string blanks = blanks_of(heading, row, first_figure);
      if (cost.gap.empty() || blanks.empty())
        continue;
      gaps.push_back("  " + name + ": " + blanks + " unknown: " + cost.gap);
      if (!blanks_of(heading, row, first_of_all).empty())
        lacking.push_back(name);
    }
    CostEstimate total = total_of(costs);
    total.cells = total.unknowns = total.steps = 0.;
    if (costs.size() > 1)
    {
      const Row row = cost_row("all", total);
      rows.push_back(row);
      const std::string blanks = blanks_of(heading, row, first_of_all);
      double known = 0.;
      for (const auto &[name, cost] : costs)
        known += cost.seconds;
      if (!blanks.empty() && !lacking.empty())
        gaps.push_back("  all: " + blanks + " unknown with those of " +
                       join(lacking, ", ") +
                       (known > 0. && !(total.seconds > 0.)
                          ? "; the others take " + duration(known)
                          : ""));
    }
    Row lines = aligned_rows(rows);
    lines.insert(lines.end(), gaps.begin(), gaps.end());
    return lines;
  }

  std::string counted_ranks(const unsigned int number)
  {
    return std::to_string(number) + (number == 1 ? " rank" : " ranks");
  }

  const Assumption *find_assumption(const std::vector<Assumption> &items,
                                    const std::string &name)
  {
    for (const Assumption &item : items)
      if (item.name == name)
        return &item;
    return nullptr;
  }

  std::optional<bool> holds(const Assumption &audited,
                            const Assumption *planned)
  {
    if (std::isfinite(audited.value) && !std::isnan(audited.limit))
      return !audited.fails();
    return planned != nullptr && std::isfinite(planned->value) &&
               planned->fails()
             ? std::optional(false)
             : std::nullopt;
  }

  std::vector<std::string> plan_lines(const std::vector<Assumption> &plan)
  {
    if (plan.empty())
      return {};
    std::vector<Row> rows = {
      {"plan", "what is done", "estimate", "limit", "decided by"}};
    for (const Assumption &item : plan)
      rows.push_back({item.name,
                      item.decision,
                      number(item.value, item.unit),
                      limit(item),
                      item.entry});
    std::vector<std::string> lines = aligned_rows(rows);
    for (const Assumption &item : plan)
      if (item.fails() && std::isfinite(item.value))
        lines.push_back(mark + warning(item, estimated));
    return lines;
  }

  std::vector<std::string> audit_lines(const std::vector<Assumption> &plan,
                                       const std::vector<Assumption> &audit)
  {
    if (audit.empty())
      return {};
    std::vector<Row> rows = {
      {"audit", "what was measured", "estimate", "measured", "limit", "holds"}};
    for (const Assumption &item : audit)
    {
      const Assumption *planned = find_assumption(plan, item.name);
      const std::optional<bool> keeps = holds(item, planned);
      rows.push_back({item.name,
                      item.quantity,
                      planned ? number(planned->value, item.unit) : "",
                      number(item.value, item.unit),
                      limit(item),
                      !keeps   ? ""
                      : *keeps ? "yes"
                               : "NO"});
    }
    std::vector<std::string> lines = aligned_rows(rows);
    for (const Assumption &item : audit)
    {
      // The plan has warned of it before, unless it is far worse.
      constexpr double far_worse = 1.5;
      const Assumption *planned = find_assumption(plan, item.name);
      if (item.fails() && (planned == nullptr || !planned->fails() ||
                           std::abs(item.value - item.limit) >
                             far_worse * std::abs(planned->value - item.limit)))
        lines.push_back(mark + warning(item, measured));
    }
    return lines;
  }

  void replace_estimates(const std::vector<Assumption> &plan,
                         const std::vector<Assumption> &audit,
                         std::vector<std::string> &warnings)
  {
    for (const Assumption &item : plan)
    {
      const Assumption *found = find_assumption(audit, item.name);
      // An item that the run cannot measure has its estimate in the audit.
      if (found == nullptr || !std::isfinite(found->value) ||
          std::isnan(found->limit) ||
          (found->is_estimate &&
           number(found->value, found->unit) == number(item.value, item.unit)))
        continue;
      const std::string begin = LogWords::of(told(item, estimated));
      const auto old = std::find_if(
        warnings.begin(), warnings.end(), [&](const std::string &text) {
          return begins_with(text, begin);
        });
      if (old == warnings.end())
        continue;
      const std::string now = LogWords::of(warning(*found, measured));
      if (!found->fails())
        Log::instance().take_back(
          sentence(*found, measured) +
          ": what the plan warned of did not come true");
      if (found->fails() &&
          std::find(warnings.begin(), warnings.end(), now) == warnings.end())
        *old = now;
      else
        warnings.erase(old);
    }
  }
} // namespace io
} // namespace contrecoup
