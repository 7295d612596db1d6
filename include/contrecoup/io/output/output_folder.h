// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/run_loop.h>
#include <contrecoup/base/system/collective.h>
#include <contrecoup/io/output/checkpoint.h>
#include <contrecoup/io/output/folder_claim.h>
#include <contrecoup/io/output/history.h>
#include <contrecoup/io/run/run_description.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /// The output folder of a run: history, probes, fields, checkpoints. All
  /// functions except getters are collective; the first rank writes.
  class OutputFolder : public RunOutput
  {
  public:
    /// @param parameters entries as used, stored in checkpoints
    /// @param names of the files that the solver writes into the folder
    OutputFolder(const std::string &path,
                 const std::string &application,
                 const std::map<std::string, std::string> &parameters,
                 const FileNames &names,
                 Collective &collective);

    /// Claims the folder for the lifetime of this object, see FolderClaim.
    /// Returns false if there is nothing to do.
    /// @throws InputError when the folder cannot be claimed
    bool claim(const CommandLine &command);

    /// Whether the claimed folder holds a run to continue, see
    /// FolderClaim::goes_on().
    bool resumes() const
    {
      return resumes_;
    }

    /// Removes the files of an earlier run.
    void start();

    /**
     * Finds the newest checkpoint and reads its run.json.
     * @param exempt entries that may differ, see require_same_scene()
     * @param end_time of the resumed run [s], not before the checkpoint
     * @return folder with the solver's files
     * @throws InputError when there is none, all are damaged, or it belongs to
     * another application or scene
     */
    std::string find_checkpoint(const std::vector<std::string> &exempt,
                                double end_time);

    /// Gives @p plan the estimates that an earlier start had before its first
    /// step, if it had the same end; else keeps those of @p plan.
    void keep_estimates(std::vector<Assumption> &plan);

    /// From here on time counts as that of the time loop.
    void begin_loop();

    /// All starts until now, this one included. Collective.
    RunStarts starts() const;

    /// Truncates histories and collections to their state at the checkpoint of
    /// find_checkpoint(). Returns the state of the run.
    RunState resume();

    void write_history(const RunState &state,
                       const std::vector<NamedValue> &values) override;
    void write_probes(const RunState &state,
                      const std::vector<NamedValue> &values) override;
    void write_fields(const RunState &state, Simulation &simulation) override;
    void write_checkpoint(const RunState &state,
                          Simulation &simulation) override;

    /// Writes pending rows.
    void flush();

    /// Sets the status of the run, see Manifest.
    void set_status(const std::string &status);

    /// Writes a small text file. Collective.
    void write_text(const std::string &name, const std::string &text);

    /// Files of every run, without those of the solver.
    static FileNames run_files();

    /// Patterns of the names of all files of this run.
    const FileNames &names() const
    {
      return names_;
    }

    /// Path of a file in this folder.
    std::string path(const std::string &name = "") const;

    /// First and latest row of the history.
    const std::vector<NamedValue> &first_values() const;
    const std::vector<NamedValue> &last_values() const;

  private:
    Collective &collective_;
    std::string path_;
    FileNames names_;
    bool writes_;
    std::unique_ptr<FolderClaim> claim_; ///< on the writing rank
    HistoryFile history_;
    HistoryFile probes_;
    Checkpoints checkpoints_;
    bool resumes_ = false;
    RunDescription run_; ///< current state, for checkpoints
    std::vector<NamedValue> last_values_;
    std::chrono::steady_clock::time_point begin_; ///< of this start
    std::optional<std::chrono::steady_clock::time_point> loop_begin_;
    double begin_processor_; ///< of this process [s]
  };
} // namespace io
} // namespace contrecoup
