// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/scene_check.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Number of times at which body forces are sampled.
  constexpr unsigned int n_times = 200;

  /// Tolerance for the round-off of positions [m].
  constexpr double position_tolerance = 1e-9;

} // namespace


SceneCheck::SceneCheck(const ImpactScene &scene)
  : scene_(scene)
  , approaches_(scene.planes.planes().size())
{
  const RegionDescriptions &regions = scene.regions;
  const std::size_t n_regions = regions.regions().size();
  if (!regions.velocity_depends_on_place())
    for (unsigned int region = 0; region < n_regions; ++region)
      velocities_.push_back(regions.velocity_at({}, region));
}


dealii::Tensor<1, 3> SceneCheck::velocity_at(const dealii::Point<3> &place,
                                             const unsigned int region) const
{
  return velocities_.empty() ? scene_.regions.velocity_at(place, region)
                             : velocities_[region];
}


void SceneCheck::add_matter(const dealii::Point<3> &place,
                            const unsigned int region)
{
  if (approaches_.empty())
    return;
  const auto velocity = velocity_at(place, region);
  for (std::size_t i = 0; i < approaches_.size(); ++i)
  {
    const ContactPlane &plane = scene_.planes.planes()[i];
    Approach &approach = approaches_[i];
    approach.gap = std::min(approach.gap, plane.normal * (place - plane.point));
    approach.speed = std::max(approach.speed, -(plane.normal * velocity));
  }
}


void SceneCheck::add_on_symmetry_plane(const unsigned int axis,
                                       const dealii::Point<3> &place,
                                       const unsigned int region)
{
  const std::string name(1, "xyz"[axis]);
  const std::string remedy =
    ": take " + name + " from " +
    (scene_.mesh.wedge().active() ? "the planes through Mesh/Wedge axis"
                                  : "Mesh/Symmetry planes");
  // Round-off of expressions such as sin(pi).
  const auto velocity = velocity_at(place, region);
  constexpr double small = 1e-9;
  if (std::abs(velocity[axis]) > small * std::max(1., velocity.norm()))
    throw InputError("Region " + scene_.regions.regions()[region].name +
                     "/Velocity " + name + " is " + brief(velocity[axis]) +
                     " m/s across the plane of symmetry normal to " + name +
                     ", at (" + coordinates(place) + ") m" + remedy);
  const Expression &force = scene_.acceleration[axis];
  if (force.is_zero())
    return;
  for (unsigned int i = 0; i <= n_times; ++i)
  {
    const double time = scene_.end_time * i / n_times;
    if (const double value = force.value(place, time); std::abs(value) > small)
      throw InputError("Body force/" + name + " is " + brief(value) +
                       " m/s^2 across the plane of symmetry normal to " + name +
                       ", at (" + coordinates(place) + ") m and " +
                       brief(time) + " s" + remedy);
  }
}


std::optional<double>
SceneCheck::time_of_contact(const Approach &approach,
                            const ContactPlane &plane) const
{
  double speed = approach.speed, way = 0.;
  const double step = scene_.end_time / n_times;
  if (approach.gap <= position_tolerance && speed > 0.)
    return 0.;
  for (unsigned int i = 0; i < n_times; ++i)
  {
    double towards = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      towards -=
        plane.normal[d] * scene_.acceleration[d].value({}, (i + 0.5) * step);
    way += step * (speed + 0.5 * step * towards);
    speed += step * towards;
    if (way > 0. && way >= approach.gap)
      return (i + 1.) * step;
  }
  return {};
}


void SceneCheck::warn_of_velocities() const
{
  if (scene_.mesh.head() == nullptr)
    return;
  for (std::size_t i = 1; i < velocities_.size(); ++i)
    if (velocities_[i] != velocities_[0])
      log_line("WARNING: Region " + scene_.regions.regions()[i].name +
               "/Velocity: (" + coordinates(dealii::Point<3>(velocities_[i])) +
               ") m/s at the start, while region " +
               scene_.regions.regions()[0].name + " of the same head has (" +
               coordinates(dealii::Point<3>(velocities_[0])) + ") m/s");
}


void SceneCheck::check_planes(const bool others) const
{
  warn_of_velocities();
  const bool is_uniform =
    !velocities_.empty() &&
    std::all_of(velocities_.begin(),
                velocities_.end(),
                [&](const dealii::Tensor<1, 3> &velocity) {
                  return velocity == velocities_.front();
                });
  const bool forces_vary =
    std::any_of(scene_.acceleration.begin(),
                scene_.acceleration.end(),
                [](const Expression &one) { return one.depends_on_place(); });
  for (std::size_t i = 0; i < approaches_.size(); ++i)
  {
    const ContactPlane &plane = scene_.planes.planes()[i];
    const Approach &approach = approaches_[i];
    if (approach.gap < -position_tolerance)
      throw InputError("Plane " + plane.name +
                       ": it cuts the body at the start, which reaches " +
                       brief(-approach.gap) +
                       " m behind it; move Point, or turn Normal to the side "
                       "of the matter");
    if (forces_vary || time_of_contact(approach, plane))
      continue;
    const double gap =
                   approach.gap < 1e3 * position_tolerance ? 0. : approach.gap,
                 speed = approach.speed;
    const std::string where =
      "the body is " + brief(gap) + " m away and " +
      (speed > 0. ? "comes nearer at " + brief(speed) + " m/s"
                  : "does not come nearer");
    if (is_uniform && speed <= 0. && !others && !scene_.has_body_force() &&
        approaches_.size() == 1)
    {
      Selections selections;
      selections.add("Plane " + plane.name + "/Normal",
                     coordinates(plane.normal),
                     "matter that could reach it",
                     0);
      selections.require_some(MPI_COMM_SELF, where);
    }
    log_line("WARNING: Plane " + plane.name + ": " + where +
             (speed > 0. && !scene_.has_body_force()
                ? ", and reaches it at " + brief(gap / speed) + " s, after"
                : "; it is not expected to be reached before") +
             " Time/End time = " + brief(scene_.end_time) + " s");
  }
}
} // namespace contrecoup::ale
