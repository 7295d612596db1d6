// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/io/file/name_patterns.h>
#include <contrecoup/io/output/manifest.h>
#include <contrecoup/study/variant_runner.h>

#include <filesystem>
#include <set>
#include <thread>

namespace contrecoup::study
{
namespace
{
  /// Time for a run to exit after a termination signal [s].
  constexpr double grace_period = 10.;
} // namespace

std::string Task::run_folder() const
{
  return folder + "/run";
}

std::string Task::outcome_file() const
{
  return folder + "/outcome.json";
}

VariantRunner::VariantRunner(const ApplicationUnderStudy &application,
                             const unsigned int cores,
                             const double time_limit)
  : application_(application)
  , slots_(std::max(1U, cores / application.ranks()))
  , time_limit_(time_limit)
{}

bool VariantRunner::run(std::vector<Task> &tasks,
                        const std::function<void(const Task &)> &report)
{
  // Equal variants share a folder and run once.
  std::set<std::string> taken;
  auto next = tasks.begin();
  while (next != tasks.end() || !running_.empty())
  {
    if (SignalGuard::stop_signal() != 0)
    {
      for (Running &running : running_)
        running.process->terminate(grace_period);
      running_.clear();
      return false;
    }
    while (next != tasks.end() && running_.size() < slots_)
    {
      if (taken.insert(next->identity).second && !next->outcome)
        start(*next);
      ++next;
    }
    poll_running(report);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

void VariantRunner::start(Task &task)
{
  std::filesystem::create_directories(task.folder);
  // Files of an earlier attempt must not be mistaken for those of this one.
  io::remove_files(task.folder, {"outcome.json", "screen.txt", "errors.txt"});
  if (std::filesystem::exists(task.run_folder()))
    io::Manifest(task.run_folder()).remove_all();
  const auto command =
    application_.command(task.variant.settings, task.run_folder());
  running_.push_back(
    {&task,
     std::make_unique<ChildProcess>(
       command, task.folder + "/screen.txt", task.folder + "/errors.txt")});
}

void VariantRunner::poll_running(
  const std::function<void(const Task &)> &report)
{
  for (auto running = running_.begin(); running != running_.end();)
  {
    ChildProcess &process = *running->process;
    const double seconds = process.seconds();
    const auto end = process.poll();
    if (!end && time_limit_ > 0. && seconds > time_limit_)
    {
      running->timed_out = true;
      process.terminate(grace_period);
    }
    if (!process.poll())
    {
      ++running;
      continue;
    }
    Task &task = *running->task;
    Outcome outcome = judge(*process.poll(),
                            running->timed_out,
                            task.run_folder(),
                            task.folder + "/errors.txt");
    outcome.wall_seconds = seconds;
    outcome.time_limit = time_limit_;
    if (is_storage_failure(outcome))
      throw SystemError("the run in \"" + task.folder +
                        "\" could not write its files: " + outcome.reason);
    write_outcome(task.outcome_file(), outcome, task.identity);
    task.outcome = outcome;
    running = running_.erase(running);
    report(task);
  }
}
} // namespace contrecoup::study
