// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/exact/exact_flow.h>
#include <contrecoup/ale/exact/shell_pressures.h>
#include <contrecoup/ale/exact/sphere_peaks.h>
#include <contrecoup/ale/record/ale_recorder.h>

namespace contrecoup::ale
{
/// The exact solution that a run is compared with: subsection "Reference",
/// with a subsection for each kind of solution.
class Reference : public AleRecorder
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants, and for a kind that compares
  /// at probes without these
  void parse_parameters(dealii::ParameterHandler &prm,
                        const ImpactScene &impact) override;

  /// Records the pressures at the probes.
  void record(const AleSnapshot &now) override;

  /// Errors of the flow, or of the pressures at the probes.
  std::vector<NamedValue> errors(const AleSnapshot &now) const override;

  void save(io::StateWriter &out) const override
  {
    out.put_list(peaks_);
  }
  void restore(const AleSnapshot & /*now*/, io::StateReader &in) override
  {
    add_peaks(in, peaks_);
  }

  /// @throws InputError for a @p kind that compares at probes without these
  static void check_probes(const std::string &kind, const std::size_t n_probes);

  /// The flow of Reference/Kind, or nothing if the kind is none. @throws
  /// InputError
  static std::optional<ExactFlow> parse_flow(dealii::ParameterHandler &prm);

private:
  double radius_ = 0.; ///< flows are compared within this radius [m]
  std::optional<ExactFlow> flow_;
  std::unique_ptr<SpherePeaks> sphere_;
  std::unique_ptr<ShellPressures> shell_;
  Peaks peaks_; ///< by probe
};
} // namespace contrecoup::ale
