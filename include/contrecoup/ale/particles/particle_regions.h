// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_record.h>
#include <contrecoup/ale/particles/particle_recorder.h>

namespace contrecoup::ale
{
/// Records measures of each material, as RegionHistory does of the cells.
class ParticleRegions : public ParticleRecorder
{
public:
  void reinit(const ParticleSnapshot &now) override
  {
    extremes_.reinit(now.scene.materials().size(), now.communicator);
  }
  void record(const ParticleSnapshot &now) override;
  std::vector<NamedValue> history(const ParticleSnapshot &now) override;

  const ExtremeRecord &extremes() const
  {
    return extremes_;
  }

  void save(io::StateWriter &out) const override
  {
    extremes_.save(out);
  }
  void restore(const ParticleSnapshot & /*now*/, io::StateReader &in) override
  {
    extremes_.restore(in);
  }

private:
  ExtremeRecord extremes_;
};


/// Records the contact between regions that may separate.
class RegionContact : public ParticleRecorder
{
public:
  void record(const ParticleSnapshot &now) override;
  std::vector<NamedValue> results(const ParticleSnapshot &now) const override;

  void save(io::StateWriter &out) const override
  {
    out.put(contact_);
  }
  void restore(const ParticleSnapshot & /*now*/, io::StateReader &in) override
  {
    in.take(contact_);
  }

private:
  ContactRecord contact_;
};
} // namespace contrecoup::ale
