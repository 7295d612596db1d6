// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/ale/exact/shell_pressures.h>
#include <contrecoup/ale/exact/sphere_peaks.h>

namespace contrecoup::ale
{
/// The exact solution that a run is compared with: subsection "Reference",
/// with a subsection for each kind of solution.
class Reference
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Records the pressures at @p probes (cells, or HexSpace::no_cell) after a
  /// step of size @p step [s].
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<std::uint32_t> &probes,
              const double step);

  /// Errors of the flow, or of the pressures at the probes. Collective.
  std::vector<NamedValue> errors(const HexSpace &space,
                                 const LagrangeStep &lagrange,
                                 const AleState &state) const;

  /// @throws InputError for a kind that compares at probes without these
  static void check_probes(dealii::ParameterHandler &prm,
                           const std::size_t n_probes);

  /// The flow of Reference/Kind, or null if the kind is no flow. @throws
  /// InputError
  static std::unique_ptr<ExactFlow> parse_flow(dealii::ParameterHandler &prm);

  /// Recorded peaks, for checkpoints.
  Peaks &peaks()
  {
    return peaks_;
  }

private:
  double radius_ = 0.; ///< flows are compared within this radius [m]
  std::unique_ptr<ExactFlow> flow_;
  std::unique_ptr<SpherePeaks> sphere_;
  std::unique_ptr<ShellPressures> shell_;
  Peaks peaks_; ///< by probe
};
} // namespace contrecoup::ale
