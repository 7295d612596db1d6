// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/timers.h>
#include <contrecoup/solid/motion/solid_body.h>

namespace contrecoup::solid
{
template <typename Real>
void SolidBody<Real>::reinit(
  const HexMesh &mesh,
  const std::function<std::vector<SolidMaterial>(const std::vector<Tissue> &)>
    &find_materials,
  const ElementOptions &options,
  const Supports &supports,
  const SurfaceLoads &loads,
  const MPI_Comm communicator)
{
  communicator_ = communicator;
  if (slip_.active())
  {
    HexMesh split = mesh;
    const SlipInterface interface = slip_.split(split);
    mesh_ = distribute(split, communicator, interface);
  }
  else
    mesh_ = distribute(mesh, communicator);
  exchange_.reinit(mesh_, communicator);
  operator_.reinit(mesh_, find_materials(mesh_.tissues), options);
  operator_.reinit_nodes(nodes_);
  skips_inactive_ = options.skip_quiet;
  set_masses();
  set_smoothing_weights();
  supports_ = supports;
  supports_.reinit(mesh_);
  slip_.reinit(
    mesh_, supports_, options.kinematics != SolidKinematics::small_strain);
  loads_ = loads;
  loads_.reinit(mesh_, communicator);
}


template <typename Real>
void SolidBody<Real>::set_masses()
{
  std::vector<double> masses = operator_.nodal_masses();
  mass_scaling_.reinit(
    mesh_, operator_.materials(), smallest_step_, communicator_);
  mass_scaling_.add_to(masses);
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
  {
    for (std::size_t i = 0; i < one.masters.size(); ++i)
      masses[one.masters[i]] += one.weights[i] * masses[one.node];
    masses[one.node] = 0.;
  }
  exchange_.add(masses.data(), 1, 1);
  counted_ = mesh_.owned;
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
  {
    masses[one.node] = 0.;
    counted_[one.node] = 0;
  }
  double mass = 0.;
  for (std::size_t i = 0; i < masses.size(); ++i)
  {
    nodes_.inverse_mass_of(i) =
      masses[i] > 0. ? static_cast<Real>(1. / masses[i]) : Real();
    mass += counted_[i] * masses[i];
  }
  mass_ = dealii::Utilities::MPI::sum(mass, communicator_);
}


template <typename Real>
void SolidBody<Real>::set_smoothing_weights()
{
  if (!operator_.smooths())
    return;
  std::vector<double> weights = operator_.smoothing_weights();
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
    for (std::size_t i = 0; i < one.masters.size(); ++i)
      weights[one.masters[i]] += one.weights[i] * weights[one.node];
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
    weights[one.node] = 0.;
  exchange_.add(weights.data(), 1, 1);
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0.)
      nodes_.inverse_weight_of(i) = static_cast<Real>(1. / weights[i]);
}


template <typename Real>
void SolidBody<Real>::gather_hanging(Real *values,
                                     const unsigned int width,
                                     const unsigned int stride)
{
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
    for (unsigned int d = 0; d < width; ++d)
    {
      Real &own = values[stride * std::size_t(one.node) + d];
      for (std::size_t i = 0; i < one.masters.size(); ++i)
        values[stride * std::size_t(one.masters[i]) + d] +=
          static_cast<Real>(one.weights[i]) * own;
      own = Real();
    }
}


template <typename Real>
void SolidBody<Real>::move_hanging()
{
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
    for (unsigned int d = 0; d < 3; ++d)
    {
      Real displacement{}, velocity{};
      for (std::size_t i = 0; i < one.masters.size(); ++i)
      {
        const Real weight = static_cast<Real>(one.weights[i]);
        displacement += weight * nodes_.displacement_of(one.masters[i])[d];
        velocity += weight * nodes_.velocity_of(one.masters[i])[d];
      }
      nodes_.displacement_of(one.node)[d] = displacement;
      nodes_.velocity_of(one.node)[d] = velocity;
      if (displacement != Real())
        nodes_.active[one.node / nodes_.block] = 1;
    }
  for (const HexMesh::HangingNode &one : mesh_.hanging_nodes)
  {
    Real average{};
    for (std::size_t i = 0; i < one.masters.size(); ++i)
      average += static_cast<Real>(one.weights[i]) *
                 nodes_.average_dilatation_of(one.masters[i]);
    nodes_.average_dilatation_of(one.node) = average;
  }
}


template <typename Real>
void SolidBody<Real>::assemble()
{
  {
    const TimerScope timer("elements");
    operator_.add_forces(nodes_, times_);
    computed_updates_ += operator_.batches().n_active();
    total_updates_ += operator_.batches().n_batches();
  }
  const TimerScope timer("loads");
  loads_.set_time(time_);
  loads_.add_forces(nodes_);
  const unsigned int width = operator_.smooths() ? 4 : 3;
  gather_hanging(nodes_.force.data(), width, nodes_.width);
  exchange_.add(nodes_.force.data(), width, nodes_.width);
  surroundings_.add_forces(nodes_);
  supports_.reset_reactions();
  slip_.reset_forces();
  slip_.find_normals(nodes_, exchange_);
}


