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
/// Conserved quantities (density, momentum, energy, products if
/// @p n_components says so) of a primitive state.
template <int dim>
std::vector<double> conserved_state(const GasState<dim> &state,
                                    const GasMaterial &material,
                                    const unsigned int n_components);

/// The primitive state of conserved quantities.
template <int dim>
GasState<dim> primitive_state(const double *conserved,
                              const GasMaterial &material);

/**
 * The conserved quantities of a field at the points of a leaf,
 * [component][point]. Galerkin nodes take the field's value, infinitesimally
 * inside the leaf, and subcells its mean; near features of the field both
 * take the mean over their subcell from @p n_samples samples a side,
 * weighted with the volume of the coordinates.
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
