// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/octree/leaf_layout.h>

namespace contrecoup::gas
{
LeafLayout::LeafLayout(const unsigned int dim,
                       const unsigned int n,
                       const unsigned int n_components,
                       const Precision precision)
  : n(n)
  , n_components(n_components)
  , precision(precision)
  , width(batch_width(precision))
  , width_bits(floor_log2(width))
{
  for (unsigned int d = 0; d < dim; ++d)
    n_points *= n;
  n_face_points = n_points / n;
}
} // namespace contrecoup::gas
