// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/blast_probes.h>

namespace contrecoup::gas
{
/**
 * Gauges at fixed places that every rank knows: what they read now, and peak
 * overpressure, impulse, arrival and duration of the blast at each so far.
 */
template <int dim>
class ProbeSet : public Recorder<dim>
{
public:
  /// Declares subsection "Probes".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a place outside of the domain or in the body.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasScene<dim> &scene) override;

  void mesh_changed(const GasSnapshot<dim> &gas) override
  {
    gauges_.mesh_changed(gas);
  }
  void begin(const GasSnapshot<dim> &gas) override
  {
    add_step(gas);
  }
  void add_step(const GasSnapshot<dim> &gas) override;

  /// Takes states that were read elsewhere at @p time [s], one for each place,
  /// as add_step() does.
  void take(const std::vector<GasState<dim>> &states, const double time);

  const std::vector<dealii::Point<dim>> &places() const
  {
    return gauges_.places();
  }

  /// What was read last.
  const std::vector<GasState<dim>> &states() const
  {
    return states_;
  }

  /// Pressure, density, velocity and, for mixtures, products of each.
  std::vector<NamedValue> values(const bool has_products) const;

  /// What the blast did at each probe so far.
  std::vector<BlastMeasures> blasts() const;

  /// The same with names, and beside it what @p reference says where it does.
  std::vector<NamedValue>
  measures(const ReferenceSolution<dim> &reference) const;
  std::vector<NamedValue> measures(const GasSnapshot<dim> &gas) const override
  {
    return measures(gas.scene.reference);
  }

  /// The relative differences of the two.
  std::vector<NamedValue> errors(const GasSnapshot<dim> &gas) const override;

  /// The two side by side, a line for each probe; empty without reference.
  std::vector<std::string> report(const GasSnapshot<dim> &gas) const override;

  void save(std::ostream &stream, const std::string &folder) const override;
  void load(std::istream &stream, const std::string &folder) override;

private:
  BlastProbes<dim> gauges_;
  double last_time_ = 0.; ///< [s]
  std::vector<GasState<dim>> states_;
};
} // namespace contrecoup::gas
