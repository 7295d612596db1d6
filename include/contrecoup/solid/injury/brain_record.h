// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/injury/brain_measures.h>

#include <array>
#include <iosfwd>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// What a brain, and the head around it, went through so far.
struct BrainRecord
{
  std::uint64_t n_steps = 0;
  double last_time = 0.;                ///< that the brain was looked at [s]
  BrainSums sums;                       ///< of this rank
  std::array<double, 3> largest_spin{}; ///< of the head [rad/s]
  std::vector<BrainPiece> pieces;       ///< of this rank
  std::vector<double> times;            ///< of the speeds [s]
  std::vector<std::array<double, 3>> speeds; ///< of the head [m/s]

  void save(std::ostream &out) const;

  /**
   * Takes up what @p rank had saved: the pieces that are here, and its sums if
   * they are to go on here. To be called for each rank that saved, in order.
   * @param file for messages
   * @throws InputError for what is no record
   */
  void restore(std::istream &in,
               const std::string &file,
               const unsigned int rank,
               const MPI_Comm communicator);
};
} // namespace contrecoup::solid
