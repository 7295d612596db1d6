// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <array>

namespace contrecoup::gas
{
/// Indices along the directions of point @p i of a lattice of @p n points a
/// side, whose first index runs fastest.
template <int dim>
std::array<unsigned int, dim> lattice_indices(unsigned int i,
                                              const unsigned int n)
{
  std::array<unsigned int, dim> result;
  for (unsigned int &index : result)
  {
    index = i % n;
    i /= n;
  }
  return result;
}
} // namespace contrecoup::gas
