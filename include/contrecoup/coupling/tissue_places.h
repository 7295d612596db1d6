// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

#include <deal.II/base/point.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// A place in a body whose history is of interest.
struct TissuePlace
{
  std::string name;
  dealii::Point<3> place; ///< [m]
};

/// Mass of a body of the density of water, by samples of that @p spacing [m]
/// [kg].
double estimate_mass(const Body &body, double spacing);

/**
 * Places that every report on a blast asks for, as far as the body has them:
 * "coup" and "contrecoup", the ends of the brain towards @p from and away
 * from it on the horizontal line through its centroid; "brain", its centroid;
 * "skull", the bone before the coup; "lung left" and "lung right", the
 * centroids of the lungs on both sides of their common one along y; "spinal
 * cord", its centroid. Each is moved to the nearest centre of an element of its
 * tissue.
 * @param from the charge [m]
 * @param spacing of the grid of samples, an element's edge [m]; ends are two
 * of them inside
 */
std::vector<TissuePlace> find_tissue_places(const Body &body,
                                            const dealii::Point<3> &from,
                                            double spacing);
} // namespace contrecoup::coupling
