// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/state/gas_state.h>
#include <contrecoup/materials/gas_material.h>

#include <functional>
#include <vector>

namespace contrecoup::gas
{
/// Converts a primitive state to @p n_components conserved quantities
/// (density, momentum, energy, optionally products).
template <int dim>
std::vector<double> conserved_state(const GasState<dim> &state,
                                    const GasMaterial &material,
                                    const unsigned int n_components);

/// Converts conserved quantities to a primitive state.
template <int dim>
GasState<dim> primitive_state(const double *conserved,
                              const GasMaterial &material);

/**
 * Samples a field of primitive states at the points of a leaf and returns its
 * conserved quantities as [component][point]. A Galerkin node takes the
 * field's value (evaluated infinitesimally inside the leaf), a subcell its
 * mean. If @p near_feature, both take the mean over their subcell from @p
 * n_samples samples per direction, weighted with the volume element of the
 * coordinates.
 */
template <int dim>
std::vector<double> sample_leaf(
  const std::function<GasState<dim>(const dealii::Point<dim> &)> &field,
  const LeafBox<dim> &box,
  const LeafPoints<dim> &points,
  const GasMaterial &material,
  const unsigned int n_components,
  const bool near_feature,
  const unsigned int n_samples);
} // namespace contrecoup::gas
