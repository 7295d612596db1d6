// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/person.h>

#include <deal.II/base/point.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Named position in a body at which histories are recorded.
struct TissuePlace
{
  std::string name;
  dealii::Point<3> place; ///< [m]
};

/// Mass of a body [kg]: of its own hexahedra, else from samples of spacing
/// @p spacing [m].
/// @param density of a tissue [kg/m^3]
double estimate_mass(const Body &body,
                     double spacing,
                     const std::function<double(Tissue)> &density);

/**
 * Standard positions of a blast report, as far as the body has the tissues:
 * "coup" and "contrecoup", the ends of the brain towards @p from and away from
 * it on the horizontal line through its centroid; "brain", its centroid;
 * "skull", the bone in front of the coup; "lung left" and "lung right" of the
 * person, mirror images about the middle of the body from the left to the
 * right, near the centroids of its lungs;
 * "spinal cord", its centroid. Each is moved to the nearest centre of an
 * element of its tissue.
 *
 * @param from position of the charge [m]
 * @param axes of the person; without them, +y is the left
 * @param spacing spacing of the samples, an element's edge [m]; coup and
 * contrecoup lie two spacings inside
 */
std::vector<TissuePlace>
find_tissue_places(const Body &body,
                   const dealii::Point<3> &from,
                   const std::optional<PersonAxes> &axes,
                   double spacing);
} // namespace contrecoup::coupling
