// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_record.h>
#include <contrecoup/ale/mesh/whole_body.h>
#include <contrecoup/ale/record/impact_recorder.h>

namespace contrecoup::ale
{
/// Records the contact with rigid walls.
template <typename Snapshot>
class ContactHistory : public ImpactRecorder<Snapshot>
{
public:
  /// Takes the motion at the start, of @p momentum [N s] and @p mass [kg].
  template <typename Vector>
  void
  start(const ImpactScene &impact, const Vector &momentum, const double mass)
  {
    if (!impact.planes.empty())
      contact_.start(impact.planes.planes().front(),
                     momentum,
                     mass,
                     impact.mesh.symmetry_planes());
  }

  void record(const Snapshot &now) override
  {
    if (now.contact)
      contact_.add(*now.contact, now.time, now.step);
  }
  std::vector<NamedValue> results(const Snapshot &now) const override
  {
    if (!now.contact)
      return {};
    const MeshDescription &mesh = now.impact.mesh;
    std::vector<NamedValue> values = contact_.values(now.time);
    set_to_whole(values, mesh.computed_fraction(), mesh.symmetry_planes());
    return values;
  }

  /// The contact of the computed part of the body.
  const ContactRecord &contact() const
  {
    return contact_;
  }

  void save(io::StateWriter &out) const override
  {
    out.put(contact_);
  }
  void restore(const Snapshot & /*now*/, io::StateReader &in) override
  {
    in.take(contact_);
  }

private:
  ContactRecord contact_;
};
} // namespace contrecoup::ale
