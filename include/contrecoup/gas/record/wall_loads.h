// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/load_gauges.h>
#include <contrecoup/gas/record/wall_facets.h>

namespace contrecoup::gas
{
/**
 * The pressure of the gas on the facets of a rigid body, see WallFacets,
 * recorded as the run goes. Written to loads.h5, see io::LoadFile, and at named
 * places to load_gauges.csv, see LoadGauges, from when the wave arrives at the
 * first facet: the first sample is the mean of all time before.
 *
 * Audits itself: force and impulse of all facets against what the scheme took
 * from the gas. A staircase's facets take one pressure for all sides of a cell
 * together, and so differ by some per cent from its scheme.
 */
template <int dim>
class WallLoads : public Recorder<dim>
{
public:
  /// Declares subsection "Loads".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when there is no body to record the loads of, and
  /// for gauges that are not on it.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasScene<dim> &scene) override;

  void set_output_folder(const std::string &folder) override
  {
    file_ = folder + "/loads.h5";
    gauges_.set_folder(folder);
  }
  void mesh_changed(const GasSnapshot<dim> &gas) override;
  void add_step(const GasSnapshot<dim> &gas) override;
  /// Writes samples that are in memory, or forgets them where there is no
  /// folder.
  void reduce_over_ranks() override;
  /// Keeps loads.h5 in the folder of the checkpoint, and brings it back: a run
  /// that was killed may have left it half-written.
  void save(std::ostream &stream, const std::string &folder) const override;
  void load(std::istream &stream, const std::string &folder) override;
  /// Ends the sample that is going on, and writes.
  void finish() override;

  /// Number and area of the facets, impulses and the audit, and what the
  /// gauges say.
  std::vector<NamedValue>
  measures(const GasSnapshot<dim> & /*gas*/) const override
  {
    return active_ ? check_values() : std::vector<NamedValue>();
  }
  /// What the gauges say, for people; empty without loads.
  std::vector<std::string>
  report(const GasSnapshot<dim> & /*gas*/) const override
  {
    return active_ ? gauges_.table(totals_.time) : std::vector<std::string>();
  }

private:
  /// Peaks below this part of the highest do not count for the samples.
  static constexpr double counted_fraction = 0.05;

  /// What is known of a facet.
  struct Record
  {
    BlastRecord<double> blast;
    double sum = 0.;         ///< integral of the sample that is going on [Pa s]
    double last = 0.;        ///< overpressure at the end of the last step [Pa]
    double sample_peak = 0.; ///< largest sample so far [Pa]
  };
  /// The whole run so far.
  struct Totals
  {
    double sample_begin = -1.;          ///< [s]; below 0: nothing arrived yet
    double n_times = 0.;                ///< that the file has
    dealii::Tensor<1, 3> facet_impulse; ///< [N s]
    dealii::Tensor<1, 3> gas_impulse;   ///< [N s]
    double largest_force = 0.;          ///< [N]
    double largest_difference = 0.;     ///< between facets and gas [N]
    double time = 0.;                   ///< [s]
    /// Largest part of a facet's peak that no sample shows, among those with
    /// a twentieth of the highest peak at least [-].
    double peak_loss = 0.;
    double highest = 0.; ///< overpressure so far [Pa]
  };

  /// Makes every rank know the records of all facets. Collective.
  void share_records();
  void add_gauges(const double time, const double step);
  void add_forces(const dealii::Tensor<1, 3> &facet_force,
                  const std::array<double, 6> &wall_force,
                  const double step);
  /// Whether a facet's peak would be lost in the sample that is going on if
  /// it took the step with the present pressures. Collective.
  bool loses_peaks(const double time, const double step);
  /// Whether no facet has met the wave yet.
  bool is_waiting() const
  {
    return totals_.sample_begin < 0.;
  }
  /// Whether some facet's pressure now tells it. Collective.
  bool has_arrived() const;
  /// Writes what was before the step that begins at @p time.
  void begin_samples(const double time, const double step);
  void end_sample(const double time);
  void create_file() const;
  void write_measures();
  std::vector<NamedValue> check_values() const;

  bool active_ = false;
  double interval_ = 0.;     ///< of samples [s]; 0: every step
  double largest_loss_ = 1.; ///< of a peak in samples [-]
  double smallest_ = 0.;     ///< overpressure over ambient that counts [-]
  double ambient_ = 0.;      ///< [Pa]
  std::string file_;
  MPI_Comm communicator_ = MPI_COMM_SELF;

  WallFacets<dim> facets_;
  std::vector<double> pressures_; ///< on this rank's, after the step [Pa]
  std::vector<Record> records_;   ///< of all; up to date for this rank's
  LoadGauges gauges_;
  Totals totals_;
  std::vector<double> times_;  ///< not yet in the file [s]
  std::vector<float> samples_; ///< [time][facet], zero for other ranks' [Pa]
};
} // namespace contrecoup::gas
