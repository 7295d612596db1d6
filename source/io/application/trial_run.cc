// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/run/run_loop.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/memory.h>
#include <contrecoup/base/system/processor_time.h>
#include <contrecoup/base/system/signals.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/io/application/trial_run.h>
#include <contrecoup/io/output/load_series.h>
#include <contrecoup/io/output/output_folder.h>
#include <contrecoup/io/output/pictures.h>
#include <contrecoup/io/output/summary.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

namespace contrecoup
{
namespace io
{
  namespace
  {
    /// Wraps a simulation and measures the cost of its functions; saves
    /// nothing.
    class MeasuredSimulation : public Simulation
    {
    public:
      MeasuredSimulation(Simulation &inner,
                         Trial &trial,
                         const double longest,
                         const MPI_Comm communicator)
        : inner_(inner)
        , trial_(trial)
        , end_(processor_seconds() + longest)
        , communicator_(communicator)
        , last_(processor_seconds())
      {}

      /// Whether advance() threw because the trial exceeded its time.
      bool is_too_long() const
      {
        return is_too_long_;
      }

      CostEstimate estimate() override
      {
        return inner_.estimate();
      }
      void setup() override
      {
        inner_.setup();
        note_size();
        trial_.setup_seconds += lap();
      }
      void restore(const std::string &) override
      {}
      void save(const std::string &) override
      {}
      double time() const override
      {
        return inner_.time();
      }
      StepReport advance(const double largest_step) override
      {
        is_too_long_ =
          dealii::Utilities::MPI::max(last_ > end_ ? 1 : 0, communicator_) > 0;
        if (is_too_long_)
          throw SystemError("the trial takes too long");
        const unsigned int dimension = inner_.dimension();
        if (trial_.stages.empty() ||
            trial_.stages.back().dimension != dimension)
          trial_.stages.push_back({dimension, inner_.time()});
        const StepReport report = inner_.advance(largest_step);
        TrialStage &stage = trial_.stages.back();
        if (!(stage.steps > 0.))
          stage.first_step = report.step_size;
        stage.steps += 1.;
        const double cells = note_size();
        stage.cell_steps += cells;
        if (cells > stage.largest_cells)
          trial_.time_of_largest = inner_.time();
        stage.largest_cells = std::max(stage.largest_cells, cells);
        stage.seconds += lap();
        return report;
      }
      bool adapt() override
      {
        TrialStage &stage = trial_.stages.back();
        const bool changed = inner_.adapt();
        const bool handed_over = inner_.dimension() != stage.dimension;
        (handed_over ? trial_.setup_seconds : stage.seconds) += lap();
        return changed;
      }
      std::vector<NamedValue> history() override
      {
        return inner_.history();
      }
      std::vector<NamedValue> probes() override
      {
        return inner_.probes();
      }
      std::vector<FieldFile> write_fields(const std::string &folder,
                                          const unsigned int index) override
      {
        if (!trial_.stages.empty())
          trial_.stages.back().seconds += lap();
        const auto files = inner_.write_fields(folder, index);
        trial_.output_seconds += lap();
        return files;
      }
      std::vector<NamedValue> errors() override
      {
        return {};
      }
      std::pair<std::uint64_t, std::uint64_t> size() const override
      {
        return inner_.size();
      }

    private:
      /// Processor time since the last call [s].
      double lap()
      {
        const double before = last_;
        last_ = processor_seconds();
        return last_ - before;
      }

      double note_size()
      {
        const auto size = inner_.size();
        const auto cells = static_cast<double>(size.first);
        trial_.unknowns_per_cell =
          std::max(trial_.unknowns_per_cell,
                   static_cast<double>(size.second) / std::max(1., cells));
        return cells;
      }

      Simulation &inner_;
      Trial &trial_;
      const double end_; ///< processor time at which the trial stops [s]
      MPI_Comm communicator_;
      double last_;
      bool is_too_long_ = false;
    };

    /// Suppresses all output of a trial.
    class Silence
    {
    public:
      Silence()
      {
        Log::instance().set_active(false);
      }
      ~Silence()
      {
        Log::instance().set_active(
          dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);
      }
    };

    double bytes_in(const std::string &path)
    {
      namespace fs = std::filesystem;
      double sum = 0.;
      std::error_code ignored;
      for (const auto &entry : fs::recursive_directory_iterator(path, ignored))
        if (entry.is_regular_file(ignored))
          sum += static_cast<double>(entry.file_size(ignored));
      return sum;
    }

    bool ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    /// Number of the trial that counts the bytes of a file.
    double Trial::*kind_of(const std::string &file)
    {
      const bool is_field = file.rfind("fields", 0) == 0;
      if (file.rfind("checkpoint", 0) == 0)
        return &Trial::checkpoint_bytes;
      if (is_field && (ends_with(file, ".vti") || ends_with(file, ".csv")))
        return &Trial::plane_bytes;
      if (ends_with(file, ".vtp") || file == "loads.h5")
        return &Trial::surface_bytes;
      if (is_field)
        return &Trial::volume_bytes;
      return ends_with(file, ".csv") || file == "loads.xdmf"
               ? &Trial::table_bytes
               : &Trial::other_bytes;
    }

