// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <array>

namespace contrecoup::ale
{
/// Whether a plane of symmetry is normal to each axis. Boundary ids of these
/// planes are 1 to 3, by axis.
using SymmetryPlanes = std::array<bool, 3>;

/// Entries "Symmetry planes" and "Wedge axis" of the present subsection, that
/// of the mesh.
void declare_symmetry_planes(dealii::ParameterHandler &prm);

/// Entry "Wedge axis" of the present subsection; 3: there is none.
unsigned int read_wedge_axis(dealii::ParameterHandler &prm);

/// Those through the axis of a wedge among them.
/// @throws InputError for what is no axis
SymmetryPlanes read_symmetry_planes(dealii::ParameterHandler &prm);

/// Part of the body that is computed, 1 without a plane [-].
double computed_part(const SymmetryPlanes &planes);
} // namespace contrecoup::ale
