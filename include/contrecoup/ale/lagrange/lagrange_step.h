// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/contact_planes.h>
#include <contrecoup/ale/lagrange/corner_forces.h>
#include <contrecoup/ale/lagrange/interface_coupling.h>
#include <contrecoup/ale/lagrange/slip_ties.h>
#include <contrecoup/ale/mesh/field_exchange.h>

#include <deal.II/base/tensor.h>

namespace contrecoup::ale
{
/// Totals over all ranks [kg, N s, J].
struct AleTotals
{
  double mass = 0.;
  dealii::Tensor<1, 3> momentum;
  double internal_energy = 0.;
  double kinetic_energy = 0.;
};

/**
 * Lagrangian step with the compatible staggered scheme: velocities at nodes,
 * all other variables in cells. The internal energy of a cell changes by the
 * work of its own corner forces (Caramana, Burton, Shashkov and Whalen 1998).
 * The two-stage scheme is of second order: forces at the middle of the step
 * act on the mean of the velocities before and after it. Total energy thus
 * changes only by the work of walls and body forces, up to round-off.
 */
class LagrangeStep
{
public:
  /// Body force per mass as a function of time [m/s^2].
  using Acceleration = std::function<dealii::Tensor<1, 3>(double)>;

  /// @param regions by material id of the mesh
  /// @param walls slip walls by boundary id; other boundaries are free
  /// surfaces
  /// @throws InputError for a partitioned coupling without interface
  void
  reinit(const HexSpace &space,
         const std::vector<Region> &regions,
         const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls,
         const Acceleration &acceleration,
         const ContactPlanes &planes = {},
         const InterfaceCoupling &coupling = {});

  /// Computes nodal masses from cell masses, and imposes wall velocities.
  void start(AleState &state);

  /**
   * Makes one step of at most @p largest_step [s] and of at most @p courant
   * times the CFL limit. The step is halved and repeated if a cell inverts or
   * a value is not finite.
   * @param state_is_unchanged whether @p state is unchanged since the last
   * call, so that its forces can be reused
   * @return size of the step [s]
   * @throws NumericsError, naming the cell, after @p largest_retries halvings,
   * when the CFL limit vanishes, or when the coupling iteration fails; the
   * state is then that before the step
   */
  double advance(AleState &state,
                 const double largest_step,
                 const double courant,
                 const unsigned int largest_retries = 10,
                 const bool state_is_unchanged = false);

  /// Number of halvings of the last step.
  unsigned int n_retries() const
  {
    return n_retries_;
  }

  /// Work of walls and body forces on all ranks [J]. Collective.
  double external_work() const;

  /// Restores external_work() from a checkpoint [J]. Collective.
  void set_external_work(const double work);

  /// Adds other energy input to the matter of this rank [J].
  void add_external_work(const double work)
  {
    work_ += work;
  }

  /// Contact with planes, of all ranks: force and area of the last step, work
  /// of all steps. Collective.
  ContactMeasures contact() const;

  /// Restores contact() from a checkpoint. Collective.
  void set_contact(const ContactMeasures &contact);

  /// Whether regions slide along each other.
  bool slips() const
  {
    return !ties_.empty();
  }

  /// Largest relative tangential speed of two tied nodes [m/s]. Collective.
  double largest_slip_speed(const AleState &state) const
  {
    return ties_.largest_slip_speed(state.velocity);
  }

  /// Work of the slip ties on all ranks, included in external_work() [J].
  /// Collective.
  double slip_work() const;

  /// Restores slip_work() from a checkpoint. Collective.
  void set_slip_work(const double work);

  /// Coupling of fluids and solids.
  const InterfaceCoupling &coupling() const
  {
    return coupling_;
  }
  InterfaceCoupling &coupling()
  {
    return coupling_;
  }

  /// Extremes of the regions in cells of this rank after the last step.
  const std::vector<RegionExtremes> &extremes() const
  {
    return forces_.extremes();
  }

  /// Totals of mass, momentum and energy. Collective.
  AleTotals totals(const AleState &state) const;

  const SlipWalls &walls() const
  {
    return walls_;
  }

  /// See SlipWalls::mirror().
  void mirror(const HexWedge &wedge)
  {
    walls_.mirror(*space_, wedge);
  }

  /// State of owned cell @p cell.
  CellValues values(const AleState &state, const std::size_t cell) const
  {
    return forces_.values(state, cell);
  }

private:
  /// State at the start of a step.
  struct Start
  {
    dealii::AlignedVector<double> position, velocity, energy, relaxed;

    /// Swaps positions and velocities out of @p state; they must be set again.
    void swap_from(AleState &state)
    {
      position.resize_fast(state.position.size());
      position.swap(state.position);
      velocity.resize_fast(state.velocity.size());
      velocity.swap(state.velocity);
      energy = state.energy;
      relaxed = state.relaxed;
    }
    void give_back(AleState &state) const
    {
      state.position = position;
      state.velocity = velocity;
      state.energy = energy;
      state.relaxed = relaxed;
    }
  };

  /// @param step as for CornerForces::compute()
  void add_forces(AleState &state, const double step);
  void accelerate(AleState &state, const Start &start, const double step) const;
  void move(AleState &state, const Start &start, const double step) const;
  /// @return work of walls and body forces on nodes of this rank [J]
  double move_by_mean(AleState &state, const Start &start, const double step);
  bool try_step(AleState &state, const Start &start, const double step);
  /// Whether @p good holds on all ranks.
  bool all(const bool good) const;
  void add_contact(const ContactMeasures &now);
  [[noreturn]] void throw_step_failure(const AleState &state,
                                       const double step) const;
  /// Names the cell with the most restrictive CFL limit.
  [[noreturn]] void give_up_signals(const AleState &state,
                                    const double step) const;

  const HexSpace *space_ = nullptr;
  SlipWalls walls_;
  SlipTies ties_;
  ContactPlanes planes_;
  InterfaceCoupling coupling_;
  Acceleration acceleration_;
  CornerForces forces_;
  FieldExchange node_exchange_;

  Start start_; ///< of the current step
  /// whether force_ belongs to the state after the last step
  bool has_forces_ = false;
  /// mean velocity of the current step [m/s]
  dealii::AlignedVector<double> mean_;
  /// nodal forces, four numbers each [N]
  dealii::AlignedVector<double> force_;
  double work_ = 0.;           ///< of this rank [J]
  double slip_work_ = 0.;      ///< of this rank [J]
  unsigned int n_retries_ = 0; ///< of the last step
  ContactMeasures contact_;    ///< of this rank
};
} // namespace contrecoup::ale
