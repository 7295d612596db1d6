// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/point_sampler.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>

namespace contrecoup::gas
{
/**
 * Gauges at fixed places: what they read now, and peak overpressure,
 * impulse, arrival and duration of the blast at each so far.
 */
template <int dim>
class ProbeSet
{
public:
  /// Declares subsection "Probes".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a place outside the box @p mesh.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const CoarseMesh<dim> &mesh);

  bool empty() const
  {
    return places_.empty();
  }

  /// The pressures before anything happens [Pa], from the initial state.
  void set_ambient(const InitialState<dim> &initial_state);

  /// Call when the mesh changed.
  void reinit(const LeafMesh<dim> &mesh, const LeafPoints<dim> &points);

  /// Reads all gauges; peaks and arrivals follow. Collective.
  void
  read(const GasField &field, const GasMaterial &material, const double time);

  /// Takes states that were read elsewhere, one for each place, as read()
  /// does.
  void take(const std::vector<GasState<dim>> &states, const double time);

  const std::vector<dealii::Point<dim>> &places() const
  {
    return places_;
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

  /// The same with names, and beside it what
  /// @p reference says where it does.
  std::vector<NamedValue>
  measures(const ReferenceSolution<dim> &reference) const;

  /// The relative differences of the two.
  std::vector<NamedValue> errors(const ReferenceSolution<dim> &reference) const;

  /// The two side by side, a line for each probe; empty without reference.
  std::vector<std::string>
  comparison(const ReferenceSolution<dim> &reference) const;

  /// The peaks so far, for checkpoints.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  struct Record
  {
    double last_time = 0.; ///< [s]
    BlastRecord<double> blast;
  };

  std::vector<dealii::Point<dim>> places_;
  std::vector<double> ambient_;
  std::vector<Record> records_;
  std::vector<GasState<dim>> states_;
  PointSampler<dim> sampler_;
};
} // namespace contrecoup::gas
