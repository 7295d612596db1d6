// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/node_exchange.h>
#include <contrecoup/solid/boundary/slip_ties.h>
#include <contrecoup/solid/boundary/supports.h>
#include <contrecoup/solid/boundary/surface_loads.h>
#include <contrecoup/solid/boundary/surroundings.h>
#include <contrecoup/solid/motion/energy_ledger.h>
#include <contrecoup/solid/motion/mass_scaling.h>
#include <contrecoup/solid/motion/node_motion.h>
#include <contrecoup/solid/motion/solid_operator.h>

#include <memory>

namespace contrecoup::solid
{
/// Stable step of the assembled body, and of its most restrictive element.
struct StableStep
{
  double body_step = 0.;     ///< 2 / omega_max of the body [s]
  double uncertainty = 0.;   ///< of omega_max, relative
  double element_step = 0.;  ///< smallest step of any single element [s]
  std::uint32_t element = 0; ///< the element with that step, in the whole mesh
  Tissue tissue = Tissue::none; ///< tissue of the element
  dealii::Point<3> center;      ///< centre of the element [m]
  unsigned int iterations = 0;
};

/// A deformable body: mesh, state, and explicit central-difference time steps
/// with a lumped mass. Every function is collective.
template <typename Real>
class SolidBody
{
public:
  /// Enables mass scaling for elements with a stable step below @p step [s];
  /// 0: none. Call before reinit().
  void set_smallest_step(const double step)
  {
    smallest_step_ = step;
  }

  /// Lets tissues slide. Call before reinit().
  void set_slip(const SlipTies &slip)
  {
    slip_ = slip;
  }
  const SlipTies &slip() const
  {
    return slip_;
  }

  const Supports &supports() const
  {
    return supports_;
  }

  /**
   * Builds this rank's part of the body, at rest.
   * @throws InputError for inverted elements
   */
  void reinit(
    const HexMesh &mesh,
    const std::function<std::vector<SolidMaterial>(const std::vector<Tissue> &)>
      &find_materials,
    const ElementOptions &options,
    const Supports &supports,
    const SurfaceLoads &loads,
    MPI_Comm communicator);

  /// The largest stable step without bulk viscosity, by Lanczos iteration.
  /// Call at rest only: the method uses displacements and velocities as work
  /// vectors and sets them to zero.
  StableStep find_stable_step();

  /// Sets gravity and ground; Surroundings::set_step() must have been called.
  void set_surroundings(const Surroundings &surroundings)
  {
    surroundings_ = surroundings;
  }

  /// Fraction of element updates that were skipped because nothing had moved
  /// there. After a restart all are computed.
  double skipped_fraction() const;

  /// Force of the ground on the body [N].
  double ground_force() const;

  /// Computes the forces of a state that was set from outside. @param time of
  /// the state [s]
  void start(const double time);

  /// A completed step.
  struct Advance
  {
    double step;          ///< size [s]
    unsigned int retries; ///< number of times that it was halved
  };

  /**
   * Makes one step of at most the size @p step. The step is halved and
   * repeated if an element inverts, if the most compressed element of a tissue
   * loses a fifth of its volume, or if a value is not finite.
   * @throws NumericsError, naming the element, when @p largest_retries
   * halvings do not help; the state is then that before the step
   */
  Advance advance(const double step, const unsigned int largest_retries = 10);

  /// Smallest stable step of any element of the tissues with gas, at the
  /// largest compression of the tissue [s].
  double compressed_step() const;

  /// SolidOperator::deformed_step(), minimum over all ranks.
  double deformed_step(const double body_step) const
  {
    return dealii::Utilities::MPI::min(
      operator_.deformed_step(nodes_, body_step), communicator_);
  }

  /// Smallest ratio of an element's volume to its undeformed volume so far.
  double least_volume() const
  {
    return least_volume_;
  }

  EnergyLedger energy_ledger() const;

  double time() const
  {
    return time_;
  }
  const SolidMesh &mesh() const
  {
    return mesh_;
  }
  NodeFields<Real> &nodes()
  {
    return nodes_;
  }
  const NodeFields<Real> &nodes() const
  {
    return nodes_;
  }
  const SolidOperator<Real> &elements() const
  {
    return operator_;
  }
  const StepTimes &times() const
  {
    return times_;
  }
  const SurfaceLoads &loads() const
  {
    return loads_;
  }
  const NodeExchange &exchange() const
  {
    return exchange_;
  }
  MPI_Comm communicator() const
  {
    return communicator_;
  }

  const MassScaling &mass_scaling() const
  {
    return mass_scaling_;
  }

  /// Mass of all ranks including mass scaling [kg].
  double mass() const
  {
    return mass_;
  }

  /// Total momentum of all ranks in the middle of the last step [N s].
  dealii::Tensor<1, 3> momentum() const;

  /// Writes this rank's state to @p folder. @throws SystemError
  void save(const std::string &folder) const;

  /// Reads the state written by any number of ranks.
  /// @throws InputError when it belongs to another scene
  void restore(const std::string &folder);

private:
  struct CheckpointHeader; ///< global values in a checkpoint
  struct Snapshot;         ///< an earlier state for retries

  void take_step(const double step);
  void set_constraint_forces(const double before, const double next);
  void save_snapshot();
  void restore_snapshot();
  void find_least_dilatations();
  bool is_physical(const std::vector<double> &before) const;
  [[noreturn]] void throw_step_failure(const Advance &failed);
  void describe(const std::uint32_t cell, std::ostream &text) const;

  void read_header(io::StateReader &in);
  void set_masses();
  void set_smoothing_weights();
  void gather_hanging(Real *values, unsigned int width, unsigned int stride);
  void move_hanging();
  void assemble();
  void add_step_change(const double before, const double next);
  double largest_square_frequency(double &uncertainty, unsigned int &n);
  double lanczos_step(double &before, double &next);
  void find_weakest_element(StableStep &stable_step);

  MPI_Comm communicator_ = MPI_COMM_SELF;
  SolidMesh mesh_;
  SolidOperator<Real> operator_;
  NodeFields<Real> nodes_;
  NodeExchange exchange_;
  Supports supports_;
  SlipTies slip_;
  SurfaceLoads loads_;
  Surroundings surroundings_;
  double smallest_step_ = 0.; ///< of a single element, for mass scaling [s]
  MassScaling mass_scaling_;
  /// nodes that this rank counts in sums; hanging nodes have no inertia
  std::vector<unsigned char> counted_;
  bool skips_inactive_ = true;
  double computed_updates_ = 0.; ///< number of computed batches, of this rank
  double total_updates_ = 0.;    ///< number of computed and skipped batches
  double mass_ = 0.;
  double time_ = 0.;
  double time_of_relaxed_strain_ = 0.; ///< of the stored ones [s]
  StepTimes times_;
  double external_work_ = 0.; ///< of this rank
  /// Work of all forces, less what is stored at the start, of this rank [J].
  double nodal_work_ = 0.;
  double step_change_ = 0.; ///< see EnergyLedger, of this rank [J]
  double initial_energy_ = 0.;
  std::shared_ptr<Snapshot> snapshot_;
  std::vector<double> least_dilatations_; ///< by tissue, of all ranks
  std::vector<double> element_steps_;     ///< by tissue, at rest [s]
  double least_volume_ = 1.;
};
} // namespace contrecoup::solid
