// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/line_of_sight.h>
#include <contrecoup/numerics/injury/friedlander.h>
#include <contrecoup/solid/boundary/pressure_history.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * Blast loads from formulas. A facet that sees the charge combines incident and
 * reflected pressure with the square of the cosine (pressure_at_angle()). One
 * that faces away, or that another part of the body hides, gets the incident
 * pressure, at the arrival by the straight way: there is no flow around the
 * body, so that it gets too much and too early rather than too little.
 */
class AnalyticBlast : public PressureHistory
{
public:
  /// Names of the kinds of blast.
  static const std::vector<std::string> kinds;

  /// Declares subsections "Friedlander" and "Kingery Bulmash".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @param kind one of kinds
  /// @param path of the current subsection, for error messages
  static std::shared_ptr<AnalyticBlast>
  parse_parameters(dealii::ParameterHandler &prm,
                   const std::string &kind,
                   const std::string &path);

  void set_surface(const std::vector<std::array<dealii::Point<3>, 4>> &facets,
                   MPI_Comm communicator) override;
  /// @throws InputError outside the range of the tables
  void reinit(const std::vector<dealii::Point<3>> &middles,
              const std::vector<dealii::Tensor<1, 3>> &areas,
              MPI_Comm communicator) override;
  void set_time(const double time) override
  {
    time_ = time;
  }
  double pressure(std::size_t facet) const override;
  /// Tells that the wave reaches no facet before the end. Collective.
  std::string warning(double end_time) const override;
  std::vector<NamedValue> check_values() const override
  {
    return {};
  }

private:
  /// Incident wave, and the wave on a wall that faces the charge.
  struct Waves
  {
    Friedlander incident;
    Friedlander reflected;
  };

  struct Facet
  {
    Waves waves;
    double cosine; ///< 0 where the facet does not see the charge
  };

  /// Whether a facet of that size [m] sees the charge past the body's surface.
  bool sees_charge(const dealii::Point<3> &middle, const double size) const;

  void parse_friedlander(dealii::ParameterHandler &prm);
  void parse_tables(dealii::ParameterHandler &prm);
  Waves waves(double distance) const;

  std::string path_;
  dealii::Point<3> centre_;
  double time_ = 0.;
  MPI_Comm communicator_ = MPI_COMM_SELF;

  bool from_tables_ = false;
  std::string set_;
  double mass_ = 0.; ///< of TNT [kg]
  /// time from detonation to the start of the run [s]
  double start_time_ = 0.;

  Friedlander pulse_;
  double speed_ = 0.;          ///< speed of the front [m/s]
  double first_distance_ = 0.; ///< of the front from the charge at time 0 [m]
  double ambient_ = 0.;        ///< [Pa]; 0: no reflection
  bool negative_phase_ = false;

  std::optional<LineOfSight> sight_; ///< past the surface of the body
  std::vector<Facet> facets_;
};
} // namespace contrecoup::solid
