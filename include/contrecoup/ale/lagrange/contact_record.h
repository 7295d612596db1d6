// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/lagrange/largest_mean.h>
#include <contrecoup/base/run/simulation.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace contrecoup::ale
{
/// Motion towards planes and course of the contact with them. Plain data,
/// written to checkpoints.
struct ContactRecord
{
  double begin = -1.;     ///< first time with a force; negative: none yet [s]
  double end = -1.;       ///< last time with a force [s]
  LargestMean mean_force; ///< which the body feels [N]
  /// Largest force of a step [N]: a node that meets the plane in it loses a
  /// momentum that does not depend on the size of the step.
  double step_force = 0.;
  double step_force_time = 0.; ///< [s]
  double peak_area = 0.;       ///< [m^2]
  double impulse = 0.;         ///< integral of the force [N s]
  double speed = -1.; ///< mean of all matter at the start; negative: unset
  double normal_speed = 0.; ///< towards the first plane [m/s]

  /// Takes the motion at the start, of @p momentum and @p mass.
  /// @param is_mirrored by axis, along which the whole body does not move
  template <typename Vector>
  void start(const ContactPlane &plane,
             const Vector &momentum,
             const double mass,
             const std::array<bool, 3> &is_mirrored)
  {
    dealii::Tensor<1, 3> velocity;
    for (unsigned int d = 0; d < 3; ++d)
      velocity[d] = is_mirrored[d] ? 0. : momentum[d] / mass;
    speed = velocity.norm();
    normal_speed = 0. - velocity * plane.normal;
  }

  /// Adds a step of size @p step that ended at @p time [s].
  void add(const ContactMeasures &contact, const double time, const double step)
  {
    mean_force.add(contact.force, time, step);
    if (!(contact.force > 0.))
      return;
    if (begin < 0.)
      begin = time - step;
    end = time;
    impulse += contact.force * step;
    peak_area = std::max(peak_area, contact.area);
    if (contact.force > step_force)
    {
      step_force = contact.force;
      step_force_time = time;
    }
  }

  /// Whether there is contact at time @p now [s] of the last step: then its end
  /// is unknown, and force, area and impulse are lower limits.
  bool lasts(const double now) const
  {
    return begin >= 0. && end >= (1. - 1e-9) * now;
  }

  /// Values for the summary at time @p now [s]: the motion at the start, and
  /// the contact if there was any.
  std::vector<NamedValue> values(const double now) const
  {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    std::vector<NamedValue> list;
    if (speed >= 0.)
      list = {{"impact_speed", "m/s", speed},
              {"normal_impact_speed", "m/s", normal_speed}};
    if (begin >= 0.)
      list.insert(
        list.end(),
        {{"contact_begin", "s", begin},
         {"contact_end", "s", lasts(now) ? unknown : end},
         {"contact_impulse", "N s", impulse},
         {"peak_contact_force", "N", mean_force.value},
         {"peak_contact_force_time", "s", std::max(begin, mean_force.time)},
         {"peak_contact_force_of_step", "N", step_force},
         {"peak_contact_force_of_step_time", "s", step_force_time},
         {"peak_contact_area", "m^2", peak_area}});
    if (lasts(now))
      list.push_back({"contact_cut_off", "-", 1.});
    return list;
  }
};
} // namespace contrecoup::ale
