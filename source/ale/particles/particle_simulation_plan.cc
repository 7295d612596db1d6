// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/head/scene_check.h>
#include <contrecoup/ale/particles/particle_simulation.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::ale
{
namespace
{
  /// Particle updates per second and core, for estimates only: measured on the
  /// quickstart's head with a processor of 2021.
  constexpr double typical_speed = 1e6;

  /// Number of sample points along each direction.
  constexpr unsigned int check_samples = 48;

  /// Memory per particle with its part of the grid [bytes].
  constexpr double typical_memory = 1200.;
} // namespace


void ParticleSimulation::check_scene()
{
  const std::vector<Region> regions = impact_.regions.regions();
  recorders_.get<ParticleHead>().find(regions, impact_.planes.planes());
  recorders_.get<ParticleReference>().reinit(snapshot());
  impact_.regions.require_some(scene_.count_matter(), "particle");
  SceneCheck check(impact_);
  scene_.sample_matter(check_samples,
                       [&](const dealii::Point<3> &place, const int region) {
                         check.add_matter(place, region);
                       });
  for (const ContactPlane &plane : impact_.planes.planes())
    if (const auto lowest = scene_.lowest_matter(plane.normal))
      check.add_matter(*lowest, scene_.source().material_at(*lowest));
  for (unsigned int d = 0; d < 3; ++d)
    if (impact_.has_symmetry_plane(d))
      scene_.sample_matter(
        check_samples,
        [&](const dealii::Point<3> &place, const int region) {
          check.add_on_symmetry_plane(d, place, region);
        },
        d);
  check.check_planes(impact_.regions.has_pressure());
  for (const dealii::Point<3> &place : impact_.probes)
    if (!scene_.is_near_matter(place))
      throw InputError("Probes/Points: (" + coordinates(place) +
                       ") m is outside of the matter");
}


CostEstimate ParticleSimulation::estimate()
{
  check_scene();
  CostEstimate cost;
  cost.cells = scene_.n_particles();
  cost.unknowns = 6. * cost.cells;
  cost.memory = typical_memory * cost.cells;
  double speed = 0.;
  for (unsigned int m = 0; m < scene_.materials().size(); ++m)
    speed = std::max(
      speed, std::sqrt(impact_.regions.matter_at({}, m).sound_speed_squared));
  speed += impact_.regions.fastest_velocity().norm();
  cost.steps = std::ceil(impact_.end_time * speed /
                         (impact_.courant_number * scene_.cell_size()));
  recorders_.get<ParticleHead>().check_interval(cost.steps);
  cost.seconds = cost.steps * cost.cells / typical_speed /
                 dealii::Utilities::MPI::n_mpi_processes(communicator_);
  return cost;
}


ImpactPlan ParticleSimulation::impact_plan() const
{
  ImpactPlan plan = impact_.plan(recorders_.get<ParticleHead>());
  plan.cell_size = scene_.cell_size();
  return plan;
}


std::vector<NamedValue> ParticleSimulation::cells_across() const
{
  std::vector<NamedValue> values;
  for (const MeshDescription::Shell &shell : impact_.mesh.shells())
    values.push_back({"cells_across_" + shell.name,
                      "-",
                      shell.thickness / scene_.cell_size()});
  return values;
}


Assumption ParticleSimulation::layer_resolution() const
{
  // Slip between fields needs two cells; one field needs more, because spline
  // supports overlap.
  constexpr double least_of_one_field = 4., least_of_several = 2.;
  const bool is_one = scene_.field_contact().n_fields() < 2;
  double least = std::numeric_limits<double>::max();
  for (const NamedValue &layer : cells_across())
    least = std::min(least, layer.value);
  return {"layers",
          is_one ? "one velocity for all" : "a velocity for each region",
          "cells of the grid across the thinnest layer",
          "-",
          least,
          is_one ? least_of_one_field : least_of_several,
          true,
          "MPM/Cell size"};
}


std::vector<Assumption> ParticleSimulation::plan()
{
  std::vector<Assumption> items = impact_plan().plan();
  if (impact_.mesh.head() != nullptr)
    items.push_back(layer_resolution());
  return items;
}


std::vector<Assumption> ParticleSimulation::audit()
{
  const double kinetic = initial_energy_;
  std::vector<Assumption> items = impact_plan().audit(
    {recorders_.get<ParticleRegions>().extremes().least_pressures(),
     recorders_.get<ContactHistory<ParticleSnapshot>>().contact(),
     contact_now_.friction_work,
     contact_now_.sliding_work,
     kinetic,
     0.,
     largest_.any,
     time()});
  if (impact_.mesh.head() != nullptr)
  {
    items.push_back(layer_resolution());
    items.back().is_estimate = true;
  }
  const auto add = [&](const char *name,
                       const char *decision,
                       const std::string &quantity,
                       const double energy) {
    // Beyond, accelerations of the head are those of another impact.
    constexpr double largest_part = 0.1;
    items.push_back({name,
                     decision,
                     quantity + ", over the largest energy",
                     "-",
                     energy / std::max(largest_.any, 1e-300),
                     largest_part,
                     false,
                     "MPM/Cell size"});
  };
  add("transfer_loss",
      "velocities go to the grid and back in each step",
      "kinetic energy that is lost between grid and particles",
      ledger().transfer_loss);
  add("given_back",
      "stresses and motion are of different points",
      "energy that the matter gives back beyond what it has stored",
      largest_.given_back);
  if (!contact_.empty() && !impact_plan().has_body_force)
    add("wall_work",
        "contact acts at the nodes of the grid",
        "work of planes at rest other than by friction",
        largest_.wall_work);
  return items;
}
} // namespace contrecoup::ale
