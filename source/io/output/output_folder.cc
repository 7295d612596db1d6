// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/processor_time.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/output/output_folder.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace contrecoup
{
namespace io
{
  namespace
  {
    namespace fs = std::filesystem;

    bool is_first_rank(const Collective &collective)
    {
      return dealii::Utilities::MPI::this_mpi_process(
               collective.communicator()) == 0;
    }

    /// Whether a .pvd collection can list a file.
    bool can_be_listed(const std::string &file)
    {
      const auto ending = fs::path(file).extension();
      return ending == ".vtu" || ending == ".pvtu" || ending == ".vti" ||
             ending == ".vtp";
    }

    /// The files that the first rank knows. Collective.
    std::vector<FieldFile> broadcast(const MPI_Comm communicator,
                                     const std::vector<FieldFile> &files)
    {
      std::string text;
      for (const FieldFile &file : files)
        text += file.part + "\n" + file.file + "\n";
      std::istringstream lines(broadcast_text(communicator, text, 0));
      std::vector<FieldFile> result;
      for (FieldFile file;
           std::getline(lines, file.part) && std::getline(lines, file.file);)
        result.push_back(file);
      return result;
    }

    double seconds_since(const std::chrono::steady_clock::time_point begin)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() -
                                           begin)
        .count();
    }

    NamedValue
    number(const std::string &name, const std::string &unit, const double value)
    {
      return {name, unit, value};
    }
  } // namespace

  OutputFolder::OutputFolder(
    const std::string &path,
    const std::string &application,
    const std::map<std::string, std::string> &parameters,
    const FileNames &names,
    Collective &collective)
    : collective_(collective)
    , path_(path)
    , names_(run_files() + names)
    , writes_(is_first_rank(collective))
    , history_(path + "/history.csv")
    , probes_(path + "/probes.csv")
    , checkpoints_(path + "/checkpoint", collective)
    , begin_(std::chrono::steady_clock::now())
    , begin_processor_(processor_seconds())
  {
    run_.application = application;
    run_.parameters = parameters;
  }

  bool OutputFolder::claim(const CommandLine &command)
  {
    constexpr unsigned int runs = 1, goes_on = 2;
    const auto may_run = [&]() {
      if (!writes_)
        return 0U;
      claim_ = std::make_unique<FolderClaim>(
        path_, run_.application, names_, make_run_input(run_.parameters));
      const auto can_resume = [&]() { return checkpoints_.has_complete(); };
      if (!claim_->may_proceed(command, can_resume))
        return 0U;
      return claim_->goes_on(command, can_resume()) ? runs + goes_on : runs;
    };
    const unsigned int flags = collective_.run_with_flags(may_run);
    resumes_ = (flags & goes_on) != 0;
    return (flags & runs) != 0;
  }

  void OutputFolder::start()
  {
    run_.fields.clear();
    collective_.run([&]() {
      if (writes_)
        claim_->begin();
    });
  }

  std::string
  OutputFolder::find_checkpoint(const std::vector<std::string> &exempt,
                                const double end_time)
  {
    const auto found = checkpoints_.newest();
    if (!found)
      throw InputError(
        "--resume: \"" + path_ + "\" holds no complete checkpoint" +
        (claim_ && claim_->manifest().status() == "finished"
           ? "; a finished run can go on to a later end if it was run with "
             "Output/Checkpoint at the end = true"
           : ""));
    const RunDescription earlier = from_text(found->run);
    if (earlier.application != run_.application)
      throw InputError("\"" + found->folder + "\" is a checkpoint of \"" +
                       earlier.application + "\", not of \"" +
                       run_.application + "\"");
    const std::string builds = earlier.build == this_build()
                                 ? ""
                                 : "the checkpoint was written by " +
                                     earlier.build + ", this is " +
                                     this_build();
    try
    {
      require_same_scene(earlier.parameters, run_.parameters, exempt);
    }
    catch (const InputError &error)
    {
      throw InputError(error.what() + (builds.empty() ? "" : "; " + builds));
    }
    if (earlier.state.time > (1. + 1e-9) * end_time)
      throw InputError("Time/End time = " + brief(end_time, 6) + " s: \"" +
                       found->folder + "\" is of " +
                       brief(earlier.state.time, 6) +
                       " s already; --resume needs a later end, --overwrite "
                       "begins anew");
    if (!builds.empty())
      show_line(builds + ": what follows may differ from what it would have "
                         "computed");
    const auto parameters = run_.parameters;
    run_ = earlier;
    run_.parameters = parameters;
    run_.starts.interruptions.emplace_back(run_.state.step, run_.state.time);
    const std::string end = "Time/End time";
    const auto before = earlier.parameters.find(end),
               now = parameters.find(end);
    if (before == earlier.parameters.end() || now == parameters.end() ||
        before->second != now->second)
      run_.starts.estimates.clear();
    return found->folder;
  }

  void OutputFolder::keep_estimates(std::vector<Assumption> &plan)
  {
    for (Assumption &item : plan)
      item.value =
        run_.starts.estimates.emplace(item.name, item.value).first->second;
  }

  void OutputFolder::begin_loop()
  {
    loop_begin_ = std::chrono::steady_clock::now();
  }

  RunStarts OutputFolder::starts() const
  {
    const MPI_Comm all = collective_.communicator();
    RunStarts result = run_.starts;
    result.wall_seconds += seconds_since(begin_);
    const double loop_seconds = loop_begin_ ? seconds_since(*loop_begin_) : 0.;
    result.loop_seconds += loop_seconds;
    result.loop_rank_seconds +=
      dealii::Utilities::MPI::n_mpi_processes(all) * loop_seconds;
    for (const auto &[name, seconds] : Timers::instance().largest(all))
      result.timers[name] += seconds;
    result.core_seconds +=
      dealii::Utilities::MPI::sum(processor_seconds() - begin_processor_, all);
    result.peak_memory = std::max(result.peak_memory, peak_memory(all));
    auto &warnings = result.warnings;
    for (const std::string &warning : Log::instance().warnings())
      if (std::find(warnings.begin(), warnings.end(), warning) ==
          warnings.end())
        warnings.push_back(warning);
    return result;
  }

  RunState OutputFolder::resume()
  {
    collective_.run(
      [&]() {
        if (!writes_)
          return;
        claim_->resume();
        history_.resume(run_.history_bytes);
        probes_.resume(run_.probes_bytes);
      },
      ExitCode::bad_input);
    return run_.state;
  }

  void OutputFolder::write_history(const RunState &state,
                                   const std::vector<NamedValue> &values)
  {
    if (run_.first_values.empty())
      run_.first_values = values;
    last_values_ = values;
    if (!writes_)
      return;
    std::vector<NamedValue> row = {
      number("step", "", static_cast<double>(state.step)),
      number("time", "s", state.time),
      number("step size", "s", state.step_size)};
    row.insert(row.end(), values.begin(), values.end());
    history_.add_row(row);
  }

  void OutputFolder::write_probes(const RunState &state,
                                  const std::vector<NamedValue> &values)
  {
    if (!writes_)
      return;
    std::vector<NamedValue> row = {number("time", "s", state.time)};
    row.insert(row.end(), values.begin(), values.end());
    probes_.add_row(row);
  }

  void OutputFolder::write_fields(const RunState &state, Simulation &simulation)
  {
    collective_.run([&]() {
      if (writes_)
        fs::create_directories(path("fields"));
    });
    std::vector<FieldFile> files;
    collective_.run([&]() {
      files = simulation.write_fields(
        path("fields"), static_cast<unsigned int>(state.field_index));
    });
    files = broadcast(collective_.communicator(), files);
    const std::size_t n_before = run_.fields.size();
    for (const FieldFile &file : files)
    {
      const std::string name = "fields/" + file.file;
      // Do not list an index twice after a failed attempt.
      const bool is_listed = std::any_of(
        run_.fields.begin(),
        run_.fields.begin() + static_cast<std::ptrdiff_t>(n_before),
        [&](const CollectionEntry &entry) { return entry.file == name; });
      if (can_be_listed(name) && !is_listed)
        run_.fields.push_back({state.time, file.part, name});
    }
    if (run_.fields.empty())
      return;
    collective_.run([&]() {
      if (!writes_)
        return;
      history_.flush();
      probes_.flush();
      write_collection(path("fields.pvd"), run_.fields);
    });
  }

  void OutputFolder::write_checkpoint(const RunState &state,
                                      Simulation &simulation)
  {
    flush();
    run_.state = state;
    run_.history_bytes = history_.size();
    run_.probes_bytes = probes_.size();
    RunDescription now = run_;
    now.starts = starts();
    checkpoints_.write(to_text(now), [&](const std::string &folder) {
      simulation.save(folder);
    });
  }

  void OutputFolder::flush()
  {
    collective_.run([&]() {
      history_.flush();
      probes_.flush();
    });
  }

  void OutputFolder::set_status(const std::string &status)
  {
    collective_.run([&]() {
      if (writes_)
        claim_->set_status(status);
    });
  }

  void OutputFolder::write_text(const std::string &name,
                                const std::string &text)
  {
    collective_.run([&]() {
      if (writes_)
        write_file(path(name), [&](std::ostream &out) { out << text; });
    });
  }

  FileNames OutputFolder::run_files()
  {
    const FileNames names = {{"parameters.prm",
                              "history.csv",
                              "probes.csv",
                              "fields.pvd",
                              "summary.json"},
                             {"log.txt"}};
    return names + Checkpoints::files("checkpoint");
  }

  std::string OutputFolder::path(const std::string &name) const
  {
    return name.empty() ? path_ : path_ + "/" + name;
  }

  const std::vector<NamedValue> &OutputFolder::first_values() const
  {
    return run_.first_values;
  }

  const std::vector<NamedValue> &OutputFolder::last_values() const
  {
    return last_values_;
  }
} // namespace io
} // namespace contrecoup
