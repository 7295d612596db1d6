// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/head_answer.h>
#include <contrecoup/ale/lagrange/region_measures.h>
#include <contrecoup/ale/mesh/whole_body.h>
#include <contrecoup/ale/run/ale_output.h>
#include <contrecoup/ale/run/ale_simulation.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/timers.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <map>

namespace contrecoup::ale
{
namespace
{
  constexpr double largest_growth = 1.2; ///< of a step

  /// Distance of a place from the centre of the cell that it is in [m]; of
  /// other cells more than any distance, the more the farther outside it is, in
  /// lengths of the cell.
  double remoteness(const HexSpace::Cell &cell,
                    const dealii::AlignedVector<double> &position,
                    const dealii::Point<3> &place)
  {
    constexpr double beyond = 1e6, near = 3., round_off = 1e-6;
    constexpr unsigned int n_steps = 5;
    double outside = 0., distance = 0.;
    dealii::Tensor<1, 3> local; // from -1 to 1 in the cell
    // Newton's method, from the centre on; cells far away need no more than
    // that.
    for (unsigned int step = 0; step <= n_steps && outside < near; ++step)
    {
      dealii::Point<3> there;
      dealii::Tensor<2, 3> jacobian;
      for (unsigned int k = 0; k < 8; ++k)
      {
        const double sign[] = {k % 4 == 1 || k % 4 == 2 ? 1. : -1.,
                               k % 4 > 1 ? 1. : -1.,
                               k > 3 ? 1. : -1.};
        double shape[3];
        for (unsigned int e = 0; e < 3; ++e)
          shape[e] = 0.5 * (1. + sign[e] * local[e]);
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double x = position[node_width * cell[k] + d];
          there[d] += shape[0] * shape[1] * shape[2] * x;
          for (unsigned int e = 0; e < 3; ++e)
            jacobian[d][e] +=
              0.5 * sign[e] * shape[(e + 1) % 3] * shape[(e + 2) % 3] * x;
        }
      }
      if (step == 0)
        distance = there.distance(place);
      local += dealii::invert(jacobian) * (place - there);
      outside = 0.;
      for (unsigned int e = 0; e < 3; ++e)
        outside = std::max(outside, std::abs(local[e]));
    }
    // A flat cell has no local coordinates.
    if (!std::isfinite(local.norm()))
      return beyond * distance;
    return outside <= 1. + round_off ? distance : beyond * outside;
  }
} // namespace


void AleSimulation::declare_parameters(ParameterHandler &prm)
{
  ImpactScene::declare_parameters(prm);
  Rezone::declare_parameters(prm);
  HeatSource::declare_parameters(prm);
  InterfaceCoupling::declare_parameters(prm);
  Reference::declare_parameters(prm);
  HeadMeasures::declare_parameters(prm);
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
  reference_.parse_parameters(prm);
  head_.parse_parameters(prm);
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
  std::vector<bool> slides;
  for (const Region &region : impact_.regions.regions())
    slides.push_back(region.slides);
  space_.reinit(mesh, communicator_, slides);
  n_cells_ = mesh.n_active_cells();
  n_nodes_ = space_.nodes().size();
  lagrange_.reinit(
    space_,
    impact_.regions.regions(),
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
  extremes_.reinit(impact_.regions.regions().size(), communicator_);
  rezone_.reinit(
    space_, state_, impact_.regions.regions(), impact_.mesh.walls());
  head_.reinit(space_, lagrange_, state_);
  find_probe_cells();
}


void AleSimulation::setup()
{
  build();
  lagrange_.start(state_);
  head_.follow(space_, lagrange_, state_);
  const AleTotals totals = lagrange_.totals(state_);
  initial_energy_ = totals.internal_energy + totals.kinetic_energy;
  initial_kinetic_energy_ = totals.kinetic_energy;
  energy_scale_ = initial_energy_;
  if (!impact_.planes.empty())
    contact_.start(impact_.planes.planes().front(),
                   totals.momentum,
                   totals.mass,
                   impact_.mesh.symmetry_planes());
}


void AleSimulation::find_probe_cells()
{
  probe_cells_.assign(impact_.probes.size(), HexSpace::no_cell);
  std::map<unsigned int, std::size_t> probe_in;
  for (std::size_t i = 0; i < impact_.probes.size(); ++i)
  {
    double nearest = std::numeric_limits<double>::max();
    std::uint32_t cell = HexSpace::no_cell;
    for (std::uint32_t c = 0; c < space_.n_locally_owned_cells(); ++c)
    {
      const double distance =
        remoteness(space_.cell(c), state_.position, impact_.probes[i]);
      if (distance < nearest * (1. - 1e-12))
      {
        nearest = distance;
        cell = c;
      }
    }
    // Among equally near cells, the smallest cell number counts.
    const double all = dealii::Utilities::MPI::min(nearest, communicator_);
    const bool is_here = nearest <= all * (1. + 1e-12);
    const unsigned int number =
      is_here ? space_.cell_number(cell) : HexSpace::no_cell;
    const auto chosen = dealii::Utilities::MPI::min(number, communicator_);
    if (chosen == number && is_here)
      probe_cells_[i] = cell;
    if (const auto other = probe_in.emplace(chosen, i); !other.second)
      log_line("WARNING: Probes/Points: probes " +
               std::to_string(other.first->second + 1) + " and " +
               std::to_string(i + 1) + " are in one cell and have one record");
  }
}


void AleSimulation::heat(const double begin, const double duration)
{
  const double heat = heat_source_.add(space_, state_, begin, duration);
  is_as_left_ = is_as_left_ && !heat_source_.is_active();
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
                                      is_as_left_);
  is_as_left_ = true;
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
  reference_.follow(space_, lagrange_, state_, probe_cells_, made);
  if (!impact_.planes.empty())
    contact_.add(lagrange_.contact(), state_.time, made);
  head_.follow(space_, lagrange_, state_);
  report.step_size = made;
  report.retries = lagrange_.n_retries();
  report.updates = static_cast<double>(n_cells_);
  return report;
}


