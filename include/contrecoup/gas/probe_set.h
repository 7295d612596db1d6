// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/gas/initial_state.h>
#include <contrecoup/gas/point_sampler.h>
#include <contrecoup/gas/reference_solution.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>

namespace contrecoup::gas
{
/**
 * Gauges at fixed places: what they read now, and the peak overpressure
 * and arrival of the blast at each so far.
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

  /// Pressure, density, velocity and, for mixtures, products of each.
  std::vector<NamedValue> values(const bool has_products) const;

  /// Peak overpressure and arrival of each probe.
  std::vector<NamedValue> peaks() const;

  /// Their relative errors, where @p reference knows arrivals.
  std::vector<NamedValue> errors(const ReferenceSolution<dim> &reference) const;

  /// The peaks so far, for checkpoints.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  /// A front arrives where the pressure rises fastest.
  struct Record
  {
    double last_time = 0.;     ///< [s]
    double last_pressure = 0.; ///< [Pa]
    double peak = 0.;          ///< largest overpressure [Pa]
    double arrival = 0.;       ///< [s]
    double steepest = 0.;      ///< fastest rise so far [Pa/s]
  };

  std::vector<dealii::Point<dim>> places_;
  std::vector<double> ambient_;
  std::vector<Record> records_;
  std::vector<GasState<dim>> states_;
  PointSampler<dim> sampler_;
};
} // namespace contrecoup::gas
