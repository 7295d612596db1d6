// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/shape.h>
#include <contrecoup/io/output/load_file.h>
#include <contrecoup/io/output/load_reader.h>

#include <deal.II/base/parameter_handler.h>

#include <array>

namespace contrecoup::solid
{
/// Position of recorded facets relative to the surface of a body, as
/// area-weighted means.
struct LoadAlignment
{
  double facet_edge = 0.; ///< edge of a square with the mean facet area [m]
  double distance = 0.;   ///< from facet centres to the surface [m]
  double agreement = 0.;  ///< cosine between facet and surface normals
  /// Vector from the centre of the body's bounding box to that of the facets,
  /// including mirrored facets [m].
  dealii::Tensor<1, 3> offset;
};

/// Measures the position of facets. @param mirrored coordinate directions in
/// which facets are mirrored across a symmetry plane through 0
LoadAlignment measure_load_alignment(const io::LoadFile::Facets &facets,
                                     const Shape &surface,
                                     const std::array<bool, 3> &mirrored);

/**
 * Requires that loads of one side of a plane of symmetry reach both sides of a
 * body, and no others are mirrored.
 * @param box of the body or its surface
 * @throws InputError for a Loads/Recorded/Mirror that contradicts what the file
 * says of its symmetry
 */
void require_mirror(const io::LoadReader &loads,
                    const std::array<bool, 3> &mirrored,
                    const dealii::BoundingBox<3> &box);

/**
 * Checks before meshing that recorded loads (subsection "Loads/Recorded") fit
 * the surface of the body to mesh (Mesh/Kind = body). Does nothing without
 * recorded loads or such a body.
 * @throws InputError that states the misfit, and as require_mirror()
 */
void check_load_alignment(dealii::ParameterHandler &prm);
} // namespace contrecoup::solid
