// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/base/run/simulation.h>

namespace contrecoup::ale
{
/// Course of the contact with planes. Plain data, written to checkpoints.
struct ContactRecord
{
  double begin = -1.;     ///< first time with a force; negative: none yet [s]
  double end = -1.;       ///< last time with a force [s]
  double peak_force = 0.; ///< [N]
  double peak_time = 0.;  ///< of that force [s]
  double peak_area = 0.;  ///< [m^2]
  double impulse = 0.;    ///< integral of the force [N s]

  /// Adds a step of size @p step that ended at @p time [s].
  void add(const ContactMeasures &contact, const double time, const double step)
  {
    if (!(contact.force > 0.))
      return;
    if (begin < 0.)
      begin = time - step;
    end = time;
    impulse += contact.force * step;
    peak_area = std::max(peak_area, contact.area);
    if (contact.force > peak_force)
    {
      peak_force = contact.force;
      peak_time = time;
    }
  }

  /// Values for the summary; empty without contact.
  std::vector<NamedValue> values() const
  {
    if (begin < 0.)
      return {};
    return {{"contact_begin", "s", begin},
            {"contact_end", "s", end},
            {"contact_impulse", "N s", impulse},
            {"peak_contact_force", "N", peak_force},
            {"peak_contact_force_time", "s", peak_time},
            {"peak_contact_area", "m^2", peak_area}};
  }
};
} // namespace contrecoup::ale
