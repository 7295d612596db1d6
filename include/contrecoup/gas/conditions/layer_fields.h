// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/materials/gas_material.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Two uniform states left and right of a plane of any direction, seen from
 * a frame that may move: subsection "Riemann".
 */
template <int dim>
class RiemannField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads subsection "Riemann" of the current one.
  RiemannField(ParameterHandler &prm, const GasMaterial &material);

  GasState<dim> value(const dealii::Point<dim> &point) const override;
  double distance_to_feature(const dealii::Point<dim> &point) const override;

  /// The states at rest with the frame, component 0 of the velocity being
  /// the one along the direction.
  const GasState<1> &left() const;
  const GasState<1> &right() const;

  /// Distance from the plane [m] in the moving frame, positive on the right.
  double distance(const dealii::Point<dim> &point, double time) const;

  /// What is @p state in the frame of its plane, in that of the mesh.
  GasState<dim> in_space(const GasState<1> &state) const;

private:
  GasState<1> left_, right_;
  double position_;
  dealii::Tensor<1, dim> direction_;
  dealii::Tensor<1, dim> frame_velocity_;
};

/**
 * Any number of uniform states between parallel planes: subsection "Layers".
 */
template <int dim>
class LayerField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads subsection "Layers" of the current one.
  LayerField(ParameterHandler &prm, const GasMaterial &material);

  GasState<dim> value(const dealii::Point<dim> &point) const override;
  double smallest_feature() const override;
  double distance_to_feature(const dealii::Point<dim> &point) const override;

private:
  dealii::Tensor<1, dim> direction_;
  std::vector<double> positions_;
  std::vector<GasState<dim>> states_;
};
} // namespace contrecoup::gas
