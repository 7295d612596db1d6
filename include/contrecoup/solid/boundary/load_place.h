// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape.h>
#include <contrecoup/io/load_file.h>

#include <deal.II/base/parameter_handler.h>

#include <array>

namespace contrecoup::solid
{
/// How facets that another run recorded lie on the surface of a body, as means
/// over their area.
struct LoadPlace
{
  double facet_edge = 0.; ///< of a square as large as the mean facet [m]
  double distance = 0.;   ///< of their middles from the surface [m]
  double agreement = 0.;  ///< cosine between their normals and the surface's
  /// From the middle of the box around the body to that around the facets, of
  /// both halves where loads are mirrored [m].
  dealii::Tensor<1, 3> offset;
};

/// Measures it. @param mirrored directions across planes of symmetry through 0
LoadPlace measure_load_place(const io::LoadFile::Facets &facets,
                             const Shape &surface,
                             const std::array<bool, 3> &mirrored);

/**
 * Refuses recorded loads (subsection "Loads/Recorded") that are not those of
 * the body that is meshed (Mesh/Kind = body), where it is, before it is meshed.
 * Does nothing without such loads or such a body.
 * @throws InputError that says how far off they are
 */
void check_load_place(dealii::ParameterHandler &prm);
} // namespace contrecoup::solid