    /// Counts what a trial wrote.
    /// @param more number of field outputs of the run per one of the trial
    void count_bytes(const std::string &folder, const double more, Trial &trial)
    {
      namespace fs = std::filesystem;
      const double all = 1. / std::max(trial.part, Trial::least_part);
      std::error_code ignored;
      for (const auto &entry :
           fs::recursive_directory_iterator(folder, ignored))
      {
        const std::string file =
          entry.path().lexically_relative(folder).string();
        double Trial::*const kind = kind_of(file);
        if (!entry.is_regular_file(ignored))
          continue;
        const bool is_once =
          kind == &Trial::other_bytes || kind == &Trial::checkpoint_bytes;
        const double factor = file.rfind("fields", 0) == 0 ? more * all
                              : is_once                    ? 1.
                                                           : all;
        trial.*kind += factor * static_cast<double>(entry.file_size(ignored));
      }
    }

    /// Combines measurements of all ranks, and extrapolates the missing
    /// simulated time and the omitted field outputs.
    void complete(Trial &trial, const double outputs, const MPI_Comm all)
    {
      const double part = std::max(trial.part, Trial::least_part);
      for (TrialStage &stage : trial.stages)
        stage.seconds = dealii::Utilities::MPI::max(stage.seconds, all);
      for (double *seconds : {&trial.setup_seconds, &trial.output_seconds})
        *seconds = dealii::Utilities::MPI::max(*seconds, all);
      trial.peak_memory = peak_memory(all);
      trial.field_seconds = trial.output_seconds;
      trial.seconds = trial.setup_seconds + trial.output_seconds;
      for (const TrialStage &stage : trial.stages)
        trial.seconds += stage.seconds;
      trial.output_seconds *= outputs / part;
      if (!trial.stages.empty())
        for (double *number : {&trial.stages.back().steps,
                               &trial.stages.back().cell_steps,
                               &trial.stages.back().seconds})
          *number /= part;
    }

    /// Leaves out checkpoints on the way and stops, and all but a few field
    /// outputs; returns the ratio of wanted to remaining outputs.
    double prepare(dealii::ParameterHandler &prm)
    {
      TimeParameters time;
      time.parse_parameters(prm);
      std::map<std::string, std::string> values = {
        {"Time/Minutes in this run", "0"},
        {"Time/Steps in this run", "0"},
        {"Output/Checkpoint every steps", "0"},
        {"Output/Checkpoint every minutes", "0"},
        {"Output/Checkpoint at the end", "false"}};
      constexpr double few = 4.;
      const double wanted = time.fields_interval > 0.
                              ? std::floor(time.end_time / time.fields_interval)
                              : 0.;
      if (wanted > few)
        values["Output/Fields interval"] = exact(time.end_time / few);
      std::vector<Assignment> assignments;
      for (const auto &[entry, value] : values)
        assignments.push_back(parse_override(entry + "=" + value));
      apply_assignments(assignments, prm);
      return wanted > few ? (wanted + 1.) / (few + 1.) : 1.;
    }

    /// Writes a checkpoint, and pending results with it, and the description of
    /// recorded loads.
    void save_results(const std::string &folder,
                      const RunState &state,
                      Simulation &simulation,
                      OutputFolder &output,
                      Collective &collective)
    {
      collective.run([&]() { output.write_checkpoint(state, simulation); });
      const std::string loads = folder + "/loads.h5";
      collective.run([&]() {
        if (dealii::Utilities::MPI::this_mpi_process(
              collective.communicator()) == 0 &&
            std::filesystem::exists(loads))
          write_load_series(loads);
      });
    }

    /// Writes what a run writes at its end; returns the size of its log [byte].
    double finish(const std::string &application,
                  const RunState &state,
                  Simulation &simulation,
                  OutputFolder &output)
    {
      // The log has about two thirds of the text of the summary.
      constexpr double log_part = 0.65;
      simulation.finish(output.path());
      Summary summary;
      summary.application = application;
      summary.status = "finished";
      summary.state = state;
      summary.first_values = output.first_values();
      summary.last_values = output.last_values();
      summary.plan = simulation.plan();
      describe(simulation, summary);
      const std::string text = to_text(summary);
      output.write_text("summary.json", text);
      return log_part * static_cast<double>(text.size());
    }

