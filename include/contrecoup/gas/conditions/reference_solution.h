// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/gas_state.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup
{
class GasMaterial;
}

namespace contrecoup::gas
{
/**
 * Reference solution for the errors of a run, selected in subsection
 * "Reference". The parameters of the problem come from subsection "Initial
 * state", so that the two cannot disagree.
 */
template <int dim>
class ReferenceSolution
{
public:
  /// Declares subsection "Reference".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads subsections "Reference", "Initial state" and "Domain", which must
   * have been declared. The material is copied.
   *
   * @throws InputError when the kind of reference does not fit the initial
   * state or the material, or a table cannot be read.
   */
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasMaterial &material);

  /// Kind as named in the parameter file; "none" without a reference.
  const std::string &name() const;

  /// The same for readers, with the TNT equivalence by which tables are
  /// entered.
  std::string description() const
  {
    return name_ + equivalence_;
  }

  /// Whether value() may be called.
  bool exists() const;

  /// Whether errors against value() are reported; false if value() only serves
  /// exact boundaries.
  bool is_measured() const;

  /// Reference state at @p point [m] and @p time [s].
  GasState<dim> value(const dealii::Point<dim> &point, double time) const;

  /// Whether arrival() may be called.
  bool has_arrivals() const;

  /// Blast measures at @p point [m]; a measure that the reference does not
  /// have is zero.
  BlastMeasures arrival(const dealii::Point<dim> &point) const;

private:
  void parse_detonation(dealii::ParameterHandler &prm,
                        const GasMaterial &material);
  void parse_exact_solution(dealii::ParameterHandler &prm,
                            const GasMaterial &material);

  std::string name_ = "none";
  std::string equivalence_; ///< in words; empty: of TNT
  bool measure_errors_ = true;
  std::function<GasState<dim>(const dealii::Point<dim> &, double)> value_;
  std::function<BlastMeasures(const dealii::Point<dim> &)> arrival_;
};

/// Names of the kinds of reference solutions.
extern const std::vector<std::string> reference_solution_kinds;
} // namespace contrecoup::gas
