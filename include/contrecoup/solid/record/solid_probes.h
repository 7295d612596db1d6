// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>

namespace contrecoup::solid
{
/// What a probe reads, in the order of its columns.
struct ProbeQuantity
{
  std::string name;
  std::string unit;
};

/// displacement and velocity of the nearest node; pressure, von Mises stress,
/// largest principal strain and the six stresses of the nearest element.
const std::vector<ProbeQuantity> &probe_quantities();

/**
 * Gauges in the body, subsection "Probes", and what is measured with them over
 * time, subsection "Measures".
 */
class SolidProbes
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a measure of a probe that is not there
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Finds nodes and elements next to the probes. Collective.
  void reinit(const SolidMesh &mesh, MPI_Comm communicator);

  /// Reads all probes; measures follow. Collective.
  template <typename Real>
  void read(const SolidBody<Real> &body);

  /// Whether read() is to be called in every step.
  bool measures() const
  {
    return !measures_.empty();
  }

  bool empty() const
  {
    return places_.empty();
  }

  /// What was read last, "probe_1_pressure" and so on.
  std::vector<NamedValue> values() const;

  /// Measured numbers by the name of their measure.
  std::vector<NamedValue> measured() const;

  /// The same over what was expected, less 1.
  std::vector<NamedValue> errors() const;

  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  struct Place
  {
    dealii::Point<3> point;
    bool has_node = false; ///< on this rank
    std::uint32_t node = 0;
    bool has_cell = false;
    std::uint32_t cell = 0;
  };

  struct Measure
  {
    std::string name;
    unsigned int column;
    std::string statistic;
    double expected;
    double first_time;
    double threshold;
    /// What was seen so far: extremum, or times of crossings.
    double value = 0.;
    double last = 0.;
    double last_time = 0.;
    double first_crossing = 0.;
    double n_crossings = 0.;
    double n_read = 0.;

    void take(double now, double time);
    double result() const;
  };

  std::vector<Place> places_;
  std::vector<Measure> measures_;
  std::vector<double> values_;
};
} // namespace contrecoup::solid
