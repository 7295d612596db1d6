// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/gas/conditions/initial_field.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>
#include <contrecoup/numerics/exact/vortex_solution.h>

namespace contrecoup::gas
{
/**
 * Point explosion: gas at rest with energy in a small ball around one point
 * (in plane 1-D geometry: next to one wall); subsection "Sedov". The energy
 * density is proportional to exp(-(r/radius)^2), so that any sampling finer
 * than half the radius integrates the energy to round-off.
 */
template <int dim>
class SedovField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads subsection "Sedov" of the current one.
  SedovField(ParameterHandler &prm,
             const GasMaterial &material,
             Geometry geometry);

  GasState<dim> value(const dealii::Point<dim> &point) const override;
  double smallest_feature() const override;
  double distance_to_feature(const dealii::Point<dim> &point) const override;
  std::optional<double> background_pressure() const override
  {
    return ambient.pressure;
  }

  unsigned int spreading; ///< 1 plane, 2 cylindrical, 3 spherical
  double energy; ///< released energy [J, J/m, J/m^2]; plane: to one side
  double radius; ///< of the deposit [m]
  dealii::Point<dim> center;
  GasState<dim> ambient;

private:
  GasMaterial material_;
};

/// Cold gas that flows towards a wall, axis or centre: subsection "Noh".
template <int dim>
class NohField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads subsection "Noh" of the current one.
  NohField(ParameterHandler &prm,
           const GasMaterial &material,
           Geometry geometry);

  GasState<dim> value(const dealii::Point<dim> &point) const override;

  unsigned int spreading; ///< 1 plane, 2 cylindrical, 3 spherical
  double speed;           ///< towards the centre [m/s]
  dealii::Point<dim> center;
  GasState<dim> ambient; ///< density and pressure; velocity unused
};

/// Shu's isentropic vortex in a periodic box: subsection "Vortex".
template <int dim>
class VortexField : public InitialField<dim>
{
public:
  static void declare_parameters(ParameterHandler &prm);

  /// Reads subsection "Vortex" of the current one.
  /// @throws InputError without a second plane coordinate, for a material
  /// that is no ideal gas, and for a core below absolute zero.
  VortexField(ParameterHandler &prm,
              const GasMaterial &material,
              Geometry geometry);

  GasState<dim> value(const dealii::Point<dim> &point) const override;
  double smallest_feature() const override;

  /// Exact solution at @p time [s].
  GasState<dim> value(const dealii::Point<dim> &point, double time) const;

private:
  VortexSolution solution_;
  double axial_velocity_;
};
} // namespace contrecoup::gas
