// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/base/simulation.h>

namespace contrecoup::ale
{
/// The contact with planes in the course of a run: numbers alone, for
/// checkpoints.
struct ContactRecord
{
  double begin = -1.;     ///< first time with a force; below 0: none yet [s]
  double end = -1.;       ///< last time with a force [s]
  double peak_force = 0.; ///< [N]
  double peak_time = 0.;  ///< of that force [s]
  double peak_area = 0.;  ///< [m^2]
  double impulse = 0.;    ///< of the force [N s]

  /// Takes a step of size @p step that ended at @p time [s].
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

  /// For the summary; empty without a contact.
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
