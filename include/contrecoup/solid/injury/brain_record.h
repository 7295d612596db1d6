// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/injury/brain_measures.h>

#include <array>
#include <vector>

namespace contrecoup::solid
{
/// Recorded history of the brain and of the motion of the head.
struct BrainRecord
{
  std::uint64_t n_steps = 0;
  double last_time = 0.;            ///< of the last recording [s]
  BrainSums sums;                   ///< of this rank
  std::vector<BrainSample> samples; ///< of this rank
  HeadMotion motion;

  void save(io::StateWriter &out) const;

  /// Reads the record that a rank saved: samples of elements or particles that
  /// this rank owns now; the sums are continued by one rank. Call for each
  /// saved rank, in order. @throws InputError when the file holds no record
  void restore(io::StateReader &in, const MPI_Comm communicator);
};
} // namespace contrecoup::solid
