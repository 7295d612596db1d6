// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/base/run_loop.h>
#include <contrecoup/io/checkpoint.h>
#include <contrecoup/io/folder_claim.h>
#include <contrecoup/io/history.h>
#include <contrecoup/io/run_description.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace contrecoup
{
namespace io
{
  /**
   * The output folder of a run: history, probes, fields, checkpoints. Every
   * function but the getters is collective; the first rank writes.
   */
  class OutputFolder : public RunOutput
  {
  public:
    /// @param parameters the entries as used, to be kept in checkpoints
    /// @param names of files that the solver writes into the folder
    OutputFolder(const std::string &path,
                 const std::string &application,
                 const std::map<std::string, std::string> &parameters,
                 const FileNames &names,
                 Collective &collective);

    /// Takes the folder for this run, see FolderClaim, until this object ends.
    /// Returns false when there is nothing to do in it.
    /// @throws InputError when it is not to be had.
    bool claim(const CommandLine &command);

    /// Removes what an earlier run left.
    void start();

    /**
     * Finds the newest checkpoint and what it says of its run.
     * @param exempt entries that may differ, see require_same_scene()
     * @param end_time of the run that goes on [s], not before the checkpoint
     * @return the folder with the solver's files
     * @throws InputError when there is none, all are damaged, or it belongs
     *   to another application or scene.
     */
    std::string find_checkpoint(const std::vector<std::string> &exempt,
                                double end_time);

    /// Puts histories and collections back to where the checkpoint was
    /// written that find_checkpoint() found. Returns the state of the run.
    RunState resume();

    void write_history(const RunState &state,
                       const std::vector<NamedValue> &values) override;
    void write_probes(const RunState &state,
                      const std::vector<NamedValue> &values) override;
    void write_fields(const RunState &state, Simulation &simulation) override;
    void write_checkpoint(const RunState &state,
                          Simulation &simulation) override;

    /// Writes what is still held in memory.
    void flush();

    /// Says how the run stands, see Manifest.
    void set_status(const std::string &status);

    /// Writes a small text file of this name. Collective.
    void write_text(const std::string &name, const std::string &text);

    /// What any run writes, besides the files of its solver.
    static FileNames run_files();

    /// The path of a file in this folder.
    std::string path(const std::string &name = "") const;

    /// The first and the newest row of the history.
    const std::vector<NamedValue> &first_values() const;
    const std::vector<NamedValue> &last_values() const;

  private:
    Collective &collective_;
    std::string path_;
    FileNames names_;
    bool writes_;
    std::unique_ptr<FolderClaim> claim_; ///< of the rank that writes
    HistoryFile history_;
    HistoryFile probes_;
    Checkpoints checkpoints_;
    RunDescription run_; ///< kept up to date for checkpoints
    std::vector<NamedValue> last_values_;
  };
} // namespace io
} // namespace contrecoup
