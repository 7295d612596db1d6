// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/record/solid_recorder.h>

#include <string>
#include <utility>
#include <vector>

namespace contrecoup::solid
{
/// Name and unit of a column of a probe.
struct ProbeQuantity
{
  std::string name;
  std::string unit;
};

/// The columns: displacement and velocity of the nearest node; pressure, von
/// Mises stress, largest principal strain and the six stress components xx, yy,
/// zz, xy, yz and zx of the element with the nearest centre; and the pressure
/// of that element, averaged as by TissueAverage over its neighbours in the
/// same tissue.
const std::vector<ProbeQuantity> &probe_quantities();

/// Probes in the body, subsection "Probes", and statistics of their signals
/// over time, subsection "Measures".
template <typename Real>
class SolidProbes : public SolidRecorder<Real>
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a measure of a missing probe
  void parse_parameters(dealii::ParameterHandler &prm,
                        const MeshDescription &mesh) override;

  bool empty() const
  {
    return locations_.empty();
  }

  /// Finds the node and the element nearest to each probe.
  /// @throws InputError on all ranks for a probe outside of the body, by more
  /// than half an element, as far as stairs of voxels may be from the surface
  void check(const SolidMesh &mesh, MPI_Comm communicator) override;

  void reinit(const SolidBody<Real> &body) override
  {
    check(body.mesh(), body.communicator());
  }
  void begin(const SolidBody<Real> &body) override
  {
    record(body);
  }

  /// Updates the measures; without any, values() reads the probes.
  void record(const SolidBody<Real> &body) override
  {
    if (!measures_.empty())
      read(body);
  }

  /// Values at the present, named "probe_1_pressure" and so on.
  std::vector<NamedValue> values(const SolidBody<Real> &body);

  /// Results of the measures, by name; NaN if one has none, and gaps() tells
  /// why.
  std::vector<NamedValue> results(const SolidBody<Real> &body) const override;

  /// A line for each measure that has no value.
  std::vector<std::string> gaps() const override;

  /// Relative errors of the measures against their expected values.
  std::vector<NamedValue> errors() const override;

  void save(const SolidBody<Real> &body,
            const std::string &folder) const override;
  void restore(const SolidBody<Real> &body, const std::string &folder) override;

private:
  /// Reads all probes and updates the measures.
  void read(const SolidBody<Real> &body);

  struct ProbeLocation
  {
    dealii::Point<3> point;
    bool has_node = false; ///< on this rank
    std::uint32_t node = 0;
    bool has_element = false;
    std::uint32_t element = 0;
    /// This rank's elements in the averaged pressure, with their weights.
    std::vector<std::pair<std::uint32_t, double>> averaged;
  };

  /// Fills ProbeLocation::averaged. Collective.
  static void find_averaged(const SolidMesh &mesh,
                            ProbeLocation &location,
                            MPI_Comm communicator);

  struct Measure
  {
    std::string name;
    unsigned int column;
    std::string statistic;
    double expected;
    double first_time;
    double threshold;
    struct State
    {
      double value = 0.; ///< extreme value, or time of the last crossing
      double last = 0.;
      double last_time = 0.;
      double first_crossing = 0.;
      double n_crossings = 0.;
      double n_read = 0.;
    } state;

    void take(double now, double time);
    bool is_found() const;
    double result() const;
  };

  std::vector<ProbeLocation> locations_;
  std::vector<Measure> measures_;
  std::vector<double> values_;
};
} // namespace contrecoup::solid
