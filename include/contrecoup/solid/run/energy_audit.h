// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <iosfwd>

namespace contrecoup::solid
{
/**
 * The energy balance of a run and its limits, subsection "Energy audit":
 * missing energy, and energy stored in hourglass modes: in each tissue the
 * largest one over the run against the tissue's largest internal energy over
 * the run; that of the run is the largest of all tissues. Peaks between calls
 * of record() are missed.
 */
class EnergyAudit
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Takes note of the present energies.
  void record(const EnergyLedger &ledger);

  /// Largest energy so far [J].
  double scale() const
  {
    return scale_;
  }

  /// Residual and difference of nodal work over the largest energy [-], parts
  /// of hourglass energy and of the heat of hourglass damping [-].
  std::vector<NamedValue> checks(const EnergyLedger &ledger,
                                 const std::vector<Tissue> &tissues) const;

  /// Logs the balance, and warns of tissues with too much hourglass energy.
  /// @throws NumericsError if too much energy is missing
  void judge(const EnergyLedger &ledger,
             const std::vector<Tissue> &tissues) const;

  /// For checkpoints.
  void save(io::StateWriter &out) const;
  void load(io::StateReader &in, std::size_t n_tissues);

private:
  /// Largest energies of a tissue, or of the body, over time [J].
  struct Largest
  {
    double internal = 0.;
    double hourglass = 0.;
  };

  /// Largest stored hourglass energy over the largest internal energy [-];
  /// energies below a thousandth of the largest energy of the run do not count.
  double hourglass_part(const Largest &largest) const;
  /// The largest of all tissues.
  double hourglass_part() const;
  double residual(const EnergyLedger &ledger) const;
  void judge_residual(const EnergyLedger &ledger) const;
  void judge_hourglass(const std::vector<Tissue> &tissues) const;

  double largest_residual_ = 0.01;
  double largest_hourglass_ = 0.1;
  double scale_ = 0.;
  Largest body_;
  std::vector<Largest> tissues_;
};
} // namespace contrecoup::solid
