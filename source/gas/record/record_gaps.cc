// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/record_gaps.h>

namespace contrecoup::gas
{
bool is_cut_off(const BlastMeasures &blast, const double time)
{
  return blast.peak > 0. &&
         blast.arrival + blast.duration >= time * (1. - 1e-9);
}


RecordGaps::RecordGaps(const double time,
                       const std::string &kind,
                       const std::string &unknown)
  : time_(time)
  , kind_(kind)
  , unknown_(unknown)
{}


void RecordGaps::add(const std::string &place,
                     const BlastMeasures &blast,
                     const bool goes_on)
{
  ++n_all_;
  if (blast.peak == 0.)
    unreached_.push_back(place);
  else if (goes_on || is_cut_off(blast, time_))
    cut_.push_back(place);
}


std::vector<std::string> RecordGaps::in_words() const
{
  std::vector<std::string> parts{"the record ends at " + brief(1e3 * time_, 4) +
                                 " ms"};
  if (!unreached_.empty())
    parts.push_back("not reached by a blast or its peak: " +
                    listed(unreached_) + ", where nothing is measured");
  if (!cut_.empty())
    parts.push_back("cut off in the positive phase: " + listed(cut_) +
                    ", where impulse and duration are lower limits" + unknown_);
  if (parts.size() == 1)
    return {};
  return {join(parts, "; ")};
}


std::string RecordGaps::listed(const std::vector<std::string> &places) const
{
  constexpr std::size_t most = 4;
  const std::size_t n = places.size();
  const std::string all = std::to_string(n_all_) + " " + kind_;
  return n == n_all_ && n > 1 ? "all " + all
         : n > most
           ? std::to_string(n) + " of " + all + ", as " + places.front()
           : join(places, ", ");
}
} // namespace contrecoup::gas
