// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>

#include <string>
#include <vector>

namespace contrecoup::gas
{
/**
 * Uniform background, subsection "Background", with regions of simple shape
 * and uniform state, subsections "Region <name>". Where regions overlap, the
 * last one counts.
 */
template <int dim>
class RegionField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads the subsections of the current one, which is "Initial state".
  /// @param with_regions whether to read the regions too
  RegionField(ParameterHandler &prm,
              const GasMaterial &material,
              Geometry geometry,
              bool with_regions);

  GasState<dim> value(const dealii::Point<dim> &point) const override;
  double smallest_feature() const override;
  double distance_to_feature(const dealii::Point<dim> &point) const override;
  std::optional<double> background_pressure() const override
  {
    return background_.pressure;
  }

private:
  struct Region
  {
    std::string shape;
    dealii::Point<dim> center, lower, upper;
    dealii::Tensor<1, dim> normal;
    double radius;
    GasState<dim> state;
  };

  static Region read_region(ParameterHandler &prm,
                            const GasMaterial &material,
                            Geometry geometry,
                            const std::string &where);

  /// Volume [m^3; per m or m^2 of the directions that are not resolved].
  static double volume(const Region &region, Geometry geometry);

  /// Signed distance [m] from the region's surface, negative inside.
  static double signed_distance(const Region &region,
                                const dealii::Point<dim> &point);

  GasState<dim> background_;
  std::vector<Region> regions_;
};
} // namespace contrecoup::gas
