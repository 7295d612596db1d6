// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/collective.h>
#include <contrecoup/base/run_loop.h>
#include <contrecoup/io/checkpoint.h>
#include <contrecoup/io/history.h>
#include <contrecoup/io/run_description.h>

#include <map>
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
    OutputFolder(const std::string &path,
                 const std::string &application,
                 const std::map<std::string, std::string> &parameters,
                 Collective &collective);

    /// Makes the folder and tries that it takes files.
    /// @throws InputError when it does not.
    void create();

    /// Removes the folder again if create() made it and it is empty.
    void discard();

    /// Removes results of an earlier run.
    void start();

    /**
     * Finds the newest checkpoint and what it says of its run.
     * @param exempt entries that may differ, see require_same_scene()
     * @return the folder with the solver's files
     * @throws InputError when there is none, all are damaged, or it belongs
     *   to another application or scene.
     */
    std::string find_checkpoint(const std::vector<std::string> &exempt);

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

    /// Writes a small text file of this name. Collective.
    void write_text(const std::string &name, const std::string &text);

    /// The path of a file in this folder.
    std::string path(const std::string &name = "") const;

    /// The first and the newest row of the history.
    const std::vector<NamedValue> &first_values() const;
    const std::vector<NamedValue> &last_values() const;

  private:
    Collective &collective_;
    std::string path_;
    bool writes_;
    bool created_ = false;
    HistoryFile history_;
    HistoryFile probes_;
    Checkpoints checkpoints_;
    RunDescription run_; ///< kept up to date for checkpoints
    std::vector<NamedValue> last_values_;
  };
} // namespace io
} // namespace contrecoup
