// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/numerics/element/hex8_geometry.h>

namespace contrecoup::ale
{
/// The first three components of a nodal field (node_width numbers per
/// node) at the corners of a cell.
inline HexVectors<double> corners_of(const HexSpace::Cell &cell,
                                     const dealii::AlignedVector<double> &field)
{
  HexVectors<double> result;
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      result[i][d] = field[node_width * cell[i] + d];
  return result;
}
} // namespace contrecoup::ale