template <typename Real>
void SolidBody<Real>::start(const double time)
{
  time_ = time;
  time_of_relaxed_strain_ = time;
  times_ = StepTimes();
  move_hanging();
  nodes_.mark_active_blocks();
  if (!skips_inactive_)
    operator_.batches().activate_all();
  assemble();
  const EnergyLedger now = energy_ledger();
  initial_energy_ = now.sum.kinetic + now.sum.internal() + now.contact;
  // Elements and ground store at the start what no work on the nodes gave them.
  if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
    nodal_work_ += now.nodal_internal_work - now.sum.internal();
  find_least_dilatations();
  snapshot_.reset();
}


template <typename Real>
void SolidBody<Real>::add_step_change(const double before, const double next)
{
  double sum = 0.;
  for (std::size_t i = 0; i < counted_.size(); ++i)
    if (counted_[i] != 0)
      for (unsigned int d = 0; d < 3; ++d)
        sum += double(nodes_.inverse_mass_of(i)) *
               double(nodes_.force_of(i)[d]) * double(nodes_.force_of(i)[d]);
  step_change_ += 0.125 * (before * before - next * next) * sum;
}


template <typename Real>
void SolidBody<Real>::set_constraint_forces(const double before,
                                            const double next)
{
  supports_.set_forces(nodes_, time_, before, next);
  slip_.set_forces(nodes_, before, next);
}


template <typename Real>
void SolidBody<Real>::take_step(const double step)
{
  set_constraint_forces(times_.before, step);
  if (step != times_.before)
    add_step_change(times_.before, step);
  {
    const TimerScope timer("nodes");
    nodal_work_ += move_nodes(nodes_, counted_, times_.before, step);
    move_hanging();
    slip_.advance(nodes_, step);
  }
  const auto add_work = [&]() {
    external_work_ += 0.5 * step *
                      (loads_.power(nodes_) + supports_.power(nodes_) +
                       surroundings_.power(nodes_, counted_));
    slip_.add_work(nodes_, 0.5 * step);
  };
  add_work();
  time_ += step;
  times_.before = step;
  times_.relax_before = time_ - time_of_relaxed_strain_;
  times_.relax_after = 0.5 * step;
  assemble();
  time_of_relaxed_strain_ = time_ + times_.relax_after;
  set_constraint_forces(step, step);
  add_work();
}


template <typename Real>
EnergyLedger SolidBody<Real>::energy_ledger() const
{
  EnergyLedger ledger;
  ledger.tissues = operator_.energies(nodes_, times_);
  if (mass_scaling_.active())
  {
    const std::vector<Real> squares =
      operator_.velocity_squares(nodes_, times_);
    for (unsigned int k = 0; k < ledger.tissues.size(); ++k)
      ledger.tissues[k].kinetic += mass_scaling_.kinetic_energy(k, squares);
  }
  std::vector<double> numbers{external_work_,
                              nodal_work_ +
                                work_until_now(nodes_, counted_, times_.before),
                              step_change_,
                              surroundings_.contact_energy(nodes_, counted_),
                              slip_.work()};
  for (const TissueEnergies &one : ledger.tissues)
    numbers.insert(numbers.end(),
                   {one.kinetic,
                    one.stored,
                    one.hourglass,
                    one.bulk_viscosity,
                    one.relaxation,
                    one.hourglass_damping,
                    one.pressure_smoothing});
  dealii::Utilities::MPI::sum(numbers, communicator_, numbers);
  ledger.external_work = numbers[0];
  ledger.contact = numbers[3];
  ledger.interface_work = numbers[4];
  ledger.nodal_internal_work =
    numbers[0] + ledger.interface_work - numbers[1] - ledger.contact;
  ledger.initial = initial_energy_;
  ledger.step_change = numbers[2];
  const double *next = &numbers[5];
  for (TissueEnergies &one : ledger.tissues)
  {
    one = {next[0], next[1], next[2], next[3], next[4], next[5], next[6]};
    next += 7;
    ledger.sum.kinetic += one.kinetic;
    ledger.sum.stored += one.stored;
    ledger.sum.hourglass += one.hourglass;
    ledger.sum.bulk_viscosity += one.bulk_viscosity;
    ledger.sum.relaxation += one.relaxation;
    ledger.sum.hourglass_damping += one.hourglass_damping;
    ledger.sum.pressure_smoothing += one.pressure_smoothing;
  }
  return ledger;
}


template <typename Real>
double SolidBody<Real>::skipped_fraction() const
{
  std::vector<double> sums{computed_updates_, total_updates_};
  dealii::Utilities::MPI::sum(sums, communicator_, sums);
  return sums[1] > 0. ? 1. - sums[0] / sums[1] : 0.;
}


template <typename Real>
double SolidBody<Real>::ground_force() const
{
  return dealii::Utilities::MPI::sum(
    surroundings_.contact_force(nodes_, counted_), communicator_);
}


template <typename Real>
dealii::Tensor<1, 3> SolidBody<Real>::momentum() const
{
  std::vector<double> sum(3, 0.);
  for (std::size_t i = 0; i < counted_.size(); ++i)
    if (counted_[i] != 0)
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] +=
          double(nodes_.velocity_of(i)[d]) / double(nodes_.inverse_mass_of(i));
  dealii::Utilities::MPI::sum(sum, communicator_, sum);
  dealii::Tensor<1, 3> momentum;
  for (unsigned int d = 0; d < 3; ++d)
    momentum[d] = sum[d];
  return momentum;
}


template class SolidBody<double>;
template class SolidBody<float>;
} // namespace contrecoup::solid
