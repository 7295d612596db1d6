// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_answer.h>
#include <contrecoup/ale/mesh/whole_body.h>
#include <contrecoup/ale/run/ale_output.h>
#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/timers.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  constexpr double largest_growth = 1.2; ///< of a step
} // namespace


void AleSimulation::declare_parameters(ParameterHandler &prm)
{
  ImpactScene::declare_parameters(prm);
  Rezone::declare_parameters(prm);
  HeatSource::declare_parameters(prm);
  InterfaceCoupling::declare_parameters(prm);
  AleRecorders::declare_parameters(prm);
  const Section section(prm, "Output");
  declare_bool(prm,
               "Pictures",
               "false",
               "Whether a finished run draws history and probes into the "
               "folder pictures, and of a head a report.");
}


void AleSimulation::parse_parameters(ParameterHandler &prm)
{
  impact_.parse_parameters(prm);
  impact_.regions.refuse_metals();
  rezone_.parse_parameters(prm);
  heat_source_.parse_parameters(prm);
  coupling_.parse_parameters(prm);
  recorders_.for_each(
    [&](AleRecorder &recorder) { recorder.parse_parameters(prm, impact_); });
  for (unsigned int d = 0; d < 3; ++d)
    if (impact_.acceleration[d].depends_on_place())
      throw InputError("Body force/" + std::string(1, "xyz"[d]) +
                       " must not depend on x, y or z");
}


void AleSimulation::build()
{
  const TimerScope timer("mesh");
  dealii::Triangulation<3> mesh;
  impact_.mesh.create(mesh);
  impact_.regions.set_regions(mesh, impact_.mesh.layers());
  regions_ = impact_.regions.regions();
  std::vector<bool> slides;
  for (const Region &region : regions_)
    slides.push_back(region.slides);
  space_.reinit(mesh, communicator_, slides);
  lagrange_.reinit(
    space_,
    regions_,
    impact_.mesh.walls(),
    [this](const double time) {
      dealii::Tensor<1, 3> result;
      for (unsigned int d = 0; d < 3; ++d)
        result[d] = impact_.acceleration[d].value({}, time);
      return result;
    },
    impact_.planes,
    coupling_);
  state_ = AleState();
  state_.wedge = impact_.mesh.wedge();
  lagrange_.mirror(state_.wedge);
  state_.position = space_.positions(node_width);
  impact_.regions.fill(space_, state_);
  rezone_.reinit(space_, state_, regions_, impact_.mesh.walls());
  if (!impact_.planes.empty())
    contact_ = ContactMeasures();
  recorders_.for_each(&AleRecorder::reinit, snapshot());
}


AleSnapshot AleSimulation::snapshot() const
{
  AleSnapshot now{{impact_, communicator_, state_.time},
                  space_,
                  lagrange_,
                  state_,
                  regions_,
                  recorders_.get<ProbeCells>().cells(),
                  forces_are_current_};
  now.contact = contact_;
  now.end = recorders_.get<HeadMeasures>().end_at(
    now.time,
    recorders_.get<ContactHistory<AleSnapshot>>().contact(),
    recorders_.get<RegionHistory>().extremes());
  return now;
}


void AleSimulation::setup()
{
  build();
  lagrange_.start(state_);
  const AleTotals totals = lagrange_.totals(state_);
  energies_.initial = totals.internal_energy + totals.kinetic_energy;
  energies_.initial_kinetic = totals.kinetic_energy;
  energies_.largest = energies_.initial;
  recorders_.get<ContactHistory<AleSnapshot>>().start(
    impact_, totals.momentum, totals.mass);
  recorders_.for_each(&AleRecorder::begin, snapshot());
}


void AleSimulation::heat(const double begin, const double duration)
{
  const double heat = heat_source_.add(space_, state_, begin, duration);
  forces_are_current_ = forces_are_current_ && !heat_source_.is_active();
  lagrange_.add_external_work(heat);
}


StepReport AleSimulation::advance(const double largest_step)
{
  StepReport report;
  double largest = largest_step;
  if (last_step_ > 0.)
    largest = std::min(largest, largest_growth * last_step_);
  // Half of the heat before and half after the step: second order.
  const double begin = state_.time;
  const double first = 0.5 * std::min(largest, last_step_);
  heat(begin, first);
  const auto made = lagrange_.advance(state_,
                                      largest,
                                      impact_.courant_number,
                                      impact_.largest_retries,
                                      forces_are_current_);
  forces_are_current_ = true;
  heat(begin + first, made - first);
  if (coupling_.is_loose())
  {
    const AleTotals totals = lagrange_.totals(state_);
    lagrange_.coupling().require_stable(
      state_.time, totals.internal_energy + totals.kinetic_energy);
  }
  // A step cut short for output does not limit the next one.
  if (made < largest_step || last_step_ == 0. || made > last_step_)
    last_step_ = made;
  if (contact_)
    contact_ = lagrange_.contact();
  AleSnapshot now = snapshot();
  now.step = made;
  recorders_.for_each(&AleRecorder::record, now);
  report.step_size = made;
  report.retries = lagrange_.n_retries();
  report.updates = static_cast<double>(space_.n_global_cells());
  return report;
}