bool AleSimulation::adapt()
{
  const TimerScope timer("rezone");
  const bool is_rezoned = rezone_.apply(state_, lagrange_.walls());
  is_as_left_ = is_as_left_ && !is_rezoned;
  std::vector<RegionExtremes> extremes = lagrange_.extremes();
  if (!is_as_left_)
  {
    // Neither smoothing nor heat changes the pressures of solids.
    const auto found = region_extremes(
      space_, lagrange_, state_, impact_.regions.regions(), false);
    for (std::size_t i = 0; i < found.size(); ++i)
      if (impact_.regions.regions()[i].solid() == nullptr)
        extremes[i] = found[i];
  }
  extremes_.add(std::move(extremes));
  return is_rezoned;
}


AleSimulation::EnergyLedger AleSimulation::ledger() const
{
  EnergyLedger result;
  result.totals = lagrange_.totals(state_);
  result.external_work = lagrange_.external_work();
  result.interface_work = lagrange_.coupling().record().work;
  result.residual = result.totals.internal_energy +
                    result.totals.kinetic_energy - initial_energy_ -
                    result.external_work - result.interface_work;
  return result;
}


std::vector<NamedValue> AleSimulation::history()
{
  const EnergyLedger now = ledger();
  const AleTotals &totals = now.totals;
  energy_scale_ = std::max(
    {energy_scale_, std::abs(totals.internal_energy), totals.kinetic_energy});
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
  if (!impact_.planes.empty())
  {
    const ContactMeasures contact = lagrange_.contact();
    values.insert(values.end(),
                  {{"contact_force", "N", contact.force},
                   {"contact_area", "m^2", contact.area},
                   {"contact_work", "J", contact.work},
                   {"friction_work", "J", contact.friction_work}});
  }
  if (lagrange_.slips())
    values.insert(
      values.end(),
      {{"slip_work", "J", lagrange_.slip_work()},
       {"largest_slip_speed", "m/s", lagrange_.largest_slip_speed(state_)}});
  if (extremes_.is_empty())
    extremes_.add(
      region_extremes(space_, lagrange_, state_, impact_.regions.regions()));
  for (NamedValue &measure : region_measures(
         space_, state_, impact_.regions.regions(), extremes_.take()))
    values.push_back(std::move(measure));
  set_to_whole(
    values, impact_.mesh.computed_fraction(), impact_.mesh.symmetry_planes());
  return values;
}


std::vector<NamedValue> AleSimulation::probes()
{
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < probe_cells_.size(); ++i)
  {
    std::vector<double> found(2, 0.);
    if (probe_cells_[i] != HexSpace::no_cell)
    {
      const auto element = lagrange_.values(state_, probe_cells_[i]);
      found = {element.pressure, element.mass / element.volume};
    }
    dealii::Utilities::MPI::sum(found, communicator_, found);
    const std::string name = "_" + std::to_string(i + 1);
    values.push_back({"pressure" + name, "Pa", found[0]});
    values.push_back({"density" + name, "kg/m^3", found[1]});
  }
  return values;
}


std::vector<FieldFile> AleSimulation::write_fields(const std::string &folder,
                                                   const unsigned int index)
{
  return {{"", write_ale(space_, lagrange_, state_, folder, index)}};
}


std::vector<NamedValue> AleSimulation::errors()
{
  return reference_.errors(space_, lagrange_, state_);
}


std::vector<NamedValue> AleSimulation::results()
{
  std::vector<NamedValue> values;
  if (!impact_.planes.empty())
  {
    values = contact_.values(state_.time);
    set_to_whole(
      values, impact_.mesh.computed_fraction(), impact_.mesh.symmetry_planes());
  }
  const RunEnd end = head_.end_at(state_.time, contact_, extremes_);
  for (const NamedValue &value : head_.coup(communicator_, end))
    values.push_back(value);
  for (const NamedValue &value :
       solid::values_of(head_.measures(communicator_, end)))
    values.push_back(value);
  return values;
}


std::vector<NamedValue> AleSimulation::checks()
{
  const EnergyLedger now = ledger();
  const double scale = std::max(energy_scale_, 1e-300);
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
  head_.write(
    folder, communicator_, head_.end_at(state_.time, contact_, extremes_));
  for (const std::string &line : answer_lines(
         results(), !impact_.planes.empty(), head_.pressures_in_words(true)))
    show_line(line);
}


std::pair<std::uint64_t, std::uint64_t> AleSimulation::size() const
{
  return {n_cells_, 3 * n_nodes_ + 2 * n_cells_};
}
} // namespace contrecoup::ale
