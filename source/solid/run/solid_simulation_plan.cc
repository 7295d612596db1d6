// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/solid/body/tissue_measures.h>
#include <contrecoup/solid/motion/element_rotation.h>
#include <contrecoup/solid/run/solid_simulation.h>
#include <contrecoup/solid/run/strain_item.h>

#include <algorithm>
#include <limits>
#include <sstream>

namespace contrecoup::solid
{
namespace
{
  /// Element updates per second and core, for estimates only.
  constexpr double typical_speed = 1.5e7;

  /// Time of a step with full integration over that with one point.
  constexpr double full_integration = 1.8;

  /// Memory per element with its nodes and a part of the mesh [bytes].
  constexpr double typical_memory = 900.;

  /// Numbers of elements up to which --check builds the mesh, to count its
  /// nodes and find what its entries select, and up to which it sets the run
  /// up.
  constexpr double cheap_mesh = 1e6, cheap_setup = 1e5;

  /// Rotation of which small strain makes a strain of 1.25e-3 [rad].
  constexpr double notable_rotation = 0.05;
} // namespace


template <typename Real>
SolidSelectors SolidSimulation<Real>::selectors()
{
  const auto &injury = recorders_.template get<InjuryReport<Real>>();
  return {supports_,
          loads_,
          materials_,
          slip_,
          injury.own_thresholds(),
          injury.active()};
}


template <typename Real>
CostEstimate SolidSimulation<Real>::estimate()
{
  CostEstimate cost;
  cost.cells = mesh_description_.estimate_elements();
  cost.memory = typical_memory * cost.cells * (sizeof(Real) == 4 ? 0.7 : 1.);
  // Where plan() has set the body up, its stable step is known.
  const bool is_set_up = body_.mesh().n_global_nodes > 0;
  cost.steps =
    end_time_ / (is_set_up ? stable_step_
                           : safety_ * options_.step_factor() *
                               mesh_description_.estimate_step(materials_));
  cost.seconds =
    cost.steps * cost.cells / typical_speed *
    (options_.integration == Integration::full ? full_integration : 1.) /
    dealii::Utilities::MPI::n_mpi_processes(communicator_);
  if (is_set_up)
    cost.unknowns = 3. * static_cast<double>(body_.mesh().n_global_nodes);
  else if (cost.cells <= cheap_mesh)
    cost.unknowns = 3. * static_cast<double>(check_selections());
  return cost;
}


template <typename Real>
std::uint64_t SolidSimulation<Real>::check_selections()
{
  HexMesh mesh = mesh_description_.create();
  SlipInterface slip;
  if (slip_.active())
    slip = slip_.split(mesh);
  const SolidMesh part = distribute(mesh, communicator_, slip);
  require_selections(part, selectors(), communicator_);
  warn_of_supports(part, selectors(), communicator_);
  recorders_.for_each(&SolidRecorder<Real>::check, part, communicator_);
  return part.n_global_nodes;
}


template <typename Real>
std::vector<Assumption> SolidSimulation<Real>::plan()
{
  // With --check nothing is set up so far: what a run refuses and warns of at
  // its start is found here.
  if (body_.mesh().n_global_nodes == 0 &&
      mesh_description_.estimate_elements() <= cheap_setup)
    setup();
  std::vector<Assumption> items;
  for (const Tissue tissue : materials_.own())
    items.push_back({tissue_column("own", tissue),
                     name_of(tissue) + " with " + materials_.changes(tissue),
                     "speed of its pressure waves",
                     "m/s",
                     materials_.find(tissue).dilatational_speed(),
                     std::numeric_limits<double>::quiet_NaN(),
                     false,
                     "Materials/Tissue " + name_of(tissue)});
  const std::vector<Tissue> &tissues = body_.mesh().tissues;
  const auto &injury = recorders_.template get<InjuryReport<Real>>();
  if (injury.active() && !tissues.empty() &&
      std::find(tissues.begin(), tissues.end(), Tissue::brain) == tissues.end())
    items.push_back({"brain",
                     "none: brain and head get no measures of injury",
                     "elements of brain",
                     "-",
                     0.,
                     std::numeric_limits<double>::quiet_NaN(),
                     false,
                     "Injury/Active"});
  for (const Assumption &item : injury.assumptions(body_))
    items.push_back(item);
  items.push_back(strain_item(options_.kinematics));
  return items;
}


template <typename Real>
std::vector<Assumption> SolidSimulation<Real>::audit()
{
  std::vector<Assumption> items = unmeasured(plan());
  for (Assumption &item : items)
    if (item.name == strain_item(options_.kinematics).name)
      item = strain_item(
        options_.kinematics,
        recorders_.template get<PeakFields<Real>>().most_strained(body_));
  return items;
}


template <typename Real>
void SolidSimulation<Real>::report_step() const
{
  std::ostringstream line;
  line << "step " << brief(stable_step_) << " s: " << brief(safety_)
       << " of what the body allows, "
       << brief(options_.step_factor() * stability_.body_step)
       << " s (highest frequency within "
       << brief(100. * stability_.uncertainty, 2) << " % after "
       << stability_.iterations << " iterations); alone, element "
       << stability_.element << " of " << name_of(stability_.tissue) << " at ("
       << stability_.center << ") m "
       << (body_.mass_scaling().active() ? "without added mass " : "")
       << "would allow "
       << brief(options_.step_factor() * stability_.element_step) << " s";
  log_line(line.str());
  const std::vector<NamedValue> &scaled = body_.mass_scaling().report();
  for (std::size_t i = 0; i < scaled.size(); i += 2)
    if (scaled[i].value > 0.)
      log_line("mass scaling: " + brief(scaled[i].value) + " elements, " +
               brief(scaled[i + 1].value) + " kg more (" + scaled[i + 1].name +
               ")");
}


template <typename Real>
void SolidSimulation<Real>::warn_of_rotation()
{
  if (options_.kinematics != SolidKinematics::small_strain ||
      has_warned_of_rotation_)
    return;
  const double angle =
    largest_rotation(body_.mesh(), body_.nodes(), communicator_);
  if (angle < notable_rotation)
    return;
  has_warned_of_rotation_ = true;
  log_line(
    "WARNING: at " + brief(body_.time()) + " s an element has turned by " +
    brief(angle * 180. / dealii::numbers::PI, 2) +
    " degrees, which Elements/Kinematics = small strain takes for a "
    "strain of " +
    brief(0.5 * angle * angle, 2) + "; with finite rotation it has none");
}


template class SolidSimulation<double>;
template class SolidSimulation<float>;
} // namespace contrecoup::solid
