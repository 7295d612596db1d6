// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/ale/exact/shell_pressures.h>
#include <contrecoup/ale/exact/sphere_peaks.h>

namespace contrecoup::ale
{
/**
 * The exact solution that a run is compared with: subsection "Reference", which
 * names one, and in which each has a subsection of its own.
 */
class Reference
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for constants without a physical meaning
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Follows the pressures at @p probes, cells or HexSpace::no_cell, after a
  /// step of @p step seconds.
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes,
              const double step);

  /// Those of a flow, or at the probes. Collective.
  std::vector<NamedValue> errors(const HexSpace &space,
                                 const LagrangeStep &lagrange,
                                 const AleState &state) const;

  /// The flow of Reference/Kind; none if that is no flow. @throws InputError
  static std::unique_ptr<ExactFlow> parse_flow(dealii::ParameterHandler &prm);

  /// For checkpoints.
  Peaks &peaks()
  {
    return peaks_;
  }

private:
  double radius_ = 0.; ///< within which flows are compared [m]
  std::unique_ptr<ExactFlow> flow_;
  std::unique_ptr<SpherePeaks> sphere_;
  std::unique_ptr<ShellPressures> shell_;
  Peaks peaks_; ///< by probe
};
} // namespace contrecoup::ale
