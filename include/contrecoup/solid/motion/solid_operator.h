// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/element_options.h>
#include <contrecoup/solid/body/hex_batches.h>

#include <functional>

namespace contrecoup::solid
{
/// Where the energy of a tissue is, or went [J].
struct TissueEnergies
{
  double kinetic = 0.;
  double stored = 0.;    ///< in strains
  double hourglass = 0.; ///< in hourglass modes, or lost in their dampers
  double bulk_viscosity = 0.;
  double relaxation = 0.; ///< lost in Prony branches

  double internal() const
  {
    return stored + hourglass + bulk_viscosity + relaxation;
  }
};

/// The state of an element, for output.
struct ElementValues
{
  Symmetric3<double> strain; ///< Green's, or the small one [-]
  Symmetric3<double> stress; ///< Cauchy's [Pa]
  double dilatation = 0.;
  double volume = 0.; ///< undeformed [m^3]
};

/// The step that led to the present, and how far relaxation goes.
struct StepTimes
{
  double before = 0.;       ///< size of the last step; 0: none was made [s]
  double relax_before = 0.; ///< from where relaxed strains stand to now [s]
  double relax_after = 0.;  ///< half of the next step [s]
};

/**
 * Internal forces of a rank's elements, and what can be said of these.
 * Knows neither other ranks nor loads.
 */
template <typename Real>
class SolidOperator
{
public:
  /// @param materials by tissue of the mesh
  void reinit(const SolidMesh &mesh,
              const std::vector<SolidMaterial> &materials,
              const ElementOptions &options);

  /// Coordinates, and everything else zero.
  void reinit_nodes(NodeFields<Real> &nodes) const;

  /// An eighth of each element's mass at its corners [kg].
  std::vector<double> nodal_masses() const;

  /// Adds internal forces, and brings the elements' state to the present.
  void add_forces(NodeFields<Real> &nodes, const StepTimes &times);

  /// The least dilatation of each tissue's elements in the last add_forces();
  /// minus infinity when numbers were not finite.
  const std::vector<double> &least_dilatations() const
  {
    return least_dilatations_;
  }

  /// Finds these in the elements' memory.
  void find_least_dilatations();

  /// The dilatation that an element remembers.
  double dilatation(const std::uint32_t cell) const
  {
    const std::uint32_t slot = batches_.slot(cell);
    return batches_.dilatation[slot / n_lanes<Real>][slot % n_lanes<Real>];
  }

  /// Adds the forces of small displacements of a body at rest, with the
  /// instantaneous moduli; changes no state.
  void add_linear_forces(NodeFields<Real> &nodes);

  /// Energies by tissue, of this rank. Kinetic ones are half of v(before) M
  /// v(after a step) around the present, which is conserved exactly.
  std::vector<TissueEnergies> energies(const NodeFields<Real> &nodes,
                                       const StepTimes &times) const;

  /**
   * What deformed elements allow as a step [s], where at rest the body allows
   * @p body_step and each element alone its own: of no element less than it
   * allows alone now, nor than the body's step by the square root of what it
   * has stiffened. Of this rank; an estimate, since neighbours are not looked
   * at.
   */
  double deformed_step(const NodeFields<Real> &nodes,
                       const double body_step) const;

  /// Calls @p function for each element (number in the mesh of this rank), or
  /// for those of one tissue (index in the mesh).
  void visit(
    const NodeFields<Real> &nodes,
    const StepTimes &times,
    const std::function<void(std::uint32_t, const ElementValues &)> &function,
    const unsigned int tissue = all_tissues) const;
  static constexpr unsigned int all_tissues = -1;

  /// The same for those of one tissue near which something has moved; all
  /// others have no strain and no stress.
  void visit_moved(
    const NodeFields<Real> &nodes,
    const StepTimes &times,
    const std::function<void(std::uint32_t, const ElementValues &)> &function,
    const unsigned int tissue) const;

