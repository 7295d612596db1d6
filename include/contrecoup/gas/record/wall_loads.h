// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/load_gauges.h>
#include <contrecoup/gas/record/wall_facets.h>

namespace contrecoup::gas
{
/**
 * Records the overpressure on the facets of a rigid body, see WallFacets, in
 * loads.h5 (io::LoadFile) with loads.xdmf (io::write_load_series()), and that
 * of the gauges in load_gauges.csv (LoadGauges). Sampling begins when the wave
 * arrives at the first facet; the first sample is the mean over all time
 * before.
 *
 * Pressures at the ends of steps count from the middle of their step to that of
 * the next one, and samples end at such middles: a sample of a single step has
 * its pressure, at its time, and the impulse is that of the trapezoidal rule.
 *
 * Facets are those of the modelled part of the body; the audit compares their
 * force and impulse with the force that the
 * scheme exerts on the gas. In the staircase treatment a facet takes one
 * pressure for all faces of its cell together, so that the two differ by some
 * per cent.
 */
template <int dim>
class WallLoads : public Recorder<dim>
{
public:
  /// Declares subsection "Loads".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when loads are to be recorded without a body, and for
  /// gauges that are not on the body.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasScene<dim> &scene) override;

  void set_output_folder(const std::string &folder) override
  {
    file_ = folder + "/loads.h5";
    gauges_.set_folder(folder);
  }
  void mesh_changed(const GasSnapshot<dim> &gas) override;
  void add_step(const GasSnapshot<dim> &gas) override;
  /// Appends buffered samples to loads.h5; discards them in runs without an
  /// output folder.
  void reduce_over_ranks() override;
  /// Copies loads.h5 to the folder of the checkpoint, and restores it from
  /// there, because a killed run may leave the file incomplete.
  void save(std::ostream &stream, const std::string &folder) const override;
  void load(std::istream &stream, const std::string &folder) override;
  /// Completes the current sample and writes all results.
  std::vector<std::string> gaps(const double time) const override
  {
    return active_ ? gauges_.gaps(time) : std::vector<std::string>();
  }
  void finish() override;

  bool is_active() const
  {
    return active_;
  }
  const WallFacets<dim> &facets() const
  {
    return facets_;
  }
  const LoadGauges &gauges() const
  {
    return gauges_;
  }
  /// Overpressures on facets().owned() after the last step [Pa].
  std::vector<double> overpressures() const;

  /// Combines the records of all ranks for write_skin(). Collective.
  void gather_skin();
  /// Writes skin_NNNN.vtp on the first rank: the facets with their
  /// overpressure, and peak, impulse and arrival so far, not a number where no
  /// blast has come; see WallFacets::skin(). Call after gather_skin().
  /// @return name of the file; empty without loads
  std::string write_skin(const std::string &folder,
                         const unsigned int index,
                         const double time) const;

  /// Impulses on the whole body, see factors_to_whole_body(), and the measures
  /// of the gauges.
  std::vector<NamedValue>
  results(const GasSnapshot<dim> & /*gas*/) const override
  {
    return active_ ? result_values() : std::vector<NamedValue>();
  }
  /// Number and area of facets; differences between facets, gas and record.
  std::vector<NamedValue>
  checks(const GasSnapshot<dim> & /*gas*/) const override
  {
    return active_ ? check_values() : std::vector<NamedValue>();
  }
  /// Table of the gauges; empty without loads.
  std::vector<std::string>
  report(const GasSnapshot<dim> & /*gas*/) const override
  {
    return active_ ? gauges_.table(totals_.time) : std::vector<std::string>();
  }

private:
  /// Fraction of the highest peak below which a facet's peak does not end
  /// samples.
  static constexpr double counted_fraction = 0.05;

  /// Record of a facet.
  struct Record
  {
    BlastRecord<double> blast;
    double sum = 0.;         ///< time integral over the current sample [Pa s]
    double last = 0.;        ///< overpressure at the end of the last step [Pa]
    double sample_peak = 0.; ///< largest sample so far [Pa]
  };
  /// Totals over the run so far.
  struct Totals
  {
    double sample_begin = -1.;          ///< [s]; negative before the arrival
    double n_times = 0.;                ///< number of samples in the file
    dealii::Tensor<1, 3> facet_impulse; ///< also that of the samples [N s]
    dealii::Tensor<1, 3> gas_impulse;   ///< [N s]
    double largest_force = 0.;          ///< [N]
    double largest_difference = 0.;     ///< between facets and gas [N]
    double time = 0.;                   ///< [s]
    /// Largest fraction of a facet's peak that no sample shows, of the facets
    /// whose peak exceeds counted_fraction of the highest [-].
    double peak_loss = 0.;
    double highest = 0.; ///< highest overpressure so far [Pa]
  };

  /// Sends the records of all facets to all ranks. Collective.
  void share_records();
  void add_gauges(const double time, const double step);
  /// @param facet_force mean over the step [N]
  void add_forces(const dealii::Tensor<1, 3> &facet_force,
                  const std::array<double, 6> &wall_force,
                  const double step);
  /// Adds the last pressures until @p middle of the step, and ends the sample
  /// there if it is to end. Collective.
  void begin_step(const double middle, const double step);
  /// Whether the current sample, if it included the present pressures, would
  /// lose the peak of a facet in its mean. Collective.
  bool loses_peaks(const double middle, const double step);
  /// Whether the wave has not yet arrived at any facet.
  bool is_waiting() const
  {
    return totals_.sample_begin < 0.;
  }
  /// Whether the wave has arrived at a facet by the present pressures.
  /// Collective.
  bool has_arrived() const;
  /// Writes the samples before the arrival in a step of length @p step.
  void begin_samples(const double middle, const double step);
  void end_sample(const double time);
  void create_file() const;
  void write_measures();
  std::vector<NamedValue> result_values() const;
  std::vector<NamedValue> check_values() const;

  bool active_ = false;
  double interval_ = 0.;     ///< of samples [s]; 0: every step
  double largest_loss_ = 1.; ///< fraction of a peak that samples may lose [-]
  double smallest_ = 0.;     ///< arrival overpressure over ambient [-]
  double ambient_ = 0.;      ///< [Pa]
  /// See factors_to_whole_body().
  dealii::Tensor<1, 3> to_whole_;
  bool is_plane_ = false; ///< whether impulses are per length of a 2-D body
  std::string file_;
  MPI_Comm communicator_ = MPI_COMM_SELF;

  WallFacets<dim> facets_;
  std::vector<double> pressures_; ///< of owned facets after the step [Pa]
  std::vector<Record> records_; ///< of all facets; only owned ones are current
  LoadGauges gauges_;
  Totals totals_;
  std::vector<double> times_;  ///< of samples not yet in the file [s]
  std::vector<float> samples_; ///< [time][facet]; 0 for other ranks' [Pa]
};
} // namespace contrecoup::gas
