// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/cell_batches.h>
#include <contrecoup/ale/mesh/region.h>
#include <contrecoup/numerics/hex8_moving_solid.h>

namespace contrecoup::ale
{
/// What a cell has.
struct CellValues
{
  double mass = 0.;             ///< [kg]
  double energy = 0.;           ///< internal [J]
  double volume = 0.;           ///< [m^3]
  double pressure = 0.;         ///< without artificial viscosity [Pa]
  double void_fraction = 0.;    ///< part of the volume that cavitated [-]
  double shear_strain = 0.;     ///< largest engineering one; 0 in fluids [-]
  double principal_strain = 0.; ///< largest one; 0 in fluids [-]
};

/**
 * Forces of the own cells of a rank on their corners, and their work, which is
 * the change of the cells' energy.
 */
class CornerForces
{
public:
  /// @param regions by material id of the mesh, whose positions are those of
  /// the undeformed solids
  void reinit(const HexSpace &space, const std::vector<Region> &regions);

  /**
   * Finds the forces.
   * @param step that these are the middle of, over which solids relax; 0: at
   *   the start of one [s]
   * @param force on the nodes, AleState::width numbers each, to which the
   *   forces of own cells are added [N]
   */
  void compute(AleState &state,
               const double step,
               dealii::AlignedVector<double> &force);

  /// Whether all own cells had a volume above 0 when forces were found.
  bool has_volumes() const
  {
    return least_volume_ > 0.;
  }

  /// Inverse of the step that the cells of this rank allow [1/s].
  double signal_rate() const
  {
    return signal_rate_;
  }

  /// Inverse of the step that own cell @p cell allows; solids of any kinematics
  /// as if of finite rotation [1/s].
  double signal_rate(const AleState &state, const std::size_t cell) const;

  /// The name of the region of own cell @p cell.
  const std::string &region_name(const std::size_t cell) const
  {
    return regions_[space_->region(cell)].name;
  }

  /**
   * Adds the work of the forces to energies. In the first half of a step this
   * is done, and forces are kept for it, only where forces depend on energies.
   * @param before energies [J]
   * @param velocity of the nodes [m/s]
   * @param step [s]
   * @param after energies [J]
   * @return whether those of own cells are finite, as far as they were found
   */
  bool do_work(const dealii::AlignedVector<double> &before,
               const dealii::AlignedVector<double> &velocity,
               const double step,
               dealii::AlignedVector<double> &after,
               const bool is_first_half) const;

  /// What own cell @p cell has now.
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
  /// Keeps the forces of a batch, and takes them from those on the nodes.
  void store(const unsigned int batch,
             const HexVectors<Lane> &forces,
             dealii::AlignedVector<double> &force);
  /// Whether forces of a region depend on its energies.
  bool uses_energy(const unsigned int region) const;
  CellValues solid_values(const AleState &state, const std::size_t cell) const;

  const HexSpace *space_ = nullptr;
  std::vector<Region> regions_;
  CellBatches batches_;
  dealii::AlignedVector<double> undeformed_; ///< positions of the nodes [m]
  dealii::AlignedVector<Lane> forces_;       ///< 24 of each batch [N]
  bool keeps_forces_ = true;
  double signal_rate_ = 0.; ///< largest of this rank [1/s]
  /// Of this rank: of fluids [m^3], of solids over that undeformed [-].
  double least_volume_ = 0.;
};
} // namespace contrecoup::ale
