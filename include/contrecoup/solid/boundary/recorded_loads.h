// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/load_reader.h>
#include <contrecoup/solid/boundary/pressure_history.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * The loads that another run recorded: each facet has the pressure of the
 * nearest recorded one that faces the same way. Between the middles of
 * samples, which are means over time, pressures are linear, so that their
 * impulse is kept. One factor makes the impulse on this surface that on the
 * recorded one.
 */
class RecordedLoads : public PressureHistory
{
public:
  /// Declares entries of the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads them. Empty without a file.
  /// @throws InputError when the file is none of loads
  static std::shared_ptr<RecordedLoads>
  parse_parameters(dealii::ParameterHandler &prm);

  void reinit(const std::vector<dealii::Point<3>> &middles,
              const std::vector<dealii::Tensor<1, 3>> &areas,
              MPI_Comm communicator) override;
  void set_time(double time) override;
  double pressure(std::size_t facet) const override;

  /// How well the facets fit, the factor of pressures, and the impulse of all
  /// samples on the recorded surface and, with the factor, on this one.
  /// Collective.
  std::vector<NamedValue> audit() const override;

private:
  void measure_impulses();
  /// Sums of impulses per area of the recorded facets. Collective.
  /// @throws InputError when too little of them arrives
  void sum_impulses(const std::vector<double> &impulse);

  std::unique_ptr<io::LoadReader> reader_;
  double offset_ = 0.; ///< of recorded times [s]
  double largest_distance_ = 0.;
  std::array<bool, 3> mirrored_{}; ///< across planes of symmetry through 0
  bool keep_impulse_ = true;
  double factor_ = 1.; ///< of pressures

  MPI_Comm communicator_ = MPI_COMM_SELF;
  std::vector<std::uint32_t> source_; ///< by facet of this rank
  std::vector<dealii::Tensor<1, 3>> areas_;
  std::vector<double> distances_;

  /// Samples in memory, [facet][time].
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::vector<float> samples_;
  /// Numbers of the samples around the time and the weight of the second.
  std::size_t before_ = 0;
  std::size_t after_ = 0;
  double weight_ = 0.;
  double started_ = 0.; ///< 0 before the first sample

  dealii::Tensor<1, 3> recorded_impulse_; ///< with mirrored facets [N s]
  dealii::Tensor<1, 3> mapped_impulse_;   ///< without the factor [N s]
};
} // namespace contrecoup::solid
