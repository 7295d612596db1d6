// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/gas_state.h>
#include <contrecoup/gas/leaf_points.h>
#include <contrecoup/materials/gas_material.h>

#include <functional>
#include <vector>

namespace contrecoup::gas
{
/// The shape of a leaf: a box, or the multilinear image of the unit cube.
template <int dim>
struct LeafBox
{
  /// Corner of smallest coordinates of the leaf or the box around it [m].
  dealii::Point<dim> origin;
  dealii::Tensor<1, dim> extents; ///< edge lengths of that box [m]
  /// Vertices, in deal.II's order, of a leaf that is no box; else empty [m].
  std::vector<dealii::Point<dim>> vertices;

  bool is_box() const
  {
    return vertices.empty();
  }

  /// The place at relative coordinates @p x.
  dealii::Point<dim> place(const dealii::Point<dim> &x) const;

  /// Volume of the leaf per volume of relative coordinates at @p x [m^dim].
  double jacobian(const dealii::Point<dim> &x) const;
};

/// Volume of the gas that point @p q of a leaf stands for; see
/// LeafPoints::volume().
template <int dim>
double point_volume(const LeafBox<dim> &box,
                    const LeafPoints<dim> &points,
                    const unsigned int q);

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
