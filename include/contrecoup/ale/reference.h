// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange_step.h>
#include <contrecoup/base/simulation.h>
#include <contrecoup/numerics/exact_riemann.h>
#include <contrecoup/numerics/rigid_sphere_solution.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>

namespace contrecoup::ale
{
/**
 * Exact solutions that a run is compared with: subsection "Reference".
 */
class Reference
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Follows the peaks at @p probes, cells or HexSpace::no_cell.
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes);

  /// Mean absolute errors of a shock tube by volume, or the largest
  /// error of the peaks at the probes over the largest exact one. Collective.
  std::vector<NamedValue> errors(const HexSpace &space,
                                 const LagrangeStep &lagrange,
                                 const AleState &state) const;

  /// Largest pressures so far, of the run and exact ones, for checkpoints [Pa].
  std::vector<std::array<double, 2>> &peaks()
  {
    return peaks_;
  }

private:
  std::vector<NamedValue> shock_tube_errors(const HexSpace &space,
                                            const LagrangeStep &lagrange,
                                            const AleState &state) const;

  std::string kind_;
  double interface_ = 0.;
  RiemannState left_, right_;
  double gamma_ = 1.4;
  RigidSphere sphere_;
  std::unique_ptr<RigidSphereSolution> solution_;
  std::vector<std::array<double, 2>> peaks_; ///< by probe
};
} // namespace contrecoup::ale
