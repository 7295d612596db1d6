// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/hex_space.h>

#include <deal.II/base/tensor.h>

#include <functional>

namespace contrecoup::ale
{
/// Area vector of a bilinear face [m^2].
/// @param position of the nodes, node_width numbers each [m]
dealii::Tensor<1, 3> area_vector(const std::array<std::uint32_t, 4> &nodes,
                                 const dealii::AlignedVector<double> &position);

/**
 * Outward area vector of the boundary at each node, including ghost copies: a
 * quarter of each adjacent boundary face [m^2]. Collective.
 * @param position of the nodes, node_width numbers each [m]
 * @param is_meant whether a boundary id counts
 */
std::vector<dealii::Tensor<1, 3>>
boundary_areas(const HexSpace &space,
               const dealii::AlignedVector<double> &position,
               const std::function<bool(dealii::types::boundary_id)> &is_meant);
} // namespace contrecoup::ale
