// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/course_forecast.h>

#include <algorithm>
#include <cmath>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Spans of each stage in which what it costs is compared.
    constexpr unsigned int n_spans = 40;

    /// That of the same dimension, if it has a course.
    const TrialStage *find_stage(const Trial &trial, const TrialStage &like)
    {
      for (const TrialStage &stage : trial.stages)
        if (stage.dimension == like.dimension && !stage.course.empty())
          return &stage;
      return nullptr;
    }

    /// Cells over the steps of a stage until each end of its spans.
    std::vector<double> cells_until(const ExpectedCourse &course,
                                    const double begin,
                                    const double end)
    {
      std::vector<double> cells;
      for (unsigned int i = 0; i <= n_spans; ++i)
        cells.push_back(
          cost_until(course, begin + (end - begin) * i / n_spans));
      return cells;
    }
  } // namespace

  ExpectedCourse forecast_course(const Trial &before,
                                 const Trial &last,
                                 const std::vector<double> &seconds)
  {
    ExpectedCourse course;
    double spent = 0.;
    for (std::size_t stage = 0; stage < last.stages.size(); ++stage)
    {
      const ExpectedCourse &steps = last.stages[stage].course;
      if (steps.empty())
        continue;
      const double begin = steps.front().first, end = steps.back().first;
      const TrialStage *const coarse = find_stage(before, last.stages[stage]);
      const auto cells = cells_until(steps, begin, end);
      const auto coarse_cells =
        cells_until(coarse ? coarse->course : steps, begin, end);
      const double exponent =
        coarse ? double(last.levels) / (before.levels - last.levels) : 0.;
      std::vector<double> parts;
      double sum = 0.;
      for (unsigned int i = 0; i < n_spans; ++i)
      {
        const double now = cells[i + 1] - cells[i];
        const double then = coarse_cells[i + 1] - coarse_cells[i];
        parts.push_back(
          now * (now > 0. && then > 0. ? std::pow(now / then, exponent) : 1.));
        sum += parts.back();
      }
      course.emplace_back(begin, spent);
      for (unsigned int i = 0; i < n_spans && sum > 0.; ++i)
      {
        spent += parts[i] / sum * seconds[stage];
        course.emplace_back(begin + (end - begin) * (i + 1) / n_spans, spent);
      }
    }
    return course;
  }
} // namespace io
} // namespace contrecoup
