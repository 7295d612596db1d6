// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/record/impact_recorder.h>

namespace contrecoup::ale
{
/// Records the injury measures of a head, which record() takes from cells or
/// particles.
template <typename Snapshot>
class HeadRecorder : public HeadRecord, public ImpactRecorder<Snapshot>
{
public:
  using HeadRecord::declare_parameters;
  void parse_parameters(dealii::ParameterHandler &prm,
                        const ImpactScene & /*impact*/) override
  {
    HeadRecord::parse_parameters(prm);
  }
  void begin(const Snapshot &now) override
  {
    this->record(now);
  }
  std::vector<NamedValue> results(const Snapshot &now) const override
  {
    return HeadRecord::results(now.communicator, now.end);
  }
  void save(io::StateWriter &out) const override
  {
    save_record(out);
  }
  void restore(const Snapshot &now, io::StateReader &in) override
  {
    restore_record(in, now.communicator);
  }
};
} // namespace contrecoup::ale