bool AleSimulation::adapt()
{
  const TimerScope timer("rezone");
  const bool is_rezoned = rezone_.apply(state_, lagrange_.walls());
  forces_are_current_ = forces_are_current_ && !is_rezoned;
  recorders_.for_each(&AleRecorder::record_rezoned, snapshot());
  return is_rezoned;
}


AleSimulation::EnergyLedger AleSimulation::ledger() const
{
  EnergyLedger result;
  result.totals = lagrange_.totals(state_);
  result.external_work = lagrange_.external_work();
  result.interface_work = lagrange_.coupling().record().work;
  result.residual = result.totals.internal_energy +
                    result.totals.kinetic_energy - energies_.initial -
                    result.external_work - result.interface_work;
  return result;
}


std::vector<NamedValue> AleSimulation::history()
{
  const EnergyLedger now = ledger();
  const AleTotals &totals = now.totals;
  energies_.largest = std::max({energies_.largest,
                                std::abs(totals.internal_energy),
                                totals.kinetic_energy});
  std::vector<NamedValue> values = {
    {"mass", "kg", totals.mass, true},
    {"kinetic_energy", "J", totals.kinetic_energy},
    {"internal_energy", "J", totals.internal_energy},
    {"external_work", "J", now.external_work},
    {"energy_residual", "J", now.residual},
    {"momentum_x", "N s", totals.momentum[0]},
    {"momentum_y", "N s", totals.momentum[1]},
    {"momentum_z", "N s", totals.momentum[2]}};
  for (NamedValue &value : lagrange_.coupling().history())
    values.push_back(std::move(value));
  if (contact_)
    values.insert(values.end(),
                  {{"contact_force", "N", contact_->force},
                   {"contact_area", "m^2", contact_->area},
                   {"contact_work", "J", contact_->work},
                   {"friction_work", "J", contact_->friction_work}});
  if (lagrange_.slips())
    values.insert(
      values.end(),
      {{"slip_work", "J", lagrange_.slip_work()},
       {"largest_slip_speed", "m/s", lagrange_.largest_slip_speed(state_)}});
  recorders_.for_each([&, now = snapshot()](AleRecorder &recorder) {
    for (NamedValue &value : recorder.history(now))
      values.push_back(std::move(value));
  });
  set_to_whole(
    values, impact_.mesh.computed_fraction(), impact_.mesh.symmetry_planes());
  return values;
}


std::vector<FieldFile> AleSimulation::write_fields(const std::string &folder,
                                                   const unsigned int index)
{
  return {{"", write_ale(space_, lagrange_, state_, folder, index)}};
}


std::vector<NamedValue> AleSimulation::probes()
{
  return recorders_.get<ProbeCells>().values(snapshot());
}


std::vector<NamedValue> AleSimulation::errors()
{
  return recorders_.collect(&AleRecorder::errors, snapshot());
}


std::vector<NamedValue> AleSimulation::results()
{
  return recorders_.collect(&AleRecorder::results, snapshot());
}


std::vector<NamedValue> AleSimulation::checks()
{
  const EnergyLedger now = ledger();
  const double scale = std::max(energies_.largest, 1e-300);
  std::vector<NamedValue> values = {
    {"energy_residual", "-", now.residual / scale},
    {"rezones", "-", static_cast<double>(rezone_.n_rezones())},
    {"rezones_left_out", "-", static_cast<double>(rezone_.n_skipped())}};
  for (NamedValue &value : lagrange_.coupling().summary(scale))
    values.push_back(std::move(value));
  for (const MeshDescription::Shell &shell : impact_.mesh.shells())
    values.push_back({"cells_across_" + shell.name, "-", double(shell.cells)});
  return values;
}


void AleSimulation::finish(const std::string &folder)
{
  const auto &head = recorders_.get<HeadMeasures>();
  head.write(folder, communicator_, snapshot().end);
  for (const std::string &line : answer_lines(
         results(), !impact_.planes.empty(), head.pressures_in_words(true)))
    show_line(line);
}


std::pair<std::uint64_t, std::uint64_t> AleSimulation::size() const
{
  const std::uint64_t n_cells = space_.n_global_cells();
  return {n_cells, 3 * space_.n_global_nodes() + 2 * n_cells};
}
} // namespace contrecoup::ale
