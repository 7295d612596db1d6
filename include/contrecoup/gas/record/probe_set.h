// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/blast_probes.h>
#include <contrecoup/gas/state/wave_peaks.h>

namespace contrecoup::gas
{
/**
 * Probes at fixed positions, known to every rank: the current state, and peak
 * overpressure, impulse, arrival and duration of the blast so far at each. What
 * the blast would do to a person at each probe goes to probe_injury.csv at the
 * end of the run, see air_injury_table().
 */
template <int dim>
class ProbeSet : public Recorder<dim>
{
public:
  /// Declares subsection "Probes".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a position outside of the domain or in the body.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasScene<dim> &scene) override;

  void set_output_folder(const std::string &folder) override
  {
    folder_ = folder;
  }

  void mesh_changed(const GasSnapshot<dim> &gas) override
  {
    probes_.mesh_changed(gas);
  }
  void begin(const GasSnapshot<dim> &gas) override;
  /// Takes no records where take() has recorded all that came before.
  void inherit(const KnownRecord<dim> &record,
               const GasSnapshot<dim> &gas) override;
  void add_step(const GasSnapshot<dim> &gas) override;

  /// As add_step(), for states at @p time [s] that were sampled elsewhere, one
  /// per probe.
  void take(const std::vector<GasState<dim>> &states, const double time);

  const std::vector<dealii::Point<dim>> &places() const
  {
    return probes_.places();
  }

  /// States at the last recorded time, one per probe.
  const std::vector<GasState<dim>> &states() const
  {
    return states_;
  }

  /// Pressure, density, velocity and, for mixtures, mass fraction of products
  /// at each probe.
  std::vector<NamedValue> values(const bool has_products) const;

  /// Blast measures at each probe so far.
  std::vector<BlastMeasures> blasts() const;
  /// The same with the peaks of the first wave.
  std::vector<BlastMeasures> first_waves() const;

  /// The same as named values, with the peaks of the first wave and of larger
  /// or smaller later ones, and with the values of @p reference where it has
  /// them.
  std::vector<NamedValue>
  measures(const ReferenceSolution<dim> &reference) const;
  std::vector<NamedValue> results(const GasSnapshot<dim> &gas) const override
  {
    return measures(gas.scene.reference);
  }

  /// Relative differences between measured and reference values, the peak of
  /// the first wave among the former.
  std::vector<NamedValue> errors(const GasSnapshot<dim> &gas) const override;

  /// Table of the first wave at the first probes, beside the values of a
  /// reference that errors() compares, and a line on each probe at which a
  /// later wave has a larger peak.
  std::vector<std::string> report(const GasSnapshot<dim> &gas) const override;

  std::vector<std::string> gaps(const double time) const override;
  void finish() override;

  void save(std::ostream &stream, const std::string &folder) const override;
  void load(std::istream &stream, const std::string &folder) override;

private:
  const WavePeaks &waves(const std::size_t i) const
  {
    return probes_.exposures()[i].waves;
  }

  /// Peak, impulse, arrival and duration of the first wave in words.
  std::vector<std::string>
  values_in_words(std::size_t probe,
                  const ReferenceSolution<dim> &reference) const;

  BlastProbes<dim> probes_;
  std::string folder_;        ///< of the results; empty in first stages
  double body_mass_ = 0.;     ///< [kg]
  double last_time_ = 0.;     ///< [s]
  bool is_continued_ = false; ///< whether take() preceded begin()
  std::vector<GasState<dim>> states_;
};
} // namespace contrecoup::gas
