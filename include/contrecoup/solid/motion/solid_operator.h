// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/batch_corners.h>
#include <contrecoup/solid/body/element_options.h>

#include <functional>

namespace contrecoup::solid
{
/// Energies of a tissue [J].
struct TissueEnergies
{
  double kinetic = 0.;
  double stored = 0.;    ///< elastic strain energy
  double hourglass = 0.; ///< stored in hourglass modes
  double bulk_viscosity = 0.;
  double relaxation = 0.;        ///< dissipated in Prony branches
  double hourglass_damping = 0.; ///< dissipated in hourglass modes
  double pressure_smoothing = 0.;

  double internal() const
  {
    return stored + hourglass + bulk_viscosity + relaxation +
           hourglass_damping + pressure_smoothing;
  }
};

/// Strain and stress of one element, for output.
struct ElementValues
{
  Symmetric3<double> strain; ///< Green-Lagrange, or infinitesimal strain [-]
  Symmetric3<double> stress; ///< Cauchy stress [Pa]
  double dilatation = 0.;
  double volume = 0.; ///< undeformed [m^3]
};

/// Sizes of the time steps that forces and relaxation need.
struct StepTimes
{
  double before = 0.; ///< size of the last step [s]; 0 before the first
  /// from the time of stored relaxed strains to now [s]
  double relax_before = 0.;
  double relax_after = 0.; ///< half of the next step [s]
};

/// Internal forces of this rank's elements, their energies, and their strains
/// and stresses. Independent of other ranks and of loads.
template <typename Real>
class SolidOperator
{
public:
  /// @param materials by tissue of the mesh
  void reinit(const SolidMesh &mesh,
              const std::vector<SolidMaterial> &materials,
              const ElementOptions &options);

  /// Sets node coordinates, and all other fields to zero.
  void reinit_nodes(NodeFields<Real> &nodes) const;

  /// Lumped masses of the nodes [kg]: an eighth of each adjacent element's
  /// mass.
  std::vector<double> nodal_masses() const;

  /// Weights of the nodes in PressureSmoothing, of this rank's elements.
  std::vector<double> smoothing_weights() const;

  /// Whether pressures of any tissue are smoothed.
  bool smooths() const
  {
    return largest_bulk_ > 0.;
  }

  /// Adds internal forces to @p nodes and advances the history variables to
  /// the present.
  void add_forces(NodeFields<Real> &nodes, const StepTimes &times);

  /// Minimum dilatation over each tissue's elements at the last call of
  /// add_forces(); minus infinity if a value was not finite.
  const std::vector<double> &least_dilatations() const
  {
    return least_dilatations_;
  }

  /// Recomputes least_dilatations() from the history variables.
  void find_least_dilatations();

  /// The stored dilatation of an element.
  double dilatation(const std::uint32_t cell) const
  {
    const std::uint32_t slot = batches_.slot(cell);
    return batches_.dilatation[slot / n_lanes<Real>][slot % n_lanes<Real>];
  }

  /// Adds linear elastic forces for small displacements from rest, with
  /// instantaneous moduli. Pressure smoothing counts by its
  /// PressureSmoothing::stiffening(). Does not change history variables.
  void add_linear_forces(NodeFields<Real> &nodes);

  /// Energies by tissue, of this rank. Kinetic energy is half of v(t - dt / 2)
  /// M v(t + dt / 2), which central differences conserve exactly.
  std::vector<TissueEnergies> energies(const NodeFields<Real> &nodes,
                                       const StepTimes &times) const;

  /**
   * Estimates the stable step of the deformed elements of this rank [s]: the
   * minimum of @p body_step and, over all elements, max(body_step, step_e) /
   * sqrt(s_e), where step_e is the stable step of the single undeformed
   * element and s_e >= 1 the factor by which deformation stiffens the element.
   * Interaction with neighbours is ignored.
   * @param body_step stable step of the undeformed body [s]
   */
  double deformed_step(const NodeFields<Real> &nodes,
                       const double body_step) const;

  /// Calls @p function(local cell number, values) for each element, or for
  /// those of one tissue (index in SolidMesh::tissues).
  void visit(
    const NodeFields<Real> &nodes,
    const StepTimes &times,
    const std::function<void(std::uint32_t, const ElementValues &)> &function,
    const unsigned int tissue = all_tissues) const;
  static constexpr unsigned int all_tissues = -1;

  /// As visit(), for the elements of one tissue that are active; all others
  /// have zero strain and stress.
  void visit_active(
    const NodeFields<Real> &nodes,
    const StepTimes &times,
    const std::function<void(std::uint32_t, const ElementValues &)> &function,
    const unsigned int tissue) const;

  /// Values of one element.
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

  /// Dissipated energies by tissue, for checkpoints.
  std::vector<TissueEnergies> &losses()
  {
    return losses_;
  }
  const std::vector<TissueEnergies> &losses() const
  {
    return losses_;
  }

  /// v(t - dt / 2) v(t + dt / 2) of each node [m^2/s^2].
  std::vector<Real> velocity_squares(const NodeFields<Real> &nodes,
                                     const StepTimes &times) const;

private:
  using Lane = Lanes<Real>;
  using Range = typename HexBatches<Real>::Range;

  /// Hourglass control of a material.
  Hourglass<Lane> hourglass(const SolidMaterial &material) const;
  HexModel<Lane> model(const SolidMaterial &material,
                       const StepTimes &times) const;

  bool smooths(const SolidMaterial &material) const;

  /// The model of add_linear_forces().
  HexModel<Lane> linear_model(const SolidMaterial &material) const;

  /// Loop over the active batches of a tissue: adds the forces that @p
  /// find_forces(model, batch, corners, displacements, state, heat) returns.
  /// The state includes relaxed strains if @p viscoelastic.
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

  /// Secant bulk modulus of a tissue with gas: pressure over dilatation [Pa].
  Lane secant_bulk(const SolidLaw<Lane> &law,
                   const NodeFields<Real> &nodes,
                   const unsigned int batch) const;

  /// Whether shear is integrated at 2 x 2 x 2 points.
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
              const bool skip_inactive,
              const std::function<void(std::uint32_t, const ElementValues &)>
                &function) const;

  const SolidMesh *mesh_ = nullptr;
  std::vector<SolidMaterial> materials_;
  ElementOptions options_;
  double largest_bulk_ = 0.; ///< of smoothed tissues [Pa]; 0 without any
  HexBatches<Real> batches_;
  std::vector<TissueEnergies> losses_;    ///< by tissue
  std::vector<double> least_dilatations_; ///< by tissue
};
} // namespace contrecoup::solid
