// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>

#include <array>

namespace contrecoup::ale
{
/// Whether a symmetry plane is normal to each axis. The boundary ids of
/// symmetry planes are 1 to 3, by axis.
using SymmetryPlanes = std::array<bool, 3>;

/// Declares entries "Symmetry planes" and "Wedge axis" of subsection "Mesh".
void declare_symmetry_planes(dealii::ParameterHandler &prm);

/// Reads entry "Wedge axis"; 3: none.
unsigned int read_wedge_axis(dealii::ParameterHandler &prm);

/// Reads the symmetry planes, including those through a wedge axis.
/// @throws InputError for an invalid axis
SymmetryPlanes read_symmetry_planes(dealii::ParameterHandler &prm);

/// Computed part of the body; 1 without symmetry planes [-].
double fraction_within(const SymmetryPlanes &planes);
} // namespace contrecoup::ale
