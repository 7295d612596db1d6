// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/octree/leaf_points.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/materials/gas_material.h>

#include <iosfwd>
#include <optional>

namespace contrecoup::gas
{
/**
 * Afterburn: energy that detonation products release after the detonation as
 * they burn with the oxygen of the air. One released fraction L applies to all
 * products: each step increases rho E by rho Y q dL, Y being the mass fraction
 * of products. L grows either at a constant rate between two times, or by (P.
 * J. Miller, Mat. Res. Soc. Symp. Proc. 418 (1996) 413-420)
 *
 *   dL/dt = a (1 - L)^m (p / 1 Mbar)^n,
 *
 * here with the mass-weighted mean pressure p of all products. The mixing with
 * air is not resolved: oxygen is assumed to be available.
 */
class Afterburn
{
public:
  /// Declares subsection "Afterburn" of the current one.
  static void declare_parameters(ParameterHandler &prm);

  /// @throws InputError for an end time before the start time.
  void parse_parameters(ParameterHandler &prm);

  bool active() const
  {
    return kind_ != Kind::none;
  }

  /// Time before which nothing is released [s]; none if nothing is at all or
  /// the law has no such time.
  std::optional<double> start() const
  {
    return kind_ == Kind::constant ? std::optional<double>(start_)
                                   : std::nullopt;
  }

  /// Released fraction L [-].
  double fraction() const
  {
    return fraction_;
  }

  /// Energy that products have yet to release [J/kg].
  double energy_left() const
  {
    return active() ? (1. - fraction_) * energy_ : 0.;
  }

  /// Energy released so far [J].
  double released() const
  {
    return released_;
  }

  /**
   * Adds the energy released in the step of length @p step [s] that ended at
   * @p time [s] to @p field. Collective.
   *
   * @return whether any energy was released
   */
  template <int dim>
  bool release(const double time,
               const double step,
               const LeafMesh<dim> &mesh,
               const LeafPoints<dim> &points,
               const GasMaterial &material,
               GasField &field);

  /// Sets the released fraction [-] and the released energy [J] at the start.
  void set_released(const double fraction, const double released)
  {
    fraction_ = fraction;
    released_ = released;
  }

  /// Writes and reads the state of a checkpoint.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  enum class Kind
  {
    none,
    constant,
    miller
  };

  double grown_fraction(const double time,
                        const double step,
                        const double pressure) const;

  Kind kind_ = Kind::none;
  double energy_ = 0.; ///< q [J/kg]
  double start_ = 0.;  ///< of the constant rate [s]
  double end_ = 0.;    ///< of the constant rate [s]
  double rate_ = 0.;   ///< a [1/s]

  double fraction_ = 0.;
  double released_ = 0.;
};
} // namespace contrecoup::gas
