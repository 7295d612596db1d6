// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/io/output/history_reader.h>
#include <contrecoup/study/curve.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::study
{
namespace
{
  /// Linear interpolation of a curve.
  double at(const Curve &curve, const double time)
  {
    const auto after =
      std::lower_bound(curve.times.begin(), curve.times.end(), time);
    if (after == curve.times.begin())
      return curve.values.front();
    if (after == curve.times.end())
      return curve.values.back();
    const auto i = static_cast<std::size_t>(after - curve.times.begin());
    const double part =
      (time - curve.times[i - 1]) / (curve.times[i] - curve.times[i - 1]);
    return curve.values[i - 1] + part * (curve.values[i] - curve.values[i - 1]);
  }

  /// Integral of |f| over a step, for linear f from a to b.
  double absolute_area(const double a, const double b, const double step)
  {
    if (a * b >= 0.)
      return 0.5 * step * std::abs(a + b);
    return 0.5 * step * (a * a + b * b) / (std::abs(a) + std::abs(b));
  }
} // namespace

Curve read_curve(const std::string &file, const std::string &name)
{
  const io::HistoryTable table = io::read_history(file);
  const Curve curve{table.column("time", file), table.column(name, file)};
  if (curve.times.size() < 2)
    throw InputError("\"" + file + "\" has fewer than two rows");
  return curve;
}

double peak(const Curve &curve)
{
  return *std::max_element(curve.values.begin(), curve.values.end()) -
         curve.values.front();
}

double lowest(const Curve &curve)
{
  return *std::min_element(curve.values.begin(), curve.values.end()) -
         curve.values.front();
}

double impulse(const Curve &curve)
{
  double sum = 0., largest = 0.;
  for (std::size_t i = 1; i < curve.times.size(); ++i)
  {
    sum +=
      (curve.times[i] - curve.times[i - 1]) *
      (0.5 * (curve.values[i] + curve.values[i - 1]) - curve.values.front());
    largest = std::max(largest, sum);
  }
  return largest;
}

double arrival(const Curve &curve)
{
  const double half = curve.values.front() + 0.5 * peak(curve);
  for (std::size_t i = 1; i < curve.times.size(); ++i)
    if (curve.values[i] > half || curve.values[i] == half)
    {
      const double rise = curve.values[i] - curve.values[i - 1];
      const double part = rise > 0. ? (half - curve.values[i - 1]) / rise : 0.;
      return curve.times[i - 1] + part * (curve.times[i] - curve.times[i - 1]);
    }
  return curve.times.back();
}

Curve averaged(const Curve &curve, const double width)
{
  const std::vector<double> &times = curve.times;
  std::vector<double> integrals(times.size(), 0.);
  for (std::size_t i = 1; i < times.size(); ++i)
    integrals[i] = integrals[i - 1] + 0.5 * (times[i] - times[i - 1]) *
                                        (curve.values[i] + curve.values[i - 1]);
  const auto integral_to = [&](const double time) {
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    const auto i = static_cast<std::size_t>(
      std::max<std::ptrdiff_t>(after - times.begin() - 1, 0));
    return integrals[i] +
           0.5 * (time - times[i]) * (curve.values[i] + at(curve, time));
  };
  Curve result = curve;
  for (std::size_t i = 0; i < times.size(); ++i)
  {
    const double begin = std::max(times.front(), times[i] - 0.5 * width);
    const double end = std::min(times.back(), times[i] + 0.5 * width);
    if (end > begin)
      result.values[i] =
        (integral_to(end) - integral_to(begin)) / (end - begin);
  }
  return result;
}

double relative_difference(const Curve &curve, const Curve &reference)
{
  const double end = std::min(curve.times.back(), reference.times.back());
  std::vector<double> times;
  for (const Curve *one : {&curve, &reference})
    for (const double time : one->times)
      if (time < end)
        times.push_back(time);
  times.push_back(end);
  std::sort(times.begin(), times.end());
  double difference = 0., size = 0.;
  for (std::size_t i = 1; i < times.size(); ++i)
  {
    const double step = times[i] - times[i - 1];
    const double first = at(reference, times[i - 1]);
    const double second = at(reference, times[i]);
    difference += absolute_area(
      at(curve, times[i - 1]) - first, at(curve, times[i]) - second, step);
    size += absolute_area(first - reference.values.front(),
                          second - reference.values.front(),
                          step);
  }
  return difference / size;
}
} // namespace contrecoup::study