    /// Runs @p simulation in @p folder.
    void run_in(const std::string &folder,
                const ApplicationDescription &description,
                dealii::ParameterHandler &prm,
                Simulation &simulation,
                Trial &trial,
                const double longest,
                Collective &collective)
    {
      const CostEstimate rough = simulation.estimate();
      trial.memory_per_cell = rough.memory / std::max(1., rough.cells);
      trial.known_cells = rough.cells;
      MeasuredSimulation measured(
        simulation, trial, longest, collective.communicator());
      simulation.set_output_folder(folder);
      measured.setup();
      OutputFolder output(folder,
                          description.name,
                          parameter_values(prm),
                          description.files ? description.files(prm)
                                            : FileNames(),
                          collective);
      output.claim({});
      output.start();
      output.write_text("parameters.prm", parameter_text(prm, false));
      TimeParameters time;
      time.parse_parameters(prm);
      RunState state;
      bool has_ended = false;
      const double begin = measured.time();
      RunLoop loop(time, measured, output, collective);
      try
      {
        loop.run(state);
        if (loop.stop_signal() != 0)
          throw Stopped(loop.stop_signal());
        has_ended = true;
        output.flush();
        save_results(folder, state, simulation, output, collective);
        trial.other_bytes = finish(description.name, state, simulation, output);
        output.set_status("finished");
      }
      catch (const NumericsError &)
      {
        // So coarse a run may be too inaccurate for the checks at its end.
        if (!has_ended)
          throw;
      }
      catch (const Stopped &)
      {
        throw;
      }
      catch (const std::exception &)
      {
        if (!measured.is_too_long())
          throw;
        const double first =
          trial.stages.empty() ? begin : trial.stages.back().begin;
        trial.part = (measured.time() - first) / (time.end_time - first);
        output.flush();
        save_results(folder, state, simulation, output, collective);
      }
      trial.time = measured.time();
      trial.lacks_stage = simulation.expected_hand_over().has_value();
    }

    /// Sets up the scene with 2^@p levels times larger cells in @p coarse.
    /// @throws InputError if it cannot be that coarse
    void coarsen(const ApplicationDescription &description,
                 const dealii::ParameterHandler &prm,
                 const unsigned int levels,
                 dealii::ParameterHandler &coarse)
    {
      TimeParameters::declare_parameters(coarse);
      description.declare_parameters(coarse);
      apply_assignments(contrecoup::assignments_of(prm), coarse);
      if (levels > 0 && !description.coarsen(coarse, levels))
        throw InputError("the scene cannot be so coarse");
    }
  } // namespace

  double Trial::step_growth() const
  {
    if (stages.empty() || !(time > stages.back().begin))
      return 1.;
    const TrialStage &last = stages.back();
    return (part * last.steps - 1.) * last.first_step / (time - last.begin);
  }

  std::vector<Assumption> coarse_plan(const ApplicationDescription &description,
                                      const dealii::ParameterHandler &prm,
                                      Collective &collective)
  {
    const Silence silence;
    // Most charges still have a few cells then.
    constexpr unsigned int most_levels = 3;
    std::vector<Assumption> plan;
    for (unsigned int levels = most_levels; levels > 0 && plan.empty();
         --levels)
      try
      {
        collective.run([&]() {
          dealii::ParameterHandler coarse;
          coarsen(description, prm, levels, coarse);
          const auto simulation =
            description.create(coarse, collective.communicator());
          simulation->setup();
          plan = simulation->plan();
        });
      }
      catch (const std::exception &)
      {
        // Finer cells may do.
      }
    return plan;
  }

  std::optional<Trial> try_run(const ApplicationDescription &description,
                               const dealii::ParameterHandler &prm,
                               const unsigned int levels,
                               const double longest,
                               Collective &collective)
  {
    const MPI_Comm all = collective.communicator();
    const Silence silence;
    Trial trial;
    trial.levels = levels;
    double outputs = 1.;
    forget_peak_memory();
    try
    {
      collective.run([&]() {
        dealii::ParameterHandler coarse;
        coarsen(description, prm, levels, coarse);
        outputs = prepare(coarse);
        const auto simulation = description.create(coarse, all);
        std::string path;
        if (dealii::Utilities::MPI::this_mpi_process(all) == 0)
        {
          trial.folder = std::make_shared<TemporaryFolder>();
          path = trial.folder->path();
        }
        path = broadcast_text(all, path, 0);
        // The run loop needs its own Collective for errors, besides that of
        // setup.
        Collective inner(all);
        run_in(path, description, coarse, *simulation, trial, longest, inner);
      });
    }
    catch (const Stopped &)
    {
      throw;
    }
    catch (const std::exception &)
    {
      return std::nullopt;
    }
    if (trial.folder)
      count_bytes(trial.folder->path(), outputs, trial);
    complete(trial, outputs, all);
    return trial;
  }

  std::pair<double, double>
  try_drawing(const ApplicationDescription &description,
              const Trial &trial,
              Collective &collective)
  {
    const Silence silence;
    const auto begin = std::chrono::steady_clock::now();
    double before = 0., after = 0.;
    collective.run([&]() {
      if (!trial.folder ||
          !std::filesystem::exists(trial.folder->path() + "/summary.json"))
        return;
      before = bytes_in(trial.folder->path());
      draw(description.pictures, trial.folder->path(), "pictures", "pictures");
      after = bytes_in(trial.folder->path());
    });
    return {
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin)
        .count(),
      after - before};
  }
} // namespace io
} // namespace contrecoup
