// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/materials/gas_material.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Riemann problem: two uniform states on either side of a plane of any
 * direction, given in a frame that may move; subsection "Riemann".
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

  /// States in the moving frame; velocity component 0 is along the normal.
  const GasState<1> &left() const;
  const GasState<1> &right() const;

  /// Signed distance from the moving plane [m] at @p time [s], positive on the
  /// right.
  double distance(const dealii::Point<dim> &point, double time) const;

  /// Transforms @p state from the frame of the plane to that of the mesh.
  GasState<dim> in_space(const GasState<1> &state) const;

private:
  GasState<1> left_, right_;
  double position_;
  dealii::Tensor<1, dim> direction_;
  dealii::Tensor<1, dim> frame_velocity_;
};

/**
 * Uniform states between parallel planes: subsection "Layers".
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
