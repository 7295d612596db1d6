// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/collective.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/study/outcome.h>
#include <contrecoup/study/run_record.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace contrecoup::study
{
namespace
{
  template <typename Type>
  Type
  member(const io::Json &object, const std::string &name, const Type &otherwise)
  {
    if (!object.is_object() || !object.contains(name) || object[name].is_null())
      return otherwise;
    try
    {
      return object[name].get<Type>();
    }
    catch (const io::Json::exception &)
    {
      // The member has another type.
      return otherwise;
    }
  }

  /// Whether all members of write_outcome() exist with their types.
  bool is_whole(const io::Json &text)
  {
    if (!text.is_object())
      return false;
    for (const char *const name : {"outcome", "reason"})
      if (!text.contains(name) || !text[name].is_string())
        return false;
    for (const char *const name : {"exit_code", "wall_seconds", "time_limit"})
      if (!text.contains(name) || !text[name].is_number())
        return false;
    return text.contains("identity");
  }

  constexpr const char *no_reason = "it gave no reason";

  bool contains(const std::string &text, const std::string &words)
  {
    return text.find(words) != std::string::npos;
  }

  /// Judges a process that exited with code 0. @param is_solver whether it left
  /// a summary with the number of retries
  void judge_finished(const RunRecord &record,
                      const bool is_solver,
                      Outcome &outcome)
  {
    if (record.status != "finished")
    {
      outcome.kind = "failed";
      outcome.reason = record.status.empty()
                         ? "it left neither summary.json nor manifest.json"
                         : "it ended with status \"" + record.status +
                             "\" before it was finished";
    }
    else if (record.retries > 0.)
    {
      outcome.kind = "retried";
      outcome.reason = std::to_string(static_cast<long long>(record.retries)) +
                       (record.retries == 1. ? " step was" : " steps were") +
                       " cut back";
    }
    else
      outcome.kind = is_solver ? "stable" : "finished";
  }

  std::string reason_of(const RunRecord &record, const std::string &error_file)
  {
    std::string reason = record.message;
    if (reason.empty())
    {
      std::ifstream input(error_file);
      const std::string text((std::istreambuf_iterator<char>(input)), {});
      reason = last_line(text);
    }
    return reason.empty() ? no_reason : reason;
  }
} // namespace

bool Outcome::is_usable() const
{
  return kind == "stable" || kind == "retried" || kind == "finished";
}

Outcome judge(const ProcessEnd &end,
              const bool timed_out,
              const std::string &folder,
              const std::string &error_file)
{
  const RunRecord record = read_record(folder);
  Outcome outcome;
  outcome.exit_code = end.exit_code;
  if (timed_out)
  {
    outcome.kind = "timed out";
    outcome.reason = "it was ended at the time limit";
  }
  else if (end.signal != 0)
  {
    outcome.kind = "failed";
    outcome.reason = "it crashed: " + std::string(strsignal(end.signal));
  }
  else if (end.exit_code == 0)
    judge_finished(record,
                   !std::isnan(record.retries) &&
                     std::filesystem::exists(folder + "/summary.json"),
                   outcome);
  else
  {
    outcome.kind = end.exit_code == 1   ? "refused"
                   : end.exit_code == 2 ? "unstable"
                                        : "failed";
    outcome.reason = reason_of(record, error_file);
    // With a full disk, not even the reason is written.
    if (outcome.kind == "failed" && outcome.reason == no_reason)
      outcome.reason += "; is the disk full?";
  }
  return outcome;
}

bool is_storage_failure(const Outcome &outcome)
{
  if (outcome.exit_code == 0)
    return false;
  for (const int error : {ENOSPC, EDQUOT, EFBIG, EROFS, EIO})
    if (contains(outcome.reason, std::strerror(error)))
      return true;
  if (outcome.exit_code != static_cast<int>(ExitCode::system_failed))
    return false;
  for (const char *words :
       {"is the disk full", "cannot write", "cannot be written"})
    if (contains(outcome.reason, words))
      return true;
  return false;
}

std::string identity(const std::string &application,
                     const std::string &version,
                     const unsigned int ranks,
                     const std::map<std::string, std::string> &entries)
{
  const io::Json text = {{"application", application},
                         {"version", version},
                         {"ranks", ranks},
                         {"entries", entries}};
  return text.dump(-1, ' ', false, io::Json::error_handler_t::replace);
}

void write_outcome(const std::string &file,
                   const Outcome &outcome,
                   const std::string &identity)
{
  const io::Json text = {{"format", io::formats::outcome.number},
                         {"outcome", outcome.kind},
                         {"reason", outcome.reason},
                         {"exit_code", outcome.exit_code},
                         {"wall_seconds", outcome.wall_seconds},
                         {"time_limit", outcome.time_limit},
                         {"identity", io::Json::parse(identity)}};
  io::write_file(file, [&](std::ostream &out) {
    out << text.dump(1, ' ', false, io::Json::error_handler_t::replace) << '\n';
  });
  // The outcome of hours of computing must survive a power failure.
  io::sync(file);
}

std::optional<Outcome> read_outcome(const std::string &file,
                                    const std::string &identity,
                                    const double time_limit)
{
  if (!std::filesystem::exists(file))
    return {};
  const io::Json text = io::read_json(file, io::formats::outcome);
  if (!is_whole(text))
  {
    show_line("the outcome \"" + file + "\" is damaged: its run is made again");
    return {};
  }
  if (text["identity"] != io::Json::parse(identity))
    return {};
  Outcome outcome;
  outcome.kind = member<std::string>(text, "outcome", "");
  outcome.reason = member<std::string>(text, "reason", "");
  outcome.exit_code = member(text, "exit_code", 0);
  outcome.wall_seconds = member(text, "wall_seconds", 0.);
  outcome.time_limit = member(text, "time_limit", 0.);
  const bool has_more_time =
    time_limit == 0. || time_limit > outcome.time_limit;
  if (outcome.kind.empty() || outcome.kind == "failed" ||
      (outcome.kind == "timed out" && has_more_time))
    return {};
  return outcome;
}
} // namespace contrecoup::study
