// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_answer.h>
#include <contrecoup/ale/mesh/whole_body.h>
#include <contrecoup/ale/particles/particle_simulation.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/mpm/particle_output.h>
#include <contrecoup/mpm/resampling.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  namespace column = mpm::column;
  namespace mpi = dealii::Utilities::MPI;
} // namespace


void ParticleSimulation::parse_parameters(ParameterHandler &prm)
{
  impact_.parse_parameters(prm);
  if (impact_.mesh.wedge().active())
    throw InputError("Mesh/Wedge axis: particles fill no wedge; use Method = "
                     "ale");
  scene_.parse_parameters(prm);
  recorders_.for_each([&](ParticleRecorder &recorder) {
    recorder.parse_parameters(prm, impact_);
  });
  refuse_entries_of_meshes(prm);
  scene_.reinit(impact_);
}


void ParticleSimulation::refuse_entries_of_meshes(ParameterHandler &prm)
{
  for (const auto &[path, usual] :
       {std::pair<std::vector<std::string>, std::string>(
          {"Heat source", "Power"}, "0"),
        {{"Coupling", "Scheme"}, "monolithic"}})
  {
    const Section section(prm, path[0]);
    if (const std::string value = prm.get(path[1]); value != usual)
      throw InputError(path[0] + "/" + path[1] + " = " + value +
                       " needs Method = ale");
  }
}


void ParticleSimulation::build_grid()
{
  grid_.reinit(scene_.box(), communicator_, [&](const dealii::Point<3> &lower) {
    return mpm::tile_weight(scene_.box(), scene_.source(), lower);
  });
  particles_ = mpm::Particles(scene_.materials().size());
  step_ = std::make_unique<mpm::ParticleStep>(
    scene_.scheme(), scene_.materials(), scene_.field_contact());
  contact_ = mpm::WallContact(scene_.walls());
}


ParticleSnapshot ParticleSimulation::snapshot()
{
  ParticleSnapshot now{{impact_, communicator_, time_}, scene_, particles_};
  if (!contact_.empty())
    now.contact = contact_now_;
  now.end = recorders_.get<ParticleHead>().end_at(
    time_,
    recorders_.get<ContactHistory<ParticleSnapshot>>().contact(),
    recorders_.get<ParticleRegions>().extremes());
  return now;
}


void ParticleSimulation::setup()
{
  const TimerScope timer("particles");
  build_grid();
  mpm::seed(scene_.materials(), scene_.source(), grid_, particles_);
  contact_.find_surface(scene_.source(), grid_, particles_);
  n_particles_ =
    mpi::sum(static_cast<std::uint64_t>(particles_.size()), communicator_);
  std::vector<std::uint64_t> counts(scene_.materials().size(), 0);
  particles_.for_each_block(
    [&](const unsigned int m, const mpm::ParticleBlock &one) {
      counts[m] += one.size();
    });
  mpi::sum(counts, communicator_, counts);
  impact_.regions.require_some(counts, "particle");
  step_->start(grid_, particles_);
  const auto totals = step_->totals(grid_, particles_);
  initial_energy_ = totals.kinetic_energy + totals.internal_energy;
  largest_.any = std::max(totals.kinetic_energy, totals.stored_energy);
  recorders_.get<ContactHistory<ParticleSnapshot>>().start(
    impact_, totals.momentum, totals.mass);
  recorders_.for_each(&ParticleRecorder::reinit, snapshot());
  recorders_.for_each(&ParticleRecorder::begin, snapshot());
}


StepReport ParticleSimulation::advance(const double largest_step)
{
  const double signal = step_->signal_time(grid_, particles_);
  const double largest =
    std::min(largest_step, impact_.courant_number * signal);
  contact_.clear_measures();
  const auto forces = [&](const unsigned int m, mpm::ParticleBlock &block) {
    set_body_force(block);
    if (!contact_.empty())
      contact_.add_forces(scene_.materials()[m], grid_, block);
  };
  StepReport report;
  report.step_size =
    step_->advance(grid_, particles_, largest, impact_.largest_retries, forces);
  time_ += report.step_size;
  report.retries = step_->n_retries();
  report.updates = static_cast<double>(n_particles_);
  add_contact(report.step_size);
  ParticleSnapshot now = snapshot();
  now.step = report.step_size;
  if (scene_.regions_part())
    now.region_force = mpi::sum(step_->field_force(), communicator_);
  recorders_.for_each(&ParticleRecorder::record, now);
  return report;
}


void ParticleSimulation::set_body_force(mpm::ParticleBlock &block) const
{
  for (unsigned int d = 0; d < 3; ++d)
  {
    const Expression &acceleration = impact_.acceleration[d];
    const bool varies = acceleration.depends_on_place();
    double value = varies ? 0. : acceleration.value({}, time_);
    for (std::size_t p = 0; p < block.size(); ++p)
    {
      if (varies)
        value = acceleration.value({block[column::initial_position][p],
                                    block[column::initial_position + 1][p],
                                    block[column::initial_position + 2][p]},
                                   time_);
      block[column::force + d][p] = block[column::mass][p] * value;
    }
  }
}


