// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_exchange.h>
#include <contrecoup/solid/boundary/supports.h>
#include <contrecoup/solid/boundary/surface_loads.h>
#include <contrecoup/solid/boundary/surroundings.h>
#include <contrecoup/solid/motion/mass_scaling.h>
#include <contrecoup/solid/motion/node_motion.h>
#include <contrecoup/solid/motion/solid_operator.h>

#include <memory>

namespace contrecoup::solid
{
/// What the elements and the assembled body allow as a step.
struct StepCertificate
{
  double body_step = 0.;        ///< 2 / omega of the body [s]
  double uncertainty = 0.;      ///< of omega, relative
  double element_step = 0.;     ///< least of any element alone [s]
  std::uint32_t element = 0;    ///< that element, in the whole mesh
  Tissue tissue = Tissue::none; ///< of it
  dealii::Point<3> place;       ///< of it [m]
  unsigned int iterations = 0;
};

/// Energies of all ranks [J].
struct EnergyBalance
{
  std::vector<TissueEnergies> tissues;
  TissueEnergies sum;
  double external_work = 0.; ///< of loads, moved supports and gravity
  double contact = 0.;       ///< in the springs of the ground
  /// Work of the elements' forces as their nodes felt it: what the sums over
  /// elements should be.
  double nodal_internal_work = 0.;
  double initial = 0.; ///< kinetic and stored energy at the start
  /// What changes of the step size did to the energy that central differences
  /// conserve, which is H - dt^2 / 8 f M^-1 f.
  double step_change = 0.;

  /// What is missing in the energy of elements and nodes.
  double residual() const
  {
    return sum.kinetic + sum.internal() + contact - external_work - initial -
           step_change;
  }
};

/**
 * A deformable body: mesh, state, and its steps by central differences with a
 * lumped mass. Every function is collective.
 */
template <typename Real>
class SolidBody
{
public:
  /// Elements that alone would have a smaller stable step [s] get mass until
  /// they have it; 0: none do. Call before reinit().
  void set_smallest_step(const double step)
  {
    smallest_step_ = step;
  }

  /**
   * Builds the part of this rank, at rest.
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

  /// The longest stable step without bulk viscosity. Only at rest: uses the
  /// displacements and velocities as memory and leaves them zero.
  StepCertificate certify_step();

  /// Gravity and ground, whose step was set.
  void set_surroundings(const Surroundings &surroundings)
  {
    surroundings_ = surroundings;
  }

  /// Part of the elements' updates so far that was not computed, as nothing
  /// had moved there; since the start or the last restart.
  double quiet_part() const;

  /// Force of the ground on the body [N].
  double ground_force() const;

  /// Makes the forces of a state that was set from outside, at its time.
  void start(const double time);

  /// A step that was made.
  struct Advance
  {
    double step;          ///< its size [s]
    unsigned int retries; ///< times that it was halved
  };

  /**
   * One step of at most this size: the state is put back, and the step halved,
   * when an element would have no volume, or the most compressed one of a
   * tissue lose a fifth of it, or numbers would not be finite.
   * @throws NumericsError, naming the element, when so many retries do not
   *   help; the state is then that before the step
   */
  Advance advance(const double step, const unsigned int largest_retries = 10);

  /// What elements with gas allow as a step now: the least of any of their
  /// tissue, at the largest compression of it [s].
  double compressed_step() const;

  /// SolidOperator's deformed_step() of all ranks.
  double deformed_step(const double body_step) const
  {
    return dealii::Utilities::MPI::min(
      operator_.deformed_step(nodes_, body_step), communicator_);
  }

  /// The least volume of an element so far, over its undeformed one [-]; since
  /// the start or the last restart.
  double least_volume() const
  {
    return least_volume_;
  }

  EnergyBalance balance() const;

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

  /// Mass of all ranks, with what was added [kg].
  double mass() const
  {
    return mass_;
  }

  /// Momentum of all ranks in the middle of the last step [N s].
  dealii::Tensor<1, 3> momentum() const;

  /// Writes the state of this rank into @p folder. @throws SystemError
  void save(const std::string &folder) const;

  /// Reads the state, which any number of ranks wrote.
  /// @throws InputError when it belongs to another scene
  void restore(const std::string &folder);

private:
  struct Numbers; ///< of the whole body, in checkpoints
  struct Past;    ///< a state to step back to

  void take_step(const double step);
  void keep();
  void go_back();
  void find_least_dilatations();
  bool is_physical(const std::vector<double> &before) const;
  [[noreturn]] void give_up(const Advance &failed);
  void describe(const std::uint32_t cell, std::ostream &text) const;

  Numbers read_numbers(std::istream &in, const std::string &file);
  void set_masses();
  void gather_hanging(Real *values, unsigned int width, unsigned int stride);
  void move_hanging();
  void assemble();
  void book_step_change(const double before, const double next);
  double largest_square_frequency(double &uncertainty, unsigned int &n);
  double lanczos_step(double &before, double &next);
  void find_weakest_element(StepCertificate &certificate);

  MPI_Comm communicator_ = MPI_COMM_SELF;
  SolidMesh mesh_;
  SolidOperator<Real> operator_;
  NodeFields<Real> nodes_;
  NodeExchange exchange_;
  Supports supports_;
  SurfaceLoads loads_;
  Surroundings surroundings_;
  double smallest_step_ = 0.; ///< that elements shall have alone [s]
  MassScaling mass_scaling_;
  std::vector<unsigned char> counted_; ///< nodes with inertia of this rank
  bool skips_quiet_ = true;
  double computed_ = 0.; ///< batches, of this rank
  double offered_ = 0.;  ///< the same with quiet ones
  double mass_ = 0.;
  double time_ = 0.;
  double relaxed_time_ = 0.; ///< to which relaxed strains were brought [s]
  StepTimes times_;
  double external_work_ = 0.; ///< of this rank
  double nodal_work_ = 0.;    ///< of all forces, of this rank
  double step_change_ = 0.;   ///< of the energy, of this rank
  double initial_energy_ = 0.;
  std::shared_ptr<Past> past_;
  std::vector<double> least_dilatations_; ///< by tissue, of all ranks
  std::vector<double> element_steps_;     ///< by tissue, at rest [s]
  double least_volume_ = 1.;
};
} // namespace contrecoup::solid
