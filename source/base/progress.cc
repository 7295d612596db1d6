// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/log.h>
#include <contrecoup/base/progress.h>
#include <contrecoup/base/text.h>

namespace contrecoup
{
Progress::Progress(const double start_time, const double end_time)
  : begin_(Clock::now())
  , last_(begin_)
  , start_time_(start_time)
  , end_time_(end_time)
{}

void Progress::step(const std::uint64_t number,
                    const double time,
                    const double step_size,
                    const double updates)
{
  recent_updates_ += updates;
  const bool terminal = Log::instance().on_terminal();
  const auto now = Clock::now();
  const double waited = std::chrono::duration<double>(now - last_).count();
  if (waited < (terminal ? 0.2 : 10.))
    return;

  const double wall = std::chrono::duration<double>(now - begin_).count();
  const double done = time - start_time_;
  const double left = done > 0. ? wall * (end_time_ - time) / done : 1e300;
  const std::string text = "step " + std::to_string(number) + "  time " +
                           brief(time, 5) + " s  step size " +
                           brief(step_size, 3) + " s  " +
                           brief(recent_updates_ / waited / 1e6, 3) +
                           " million updates/s  " + duration(left) + " left";
  if (terminal)
    Log::instance().status(text);
  else
    log_line(text);
  last_ = now;
  recent_updates_ = 0.;
}
} // namespace contrecoup
