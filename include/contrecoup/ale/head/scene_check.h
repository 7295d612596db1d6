// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/impact_scene.h>

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/**
 * Compares the entries of a scene with one another before a run, for either
 * method: velocities and body forces across planes of symmetry are refused, as
 * are planes that cut the matter or that nothing can reach; a plane that is
 * reached after the end time is a warning. Every rank samples all the matter.
 */
class SceneCheck
{
public:
  /// @param scene must outlive this
  explicit SceneCheck(const ImpactScene &scene);

  /// Adds a position of matter of a region.
  void add_matter(const dealii::Point<3> &place, const unsigned int region);

  /// Adds a position of matter on the plane of symmetry normal to @p axis.
  /// @throws InputError for a velocity or a body force across the plane
  void add_on_symmetry_plane(const unsigned int axis,
                             const dealii::Point<3> &place,
                             const unsigned int region);

  /// Call after all matter has been added.
  /// @param others whether gas, heat or moving walls may drive matter
  /// @throws InputError for a plane that cuts the matter, or that none reaches
  void check_planes(const bool others) const;

private:
  /// A plane as seen from the matter.
  struct Approach
  {
    double gap = std::numeric_limits<double>::max(); ///< least distance [m]
    double speed = std::numeric_limits<double>::lowest(); ///< largest [m/s]
  };

  dealii::Tensor<1, 3> velocity_at(const dealii::Point<3> &place,
                                   const unsigned int region) const;
  /// Time at which matter with the largest speed and the body force has come
  /// nearer by the gap [s]; nothing until the end time.
  std::optional<double> time_of_contact(const Approach &approach,
                                        const ContactPlane &plane) const;
  /// Warns of regions of a head that do not have one velocity.
  void warn_of_velocities() const;

  const ImpactScene &scene_;
  std::vector<dealii::Tensor<1, 3>> velocities_; ///< by region; empty: vary
  std::vector<Approach> approaches_;             ///< by plane
};
} // namespace contrecoup::ale