void ParticleSimulation::add_contact(const double step)
{
  if (contact_.empty())
    return;
  const mpm::WallMeasures &walls = contact_.measures();
  std::vector<double> sums{
    walls.force, walls.area, walls.friction_power, walls.sliding};
  mpi::sum(sums, communicator_, sums);
  contact_now_.force = sums[0];
  contact_now_.area = sums[1];
  contact_now_.friction_work += step * sums[2];
  contact_now_.sliding_work += sums[3];
}


bool ParticleSimulation::adapt()
{
  constexpr unsigned int interval = 20; // steps
  constexpr double stretch = 2.;
  if (++resampled_.n_steps % interval != 0)
    return false;
  const TimerScope timer("split and merge");
  std::vector<std::uint64_t> counts(2, 0);
  particles_.for_each_block(
    [&](const unsigned int m, mpm::ParticleBlock &block) {
      if (scene_.materials()[m].solid() != nullptr)
        counts[0] += mpm::split_stretched(stretch, block);
      counts[1] += mpm::merge_crowded(scene_.largest_per_cell(), grid_, block);
    });
  mpi::sum(counts, communicator_, counts);
  if (counts[0] + counts[1] == 0)
    return false;
  resampled_.n_split += counts[0];
  resampled_.n_merged += counts[1];
  n_particles_ =
    mpi::sum(static_cast<std::uint64_t>(particles_.size()), communicator_);
  particles_.sort(grid_);
  step_->resume(grid_, particles_);
  return true;
}


ParticleSimulation::EnergyLedger ParticleSimulation::ledger() const
{
  EnergyLedger result;
  result.totals = step_->totals(grid_, particles_);
  std::vector<double> sums{step_->ledger().external_work,
                           step_->ledger().transfer_loss,
                           step_->ledger().contact_loss};
  mpi::sum(sums, communicator_, sums);
  result.external_work = sums[0];
  result.transfer_loss = sums[1];
  result.contact_loss = sums[2];
  result.residual = result.totals.kinetic_energy +
                    result.totals.internal_energy - initial_energy_ -
                    result.external_work + result.transfer_loss +
                    result.contact_loss;
  return result;
}


std::vector<NamedValue> ParticleSimulation::history()
{
  const EnergyLedger now = ledger();
  const auto &totals = now.totals;
  largest_.any = std::max(
    {largest_.any, totals.kinetic_energy, std::abs(totals.internal_energy)});
  largest_.given_back = std::max(largest_.given_back,
                                 totals.stored_energy - totals.internal_energy);
  largest_.wall_work =
    std::max(largest_.wall_work,
             std::abs(now.external_work - contact_now_.friction_work));
  std::vector<NamedValue> values = {
    {"mass", "kg", totals.mass, true},
    {"kinetic_energy", "J", totals.kinetic_energy},
    {"internal_energy", "J", totals.internal_energy},
    {"stored_energy", "J", totals.stored_energy},
    {"external_work", "J", now.external_work},
    {"transfer_loss", "J", now.transfer_loss},
    {"contact_loss", "J", now.contact_loss},
    {"energy_residual", "J", now.residual},
    {"momentum_x", "N s", totals.momentum[0]},
    {"momentum_y", "N s", totals.momentum[1]},
    {"momentum_z", "N s", totals.momentum[2]}};
  if (!contact_.empty())
    values.insert(values.end(),
                  {{"contact_force", "N", contact_now_.force},
                   {"contact_area", "m^2", contact_now_.area},
                   {"friction_work", "J", contact_now_.friction_work}});
  recorders_.for_each([&, now = snapshot()](ParticleRecorder &recorder) {
    for (NamedValue &value : recorder.history(now))
      values.push_back(std::move(value));
  });
  set_to_whole(
    values, impact_.mesh.computed_fraction(), impact_.mesh.symmetry_planes());
  return values;
}


std::vector<NamedValue> ParticleSimulation::probes()
{
  return ParticleProbes::values(snapshot());
}


std::vector<FieldFile>
ParticleSimulation::write_fields(const std::string &folder,
                                 const unsigned int index)
{
  return {{"",
           mpm::write_particles(
             scene_.materials(), particles_, folder, index, communicator_)}};
}


std::vector<NamedValue> ParticleSimulation::errors()
{
  return recorders_.collect(&ParticleRecorder::errors, snapshot());
}


std::vector<NamedValue> ParticleSimulation::results()
{
  return recorders_.collect(&ParticleRecorder::results, snapshot());
}


void ParticleSimulation::finish(const std::string &folder)
{
  const auto &head = recorders_.get<ParticleHead>();
  head.write(folder, communicator_, snapshot().end);
  const std::string pressures = head.pressures_in_words(scene_.materials());
  for (const std::string &line :
       answer_lines(results(), !impact_.planes.empty(), pressures))
    show_line(line);
}


std::vector<NamedValue> ParticleSimulation::checks()
{
  const EnergyLedger now = ledger();
  const double scale = std::max(largest_.any, 1e-300);
  std::vector<NamedValue> values{
    {"energy_residual", "-", now.residual / scale},
    {"transfer_loss", "-", now.transfer_loss / scale},
    {"contact_loss", "-", now.contact_loss / scale},
    {"split_particles", "-", static_cast<double>(resampled_.n_split)},
    {"merged_particles", "-", static_cast<double>(resampled_.n_merged)}};
  for (const NamedValue &value : cells_across())
    values.push_back(value);
  return values;
}
} // namespace contrecoup::ale
