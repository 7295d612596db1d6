// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/blast_record.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Whether the positive phase continues at the end of the record, @p time [s]:
/// then its impulse and duration are lower limits.
bool is_cut_off(const BlastMeasures &blast, const double time);


/// Places at which the record of a run is not whole.
class RecordGaps
{
public:
  /// @param time of the end of the record [s]
  /// @param kind of places, in plural
  /// @param unknown what else is unknown where the blast is cut off; or empty
  RecordGaps(const double time,
             const std::string &kind,
             const std::string &unknown = "");

  /// @param goes_on whether the blast does there after its positive phase
  void add(const std::string &place,
           const BlastMeasures &blast,
           const bool goes_on = false);

  /// A clause about all places without a whole record, for
  /// Simulation::gaps(); none without such places.
  std::vector<std::string> in_words() const;

private:
  std::string listed(const std::vector<std::string> &places) const;

  double time_;
  std::string kind_, unknown_;
  std::size_t n_all_ = 0;
  std::vector<std::string> unreached_, cut_;
};
} // namespace contrecoup::gas
