// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/io/file/checked_file.h>
#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/boundary/load_alignment.h>
#include <contrecoup/solid/run/solid_output.h>
#include <contrecoup/solid/run/solid_simulation.h>

#include <cmath>

namespace contrecoup::solid
{
namespace
{
  /// Steps between evaluations of the stable step of the deformed body.
  constexpr double steps_between_checks = 50.;

  /// Growth factor from step to step after a step was halved.
  constexpr double regrowth = 1.02;
} // namespace


const std::vector<std::string> &solid_precision_names()
{
  static const std::vector<std::string> names{"double", "single"};
  return names;
}


template <typename Real>
void SolidSimulation<Real>::declare_parameters(ParameterHandler &prm)
{
  MeshDescription::declare_parameters(prm);
  SolidMaterials::declare_parameters(prm);
  ElementOptions::declare_parameters(prm);
  {
    const Section section(prm, "Elements");
    declare_selection(prm,
                      "Precision",
                      "double",
                      solid_precision_names(),
                      "Floating point type of state and arithmetic; "
                      "energies are summed in double.");
    declare_double(prm,
                   "Step safety",
                   "0.9",
                   0.01,
                   1.,
                   "-",
                   "Fraction of the stable step that is used.");
    declare_double(prm,
                   "Smallest step",
                   "0",
                   0.,
                   1.,
                   "s",
                   "Mass scaling: elements with a stable step below this "
                   "value get additional mass. 0: none. The added mass is "
                   "false inertia, and is reported by tissue.");
  }
  SlipTies::declare_parameters(prm);
  Supports::declare_parameters(prm);
  SurfaceLoads::declare_parameters(prm);
  Surroundings::declare_parameters(prm);
  InitialMotion::declare_parameters(prm);
  ReferenceMotion::declare_parameters(prm);
  SolidRecorders<Real>::declare_parameters(prm);
  EnergyAudit::declare_parameters(prm);
}


template <typename Real>
void SolidSimulation<Real>::parse_parameters(ParameterHandler &prm)
{
  materials_.parse_parameters(prm);
  mesh_description_.parse_parameters(prm);
  options_.parse_parameters(prm);
  {
    const Section section(prm, "Elements");
    safety_ = read_double(prm, "Step safety");
    smallest_step_ = read_double(prm, "Smallest step");
  }
  slip_.parse_parameters(prm);
  supports_.parse_parameters(prm);
  loads_.parse_parameters(prm);
  check_load_alignment(prm);
  surroundings_.parse_parameters(prm);
  initial_.parse_parameters(prm);
  reference_.parse_parameters(prm);
  recorders_.for_each([&](SolidRecorder<Real> &recorder) {
    recorder.parse_parameters(prm, mesh_description_);
  });
  audit_.parse_parameters(prm);
  const Section section(prm, "Time");
  end_time_ = read_double(prm, "End time");
}


template <typename Real>
void SolidSimulation<Real>::build()
{
  HexMesh mesh;
  {
    const TimerScope timer("mesh");
    mesh = mesh_description_.create();
    thin_parts_ = mesh_description_.thin_parts(mesh);
  }
  body_.set_smallest_step(smallest_step_ / (safety_ * options_.step_factor()));
  body_.set_slip(slip_);
  body_.reinit(
    mesh,
    [this](const std::vector<Tissue> &tissues) {
      return materials_.find(tissues);
    },
    options_,
    supports_,
    loads_,
    communicator_);
  require_selections(body_.mesh(), selectors(), communicator_);
  warn_of_supports(body_.mesh(), selectors(), communicator_);
  body_.loads().warn_of_times(end_time_);
  stability_ = body_.find_stable_step();
  stable_step_ = safety_ * options_.step_factor() * stability_.body_step;
  told_step_ = stable_step_;
  // Bulk viscosity reduces the step that remains for the body itself.
  const double factor = options_.step_factor();
  surroundings_.set_step(stable_step_,
                         1. - factor * factor * (1. - safety_ * safety_));
  body_.set_surroundings(surroundings_);
  recorders_.for_each(&SolidRecorder<Real>::reinit, body_);
}


template <typename Real>
void SolidSimulation<Real>::setup()
{
  build();
  report_step();
  initial_.set(body_.mesh(), body_.nodes());
  surroundings_.refuse_buried(body_.nodes(), communicator_);
  body_.start(0.);
  recorders_.for_each(&SolidRecorder<Real>::begin, body_);
  warn_of_rest(check_energy());
}


template <typename Real>
void SolidSimulation<Real>::warn_of_rest(const EnergyLedger &ledger)
{
  const bool has_cause = body_.loads().n_loaded_facets(communicator_) > 0 ||
                         supports_.moves() || surroundings_.has_gravity() ||
                         ledger.initial > 0.;
  if (has_cause)
    return;
  has_warned_of_rest_ = true;
  log_line("WARNING: nothing moves the body, all results will be zero: no "
           "facet has a load (Loads/Load */Where, Loads/Recorded/File), no "
           "support moves, and there is neither gravity nor an initial state");
}


template <typename Real>
StepReport SolidSimulation<Real>::advance(const double largest_step)
{
  StepReport report;
  // Halvings of earlier steps count against the limit of retries.
  const double left = options_.largest_retries + std::log2(reduction_);
  const auto made =
    body_.advance(std::min(allowed_step(), largest_step),
                  static_cast<unsigned int>(std::max(0., std::ceil(left))));
  report.step_size = made.step;
  report.retries = made.retries;
  reduction_ = std::min(
    1., std::ldexp(reduction_, -static_cast<int>(made.retries)) * regrowth);
  report.updates = static_cast<double>(body_.mesh().n_global_elements);
  recorders_.for_each(&SolidRecorder<Real>::record, body_);
  return report;
}


template <typename Real>
double SolidSimulation<Real>::allowed_step()
{
  if (steps_until_check_ == 0.)
  {
    const TimerScope timer("step size");
    warn_of_rotation();
    // Deformation may use half of the margin that the safety factor leaves
    // before the step is reduced.
    deformed_step_ = 0.5 * (1. + safety_) * options_.step_factor() *
                     body_.deformed_step(stability_.body_step);
    tell_smaller_step(deformed_step_);
    steps_until_check_ = steps_between_checks;
  }
  steps_until_check_ -= 1.;
  return std::min({reduction_ * stable_step_,
                   deformed_step_,
                   safety_ * options_.step_factor() * body_.compressed_step()});
}


template <typename Real>
void SolidSimulation<Real>::tell_smaller_step(const double allowed)
{
  if (!(allowed < told_step_))
    return;
  const double part = allowed / stable_step_;
  log_line("time " + brief(body_.time()) +
           " s: deformed elements allow steps of " + brief(allowed) +
           " s only, " + brief(part, 3) + " of the first ones");
  // The next line is that of the next halving.
  told_step_ = stable_step_ * std::exp2(std::floor(std::log2(part)));
}


template <typename Real>
EnergyLedger SolidSimulation<Real>::check_energy()
{
  const TimerScope timer("energy audit");
  EnergyLedger ledger = body_.energy_ledger();
  audit_.record(ledger);
  return ledger;
}


template <typename Real>
std::vector<NamedValue> SolidSimulation<Real>::history()
{
  const EnergyLedger ledger = check_energy();
  const TissueEnergies &sum = ledger.sum;
  const dealii::Tensor<1, 3> momentum = body_.momentum();
  std::vector<NamedValue> values{
    {"mass", "kg", body_.mass(), true},
    {"kinetic_energy", "J", sum.kinetic},
    {"internal_energy", "J", sum.internal()},
    {"stored_energy", "J", sum.stored},
    {"hourglass_energy", "J", sum.hourglass},
    {"hourglass_damping_energy", "J", sum.hourglass_damping},
    {"bulk_viscosity_energy", "J", sum.bulk_viscosity},
    {"relaxation_energy", "J", sum.relaxation},
    {"external_work", "J", ledger.external_work},
    {"nodal_internal_work", "J", ledger.nodal_internal_work},
    {"step_change_energy", "J", ledger.step_change},
    {"energy_residual", "J", ledger.residual()},
    {"momentum_x", "N s", momentum[0]},
    {"momentum_y", "N s", momentum[1]},
    {"momentum_z", "N s", momentum[2]}};
  if (options_.pressure_smoothing > 0.)
    values.push_back(
      {"pressure_smoothing_energy", "J", sum.pressure_smoothing});
  if (slip_.active())
    values.push_back({"interface_work", "J", ledger.interface_work});
  if (surroundings_.has_ground())
  {
    values.push_back({"contact_energy", "J", ledger.contact});
    values.push_back({"ground_force", "N", body_.ground_force()});
  }
  const std::vector<Tissue> &tissues = body_.mesh().tissues;
  if (tissues.size() > 1)
    for (std::size_t i = 0; i < tissues.size(); ++i)
    {
      const TissueEnergies &one = ledger.tissues[i];
      values.push_back(
        {tissue_column("kinetic_energy", tissues[i]), "J", one.kinetic});
      values.push_back(
        {tissue_column("internal_energy", tissues[i]), "J", one.internal()});
      values.push_back(
        {tissue_column("hourglass_energy", tissues[i]), "J", one.hourglass});
    }
  for (const NamedValue &value :
       recorders_.collect(&SolidRecorder<Real>::history, body_))
    values.push_back(value);
  return values;
}


template <typename Real>
std::vector<NamedValue> SolidSimulation<Real>::probes()
{
  return recorders_.template get<SolidProbes<Real>>().values(body_);
}


template <typename Real>
std::vector<FieldFile>
SolidSimulation<Real>::write_fields(const std::string &folder,
                                    const unsigned int index)
{
  return {
    {"",
     write_solid(
       body_, recorders_.template get<PeakFields<Real>>(), folder, index)}};
}


template <typename Real>
std::vector<NamedValue> SolidSimulation<Real>::errors()
{
  std::vector<NamedValue> values = reference_.errors(body_);
  for (const NamedValue &value :
       recorders_.collect(&SolidRecorder<Real>::errors))
    values.push_back(value);
  return values;
}


template <typename Real>
std::vector<std::string> SolidSimulation<Real>::gaps()
{
  return recorders_.collect(&SolidRecorder<Real>::gaps);
}


template <typename Real>
std::vector<NamedValue> SolidSimulation<Real>::results()
{
  return recorders_.collect(&SolidRecorder<Real>::results, body_);
}


template <typename Real>
std::vector<NamedValue> SolidSimulation<Real>::checks()
{
  const EnergyLedger ledger = check_energy();
  const std::vector<Tissue> &tissues = body_.mesh().tissues;
  std::vector<NamedValue> values = audit_.checks(ledger, tissues);
  const std::initializer_list<NamedValue> others{
    {"quiet_elements", "-", body_.skipped_fraction()},
    {"stable_step", "s", stable_step_},
    {"element_step", "s", options_.step_factor() * stability_.element_step},
    {"body_step", "s", options_.step_factor() * stability_.body_step},
    {"least_volume", "-", body_.least_volume()},
    {"loaded_facets",
     "-",
     double(body_.loads().n_loaded_facets(communicator_))}};
  values.insert(values.end(), others);
  const auto has_brain = [](const std::vector<Tissue> &list) {
    return std::find(list.begin(), list.end(), Tissue::brain) != list.end();
  };
  if (has_brain(tissues))
    values.push_back(
      {"brain_is_held",
       "-",
       has_brain(find_held_tissues(body_.mesh(), supports_, communicator_))
         ? 1.
         : 0.});
  for (std::string name : thin_parts_)
  {
    std::replace(name.begin(), name.end(), ' ', '_');
    values.push_back({"thin_" + name, "-", 1.});
  }
  for (const NamedValue &value : body_.mass_scaling().report())
    values.push_back(value);
  for (const NamedValue &value :
       body_.slip().measures(body_.nodes(), communicator_))
    values.push_back(value);
  for (const NamedValue &value : body_.loads().check_values())
    values.push_back(value);
  return values;
}


template <typename Real>
void SolidSimulation<Real>::report_injury(const std::string &folder)
{
  const auto &injury = recorders_.template get<InjuryReport<Real>>();
  if (!injury.active())
    return;
  const auto measures = injury.measures(body_);
  for (const InjuryMeasure &measure : measures)
    show_line("  " + in_words(measure));
  if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
    io::write_file(folder + "/injury.csv",
                   [&](std::ostream &out) { out << to_csv(measures); });
}


template <typename Real>
void SolidSimulation<Real>::finish(const std::string &folder)
{
  report_injury(folder);
  warn_of_rotation();
  audit_.judge(check_energy(), body_.mesh().tissues);
  if (audit_.scale() == 0. && !has_warned_of_rest_)
    log_line("WARNING: nothing has moved the body until " +
             brief(body_.time()) +
             " s, all results are zero: loads are 0 or begin later, or "
             "supports hold all that they reach");
}


template <typename Real>
std::pair<std::uint64_t, std::uint64_t> SolidSimulation<Real>::size() const
{
  return {body_.mesh().n_global_elements, 3 * body_.mesh().n_global_nodes};
}


template <typename Real>
void SolidSimulation<Real>::save(const std::string &folder)
{
  body_.save(folder);
  recorders_.for_each(&SolidRecorder<Real>::save, body_, folder);
  if (dealii::Utilities::MPI::this_mpi_process(communicator_) == 0)
    io::save_state(folder + "/run.bin", [&](io::StateWriter &out) {
      for (const double value :
           {reduction_, deformed_step_, steps_until_check_, told_step_})
        out.put(value);
      audit_.save(out);
    });
}


template <typename Real>
void SolidSimulation<Real>::restore(const std::string &folder)
{
  build();
  body_.restore(folder);
  recorders_.for_each(&SolidRecorder<Real>::restore, body_, folder);
  io::StateReader in(folder + "/run.bin");
  for (double *value :
       {&reduction_, &deformed_step_, &steps_until_check_, &told_step_})
    in.take(*value);
  audit_.load(in, body_.mesh().tissues.size());
}


template class SolidSimulation<double>;
template class SolidSimulation<float>;
} // namespace contrecoup::solid