  /// One element.
  ElementValues values(const NodeFields<Real> &nodes,
                       const StepTimes &times,
                       const std::uint32_t cell) const;

  HexBatches<Real> &batches()
  {
    return batches_;
  }
  const HexBatches<Real> &batches() const
  {
    return batches_;
  }

  const std::vector<SolidMaterial> &materials() const
  {
    return materials_;
  }

  /// What was turned into heat so far, for checkpoints.
  std::vector<TissueEnergies> &losses()
  {
    return losses_;
  }
  const std::vector<TissueEnergies> &losses() const
  {
    return losses_;
  }

  /// v(before) v(after a step) of each node [m^2/s^2].
  std::vector<Real> velocity_squares(const NodeFields<Real> &nodes,
                                     const StepTimes &times) const;

private:
  using Lane = Lanes<Real>;
  using Range = typename HexBatches<Real>::Range;

  /// What resists hourglass modes of a material.
  Hourglass<Lane> hourglass(const SolidMaterial &material) const;
  HexModel<Lane> model(const SolidMaterial &material,
                       const StepTimes &times) const;

  /// The model of small strains of a body at rest.
  HexModel<Lane> linear_model(const SolidMaterial &material) const;

  /// Adds the forces of batches that are awake, which @p find_forces gives
  /// for a model, batch, corners, displacements, state and heat; with relaxed
  /// strains in the state of viscoelastic ones.
  template <bool viscoelastic, typename Forces>
  void add_batches(const Range &range,
                   NodeFields<Real> &nodes,
                   const HexModel<Lane> &model,
                   TissueEnergies &losses,
                   const Forces &find_forces);
  template <SolidKinematics kinematics, bool viscoelastic>
  void add_range(const Range &range,
                 NodeFields<Real> &nodes,
                 const HexModel<Lane> &model,
                 TissueEnergies &losses);
  template <SolidKinematics kinematics>
  void add_all(NodeFields<Real> &nodes, const StepTimes &times);

  /// What a batch has in place of K where gas makes its pressure: the pressure
  /// over the dilatation [Pa].
  Lane secant_bulk(const SolidLaw<Lane> &law,
                   const NodeFields<Real> &nodes,
                   const unsigned int batch) const;

  /// Whether shear is integrated in eight points.
  bool full() const
  {
    return options_.integration == Integration::full;
  }
  template <SolidKinematics kinematics, bool viscoelastic>
  void add_full_range(const Range &range,
                      NodeFields<Real> &nodes,
                      const HexModel<Lane> &model,
                      TissueEnergies &losses);
  void add_full_forces(NodeFields<Real> &nodes, const StepTimes &times);
  void add_full_linear_forces(NodeFields<Real> &nodes);
  template <SolidKinematics kinematics>
  void energies_of(const Range &range,
                   const NodeFields<Real> &nodes,
                   const StepTimes &times,
                   const std::vector<Real> &squares,
                   TissueEnergies &sum) const;
  using Values = std::array<ElementValues, n_lanes<Real>>;
  template <SolidKinematics kinematics>
  void visit_batch(const Range &range,
                   const unsigned int batch,
                   const NodeFields<Real> &nodes,
                   const HexModel<Lane> &model,
                   Values &values) const;
  void visit_any(const Range &range,
                 const unsigned int batch,
                 const NodeFields<Real> &nodes,
                 const HexModel<Lane> &model,
                 Values &values) const;
  void
  visit_range(const Range &range,
              const NodeFields<Real> &nodes,
              const StepTimes &times,
              const bool moved,
              const std::function<void(std::uint32_t, const ElementValues &)>
                &function) const;

  const SolidMesh *mesh_ = nullptr;
  std::vector<SolidMaterial> materials_;
  ElementOptions options_;
  HexBatches<Real> batches_;
  std::vector<TissueEnergies> losses_;    ///< by tissue
  std::vector<double> least_dilatations_; ///< by tissue
};
} // namespace contrecoup::solid
