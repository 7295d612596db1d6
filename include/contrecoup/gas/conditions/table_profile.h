// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/gas_state.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Profile along one coordinate from a CSV file with the columns position [m],
 * density [kg/m^3], velocity [m/s], pressure [Pa] and optionally the mass
 * fraction of products [-]. Lines that start with # and one header line are
 * skipped; positions increase. Linear interpolation, constant beyond the ends.
 */
class TableProfile
{
public:
  /// @throws InputError, naming file and line, for a file that cannot be read
  /// or a line without valid values.
  explicit TableProfile(const std::string &file);

  GasState<1> value(double position) const;

  /// First and last position [m].
  double begin() const;
  double end() const;

private:
  std::vector<double> positions_;
  std::vector<GasState<1>> states_;
};
} // namespace contrecoup::gas
