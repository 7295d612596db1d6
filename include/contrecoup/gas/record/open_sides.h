// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>

#include <array>
#include <limits>
#include <vector>

namespace contrecoup::gas
{
/**
 * Records when a blast reaches the open sides of a box: when the overpressure
 * in a leaf at the side first exceeds BlastRecord::threshold times the ambient
 * pressure, with a delay of at most `interval` steps.
 */
template <int dim>
class OpenSides : public Recorder<dim>
{
public:
  static constexpr unsigned int interval = 8;

  static constexpr double never = std::numeric_limits<double>::max();

  OpenSides()
  {
    arrivals_.fill(never);
  }

  void parse_parameters(dealii::ParameterHandler & /*prm*/,
                        const GasScene<dim> & /*scene*/) override
  {}
  void mesh_changed(const GasSnapshot<dim> &gas) override;
  void add_step(const GasSnapshot<dim> &gas) override;
  void reduce_over_ranks() override;
  void save(std::ostream &stream, const std::string &folder) const override;
  void load(std::istream &stream, const std::string &folder) override;

  /// Time of arrival [s] per side, or `never`; sides 2 d and 2 d + 1 are the
  /// lower and upper ends of direction d. Valid for all ranks after
  /// reduce_over_ranks().
  const std::array<double, 2 * dim> &arrivals() const
  {
    return arrivals_;
  }

private:
  /// Leaves at open sides, by side.
  std::array<std::vector<unsigned int>, 2 * dim> leaves_;
  std::array<double, 2 * dim> arrivals_;
  MPI_Comm communicator_ = MPI_COMM_SELF;
};
} // namespace contrecoup::gas
