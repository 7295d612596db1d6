// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/region_extremes.h>
#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/cell_batches.h>
#include <contrecoup/ale/mesh/region.h>
#include <contrecoup/numerics/element/hex8_moving_solid.h>

namespace contrecoup::ale
{
/// State of one cell.
struct CellValues
{
  double mass = 0.;          ///< [kg]
  double energy = 0.;        ///< internal [J]
  double volume = 0.;        ///< [m^3]
  double pressure = 0.;      ///< without artificial viscosity [Pa]
  double void_fraction = 0.; ///< cavitated part of the volume [-]
  /// largest engineering shear strain; 0 in fluids [-]
  double shear_strain = 0.;
  double principal_strain = 0.; ///< largest principal strain; 0 in fluids [-]
};

/// Forces of locally owned cells on their corners, and the work of these
/// forces, which changes the internal energy of the cells.
class CornerForces
{
public:
  /// @param regions by material id; the mesh holds the undeformed positions
  void reinit(const HexSpace &space, const std::vector<Region> &regions);

  /**
   * Computes the forces.
   * @param step size of the step whose midpoint this state is, over which
   * viscoelastic solids relax; 0: the start of a step [s]
   * @param force nodal forces, node_width numbers each, to which the
   * forces of owned cells are added [N]
   */
  void compute(AleState &state,
               const double step,
               dealii::AlignedVector<double> &force);

  /// Whether all owned cells had positive volume in the last compute().
  bool has_volumes() const
  {
    return least_volume_ > 0.;
  }

  /// Extremes of the regions in owned cells, of the last compute() with a step
  /// of 0.
  const std::vector<RegionExtremes> &extremes() const
  {
    return extremes_;
  }

  /// Inverse of the stable step of this rank's cells [1/s].
  double signal_rate() const
  {
    return signal_rate_;
  }

  /// Inverse of the stable step of owned cell @p cell [1/s]. Solids count as
  /// if with finite rotation.
  double signal_rate(const AleState &state, const std::size_t cell) const;

  /// Name of the region of owned cell @p cell.
  const std::string &region_name(const std::size_t cell) const
  {
    return regions_[space_->region(cell)].name;
  }

  /**
   * Adds the work of the forces to the internal energies. The first half step
   * does this, and keeps the forces for it, only where forces depend on
   * energy.
   * @param before internal energies [J]
   * @param velocity of the nodes [m/s]
   * @param step [s]
   * @param after internal energies [J]
   * @return whether all computed energies of owned cells are finite
   */
  bool add_work(const dealii::AlignedVector<double> &before,
                const dealii::AlignedVector<double> &velocity,
                const double step,
                dealii::AlignedVector<double> &after,
                const bool is_first_half) const;

  /// State of owned cell @p cell.
  CellValues values(const AleState &state, const std::size_t cell) const;

private:
  using Lane = CellBatches::Lane;

  template <typename Law>
  void add_fluid(const CellBatches::Range &range,
                 const Law &law,
                 const AleState &state,
                 dealii::AlignedVector<double> &force);
  template <SolidKinematics kinematics>
  void add_solid(const CellBatches::Range &range,
                 const double step,
                 AleState &state,
                 dealii::AlignedVector<double> &force);
  template <SolidKinematics kinematics, bool viscoelastic>
  void add_solid(const CellBatches::Range &range,
                 const MovingSolidModel<Lane> &model,
                 AleState &state,
                 dealii::AlignedVector<double> &force);
  /// Keeps the forces of a batch and subtracts them from the nodal forces.
  void store(const unsigned int batch,
             const HexVectors<Lane> &forces,
             dealii::AlignedVector<double> &force);
  /// Whether the forces of a region depend on internal energy.
  bool uses_energy(const unsigned int region) const;
  CellValues solid_values(const AleState &state, const std::size_t cell) const;

  const HexSpace *space_ = nullptr;
  std::vector<Region> regions_;
  CellBatches batches_;
  dealii::AlignedVector<double> undeformed_; ///< positions of the nodes [m]
  dealii::AlignedVector<Lane> forces_;       ///< 24 per batch [N]
  bool keeps_forces_ = true;
  bool keeps_extremes_ = true;
  std::vector<RegionExtremes> extremes_;
  double signal_rate_ = 0.; ///< largest of this rank [1/s]
  /// Least of this rank; fluids: volume [m^3], solids: volume ratio [-].
  double least_volume_ = 0.;
};
} // namespace contrecoup::ale
