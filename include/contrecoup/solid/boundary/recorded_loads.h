// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/output/load_reader.h>
#include <contrecoup/solid/boundary/pressure_history.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup::solid
{
/**
 * Loads recorded by another run. Each facet takes the pressure of the nearest
 * recorded facet with a similar normal. Recorded samples are means over time
 * intervals; pressure is interpolated linearly between the midpoints of
 * intervals, which conserves impulse, and is constant after the last one. One
 * global factor matches the impulse on this surface to that on the recorded
 * surface until the time when the latter is largest. Where pushes from opposite
 * sides leave little of it, the sums of the magnitudes of all facets are
 * compared instead, and nothing is multiplied.
 */
class RecordedLoads : public PressureHistory
{
public:
  /// Declares entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads the entries; returns null without a file.
  /// @throws InputError when the file holds no loads
  static std::shared_ptr<RecordedLoads>
  parse_parameters(dealii::ParameterHandler &prm);

  void reinit(const std::vector<dealii::Point<3>> &middles,
              const std::vector<dealii::Tensor<1, 3>> &areas,
              MPI_Comm communicator) override;
  void set_time(double time) override;
  double pressure(std::size_t facet) const override;
  double correction() const override
  {
    return factor_;
  }

  /// Tells that the record ends before the run: when, and the largest pressure
  /// that is left then, and where. Collective.
  std::string warning(double end_time) const override;

  /// Distances of the facets, the pressure factor, and the impulse of all
  /// samples on the recorded surface and, including the factor, on this
  /// surface; also until the time when the recorded one is largest, along its
  /// direction then, or the sums of magnitudes where pushes cancel. Collective.
  std::vector<NamedValue> check_values() const override;

private:
  void measure_impulses();
  void choose_factor();
  /// Area vectors of the recorded facets, including mirrored ones [m^2].
  std::vector<dealii::Tensor<1, 3>> recorded_areas() const;
  /// Sums the impulses of all samples, on the recorded surface and on the
  /// facets of this rank [N s]. Collective.
  void sum_impulses(const std::vector<dealii::Tensor<1, 3>> &recorded,
                    const std::vector<dealii::Tensor<1, 3>> &mapped);
  /// Takes impulses per area of the recorded facets; sums of their magnitudes,
  /// recorded and arriving on this surface [N s]. Collective.
  /// @throws InputError when too little impulse arrives
  std::pair<double, double>
  require_arrival(const std::vector<double> &impulse) const;

  std::unique_ptr<io::LoadReader> reader_;
  double offset_ = 0.; ///< recorded time at the start of this run [s]
  double largest_distance_ = 0.;
  /// directions with a symmetry plane through 0
  std::array<bool, 3> mirrored_{};
  bool keeps_impulse_ = false;
  double largest_correction_ = 0.; ///< of impulses, relative; 0: none
  double factor_ = 1.;             ///< on all pressures

  MPI_Comm communicator_ = MPI_COMM_SELF;
  /// recorded facet of each facet of this rank
  std::vector<std::uint32_t> source_;
  std::vector<dealii::Point<3>> middles_;
  std::vector<dealii::Tensor<1, 3>> areas_;
  std::vector<double> distances_;

  /// Samples in memory: index [facet][time].
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::vector<float> samples_;
  /// The two samples around the current time, and the second one's weight.
  std::size_t before_ = 0;
  std::size_t after_ = 0;
  double weight_ = 0.;
  double is_loaded_ = 0.; ///< 0 before the first sample, then 1

  dealii::Tensor<1, 3> recorded_impulse_; ///< including mirrored facets [N s]
  dealii::Tensor<1, 3> mapped_impulse_;   ///< without the factor [N s]
  /// At the time when the recorded impulse is largest, along it; where pushes
  /// cancel, sums of magnitudes [N s].
  double largest_recorded_impulse_ = 0.;
  double largest_mapped_impulse_ = 0.; ///< without the factor
  /// Impulse left where pushes cancel, recorded and on this surface, at the
  /// time when the former is largest [N s].
  std::optional<std::pair<double, double>> pushes_left_;
};
} // namespace contrecoup::solid
