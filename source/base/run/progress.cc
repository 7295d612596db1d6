// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/run/progress.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>

#include <cmath>
#include <utility>

namespace contrecoup
{
namespace
{
  using Clock = std::chrono::steady_clock;

  /// Intervals between lines in a log, and on a terminal [s].
  constexpr double log_interval = 10., terminal_interval = 0.2;

  /// Time from a log line to the forecast for the next line [s].
  constexpr double log_forecast = 9.;
  /// Least time between two forecasts [s].
  constexpr double forecast_interval = 2.;

  double seconds(const Clock::duration duration)
  {
    return std::chrono::duration<double>(duration).count();
  }
} // namespace

Progress::Progress(const double end_time)
  : last_step_(Clock::now())
  , last_line_(last_step_)
  , end_time_(end_time)
{}

bool Progress::wants_forecast() const
{
  const auto now = Clock::now();
  return seconds(now - last_forecast_) >= forecast_interval &&
         (Log::instance().on_terminal() ||
          seconds(now - last_line_) >= log_forecast);
}

void Progress::set_forecast(WorkForecast forecast,
                            const std::optional<double> hand_over)
{
  remaining_.set_forecast(std::move(forecast));
  hand_over_ = hand_over;
  last_forecast_ = Clock::now();
}

void Progress::restart()
{
  remaining_.restart();
  hand_over_.reset();
  last_forecast_ = Clock::time_point();
  last_step_ = Clock::now();
}

std::string Progress::time_left(const double time) const
{
  const double left = remaining_.left(time, hand_over_.value_or(end_time_));
  const std::string what = hand_over_ ? " left of this stage" : " left";
  return std::isnan(left) ? "time" + what + " not known yet"
                          : duration(left) + what;
}

void Progress::step(const std::uint64_t number,
                    const double time,
                    const double step_size,
                    const double updates)
{
  const auto now = Clock::now();
  remaining_.add(step_size, updates, seconds(now - last_step_));
  last_step_ = now;
  recent_updates_ += updates;
  const bool terminal = Log::instance().on_terminal();
  const double waited = seconds(now - last_line_);
  if (waited < (terminal ? terminal_interval : log_interval))
    return;

  const std::string text = "step " + std::to_string(number) + "  time " +
                           brief(time, 5) + " s  step size " +
                           brief(step_size, 3) + " s  " +
                           brief(recent_updates_ / waited / 1e6, 3) +
                           " million updates/s  " + time_left(time);
  if (terminal)
    Log::instance().status(text);
  else
    log_line(text);
  last_line_ = now;
  recent_updates_ = 0.;
}
} // namespace contrecoup
