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
  /// Least time between two lines on a screen that is no terminal [s].
  constexpr double screen_interval = 15.;

  /// Time from a log line to the forecast for the next line [s].
  constexpr double log_forecast = 9.;
  /// Least time between two forecasts [s].
  constexpr double forecast_interval = 2.;

  double seconds(const Clock::duration duration)
  {
    return std::chrono::duration<double>(duration).count();
  }
} // namespace

Progress::Progress(const double begin_time, const double end_time)
  : last_step_(Clock::now())
  , last_line_(last_step_)
  , last_quarter_(last_step_)
  , end_time_(end_time)
  , begin_time_(begin_time)
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
  const std::string what = hand_over_ ? " left of the first stage" : " left";
  return std::isnan(left) ? "time" + what + " not known yet"
                          : duration(left) + what;
}

std::string Progress::brief_state(const std::uint64_t number,
                                  const double time) const
{
  return brief(100. * time / end_time_, 2) + " % of the simulated time, step " +
         std::to_string(number) + ", " + time_left(time);
}

void Progress::show_quarter(const std::uint64_t number, const double time)
{
  const double part = (time - begin_time_) / (end_time_ - begin_time_);
  const auto quarters = static_cast<unsigned int>(4. * part);
  const Log &log = Log::instance();
  if (quarters <= quarters_ || quarters > 3 || log.is_verbose())
    return;
  quarters_ = quarters;
  const auto now = Clock::now();
  if (seconds(now - last_quarter_) < screen_interval ||
      (log.is_in_part() && quarters != 2))
    return;
  last_quarter_ = now;
  Log::instance().progress(brief_state(number, time));
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
  Log &log = Log::instance();
  if (!log.on_terminal())
    show_quarter(number, time);
  const double waited = seconds(now - last_line_);
  if (waited < (log.on_terminal() ? terminal_interval : log_interval))
    return;

  const std::string text = "step " + std::to_string(number) + "  time " +
                           brief(time, 5) + " s  step size " +
                           brief(step_size, 3) + " s  " +
                           brief(recent_updates_ / waited / 1e6, 3) +
                           " million updates/s  " + time_left(time);
  if (log.on_terminal())
    log.status(log.is_verbose() ? text : brief_state(number, time));
  else
    log_line(text);
  last_line_ = now;
  recent_updates_ = 0.;
}
} // namespace contrecoup
