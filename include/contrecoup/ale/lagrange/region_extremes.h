// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file/state_file.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cstdint>
#include <iosfwd>
#include <limits>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/// Extreme values in the cells or particles of a region; plain data for
/// checkpoints.
struct RegionExtremes
{
  double least_pressure = std::numeric_limits<double>::max();      ///< [Pa]
  double largest_pressure = std::numeric_limits<double>::lowest(); ///< [Pa]
  double shear_strain = 0.; ///< of solids, engineering, largest [-]
  double speed = 0.;        ///< of fluids, largest [m/s]
  double void_volume = 0.;  ///< of liquids, of the whole region [m^3]

  /// Extends the extremes by those of other cells or of another time.
  void include(const RegionExtremes &other)
  {
    least_pressure = std::min(least_pressure, other.least_pressure);
    largest_pressure = std::max(largest_pressure, other.largest_pressure);
    shear_strain = std::max(shear_strain, other.shear_strain);
    speed = std::max(speed, other.speed);
    void_volume = std::max(void_volume, other.void_volume);
  }
};

/**
 * Extremes of all steps for the rows of history.csv, which may leave steps out:
 * each row takes those since the row before. Ranks keep those of their own
 * cells until then.
 */
class ExtremeRecord
{
public:
  /// Forgets everything. @param n_regions number of regions
  void reinit(const std::size_t n_regions, const MPI_Comm communicator);

  /// Takes the state after a step, or the first one. @param own extremes in the
  /// cells of this rank, void volumes as well. Collective.
  void add(std::vector<RegionExtremes> own);

  /// Whether no state was taken since the last row.
  bool is_empty() const
  {
    return is_empty_;
  }

  /// Ends a row: extremes of all ranks since the row before. Collective.
  std::vector<RegionExtremes> take();

  /// Least pressure of each region in all rows so far; 0 if it is above [Pa].
  const std::vector<double> &least_pressures() const
  {
    return least_pressures_;
  }

  /// Whether the last row has the least pressure of a region, a tension.
  bool is_least_last(const std::size_t region) const
  {
    return region < is_last_.size() && is_last_[region] != 0;
  }

  /// Saves this rank's record.
  void save(io::StateWriter &out) const;

  /// Adds what a rank has saved. @throws InputError for one of another scene
  void restore(io::StateReader &in);

private:
  MPI_Comm communicator_ = MPI_COMM_SELF;
  bool is_empty_ = true;
  std::vector<RegionExtremes> extremes_; ///< since the last row
  std::vector<double> least_pressures_;
  std::vector<std::uint8_t> is_last_; ///< by region: the last row has these
};
} // namespace contrecoup::ale
