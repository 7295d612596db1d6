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
/// Sums over all ranks.
struct AleTotals
{
  double mass = 0.;
  dealii::Tensor<1, 3> momentum;
  double internal_energy = 0.;
  double kinetic_energy = 0.;
};

/**
 * A step in which the mesh moves with the matter, by the compatible staggered
 * scheme: velocities at the nodes, everything else in the cells, and the energy
 * of a cell changes by the work of its own forces on its corners (Caramana,
 * Burton, Shashkov and Whalen 1998). Two stages make it of second order: the
 * forces of the middle of the step act on the mean of the velocities before and
 * after it, so that the total energy changes by the work of walls and body
 * forces alone, to round-off.
 */
class LagrangeStep
{
public:
  /// Acceleration of everything over time [m/s^2].
  using Acceleration = std::function<dealii::Tensor<1, 3>(double)>;

  /// @param regions by material id of the mesh
  /// @param walls along which boundaries slide; all others are free surfaces
  /// @throws InputError for a plane that cuts the mesh, or without an interface
  /// to couple
  void
  reinit(const HexSpace &space,
         const std::vector<Region> &regions,
         const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls,
         const Acceleration &acceleration,
         const ContactPlanes &planes = {},
         const InterfaceCoupling &coupling = {});

  /// Sets masses of nodes from those of cells, and makes velocities obey walls.
  void start(AleState &state);

  /**
   * One step of at most this size, and of at most @p courant of what signals
   * allow; it is halved where a cell would be inverted or numbers would not be
   * finite.
   * @param is_as_left whether @p state is what the last call left, whose forces
   *   are then still known
   * @return its size [s]
   * @throws NumericsError, naming the cell, after @p largest_retries, where
   *   signals are too fast for any step, or where fluids and solids do not
   *   agree; the state is then that before the step
   */
  double advance(AleState &state,
                 const double largest_step,
                 const double courant,
                 const unsigned int largest_retries = 10,
                 const bool is_as_left = false);

  /// How often the last step was halved.
  unsigned int n_retries() const
  {
    return n_retries_;
  }

  /// Work that walls and body forces have done, all ranks [J]. Collective.
  double external_work() const;

  /// Sets what they had done before a restart [J]. Collective.
  void set_external_work(const double work);

  /// Adds what this rank's matter got otherwise [J].
  void add_external_work(const double work)
  {
    work_ += work;
  }

  /// What planes did: force and area in the last step, work of all steps, all
  /// ranks. Collective.
  ContactMeasures contact() const;

  /// Sets what they had done before a restart. Collective.
  void set_contact(const ContactMeasures &contact);

  /// Whether regions slide along each other.
  bool slips() const
  {
    return !ties_.empty();
  }

  /// The fastest of any two nodes along each other [m/s]. Collective.
  double largest_slip_speed(const AleState &state) const
  {
    return ties_.largest_slip_speed(state.velocity);
  }

  /// Work of the ties between regions that slide along each other, part of
  /// external_work(), all ranks [J]. Collective.
  double slip_work() const;

  /// Sets what it was before a restart. Collective.
  void set_slip_work(const double work);

  /// How fluids and solids are coupled.
  const InterfaceCoupling &coupling() const
  {
    return coupling_;
  }
  InterfaceCoupling &coupling()
  {
    return coupling_;
  }

  /// Collective.
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

  /// What own cell @p cell has now.
  CellValues values(const AleState &state, const std::size_t cell) const
  {
    return forces_.values(state, cell);
  }

private:
  /// What a step starts from.
  struct Start
  {
    dealii::AlignedVector<double> position, velocity, energy, relaxed;

    /// Leaves the positions and velocities of @p state to be set anew.
    void take(AleState &state)
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

  /// @param step see CornerForces::compute()
  void add_forces(AleState &state, const double step);
  void accelerate(AleState &state, const Start &start, const double step) const;
  void move(AleState &state, const Start &start, const double step) const;
  /// @return work that walls and body forces do on nodes of this rank [J]
  double move_by_mean(AleState &state, const Start &start, const double step);
  bool try_step(AleState &state, const Start &start, const double step);
  /// Whether all ranks have it good.
  bool all(const bool good) const;
  void book_contact(const ContactMeasures &now);
  [[noreturn]] void give_up(const AleState &state, const double step) const;
  /// Names the cell that allows the shortest step.
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

  Start start_;                         ///< of the present step
  bool has_forces_ = false;             ///< those after the last step
  dealii::AlignedVector<double> mean_;  ///< velocity of the present step [m/s]
  dealii::AlignedVector<double> force_; ///< on nodes, four each [N]
  double work_ = 0.;                    ///< of this rank [J]
  double slip_work_ = 0.;               ///< of this rank [J]
  unsigned int n_retries_ = 0;          ///< of the last step
  ContactMeasures contact_;             ///< of this rank
};
} // namespace contrecoup::ale
