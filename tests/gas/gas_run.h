// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/adaptation/adaptation.h>
#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/explosive/detonation.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/leaf_mesh.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/stepping/time_stepper.h>

#include "../set_entries.h"
#include "run_lines.h"

#include <map>
#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Place and primitive state of the gas.
template <int dim>
using StateFunction = std::function<GasState<dim>(const dealii::Point<dim> &)>;

/// The solver of a small scene without files: "Section/Entry=value" lines
/// set mesh, material, method, boundaries and adaptation; the test refines
/// the mesh and gives the state.
template <int dim>
class GasRun : public GasScene<dim>
{
public:
  using Scene = GasScene<dim>;
  using Scene::body;
  using Scene::charges;
  using Scene::coarse_mesh;
  using Scene::initial_state;
  using Scene::layout;
  using Scene::material;
  using Scene::points;
  using Scene::scheme;

  explicit GasRun(const std::vector<std::string> &lines,
                  const MPI_Comm communicator = MPI_COMM_WORLD)
    : mesh(communicator)
  {
    dealii::ParameterHandler prm;
    Scene::declare_parameters(prm);
    QuietLeaves<dim>::declare_parameters(prm);
    AdaptationParameters::declare_parameters(prm);
    {
      const Section section(prm, "Time");
      prm.declare_entry("End time", "1");
    }
    set_entries(prm, lines);

    Scene::parse_parameters(prm);
    adaptation_parameters.parse_parameters(prm,
                                           dim,
                                           coarse_mesh.initial_refinement(),
                                           scheme.n_points,
                                           scheme.kind ==
                                             Scheme::Kind::finite_volume,
                                           coarse_mesh.is_axis_aligned());
    mesh.create(coarse_mesh, scheme.precision, scheme.cell_degree);
    mesh.triangulation().refine_global(coarse_mesh.initial_refinement());
    mesh.distribute();
    quiet_leaves = std::make_unique<QuietLeaves<dim>>(
      mesh, QuietLeaves<dim>::parse_parameters(prm));
    stepper = make_time_stepper<dim>({mesh,
                                      layout,
                                      scheme,
                                      this->boundary,
                                      body.empty() ? nullptr : &cut_leaves},
                                     material,
                                     *quiet_leaves);
    adaptation = std::make_unique<Adaptation<dim>>(
      adaptation_parameters, mesh, points, material);
    if (!body.empty())
    {
      adaptation->set_body(body, coarse_mesh.initial_refinement());
      adaptation->refine_at_body();
    }
  }

  /// Renews what depends on mesh and body.
  void reinit()
  {
    if constexpr (dim > 1)
      if (!body.empty())
      {
        cut_leaves.reinit(mesh, layout, body);
        field.set_open_fractions(&cut_leaves.fractions());
      }
    stepper->reinit(field);
  }

  /// Halves the leaves whose centre is @p wanted.
  void refine(const std::function<bool(const dealii::Point<dim> &)> &wanted)
  {
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      if (wanted(mesh.cell(leaf)->center()))
        mesh.cell(leaf)->set_refine_flag();
    mesh.triangulation().execute_coarsening_and_refinement();
    mesh.distribute();
  }

  void set_state(const StateFunction<dim> &state,
                 const bool near_feature = false)
  {
    field.reinit(layout, mesh.n_stored_batches());
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      field.set_leaf(leaf,
                     sample_leaf<dim>(state,
                                      leaf_box(mesh, leaf),
                                      points,
                                      material,
                                      layout.n_components,
                                      near_feature,
                                      4));
    field.fill_padding(mesh.n_owned());
    reinit();
  }

  /// The gas around the charges, and these, ready to be lit.
  void set_charges()
  {
    set_state(
      [this](const dealii::Point<dim> &p) { return initial_state.value(p); });
    charges.fill(mesh, points, field);
    field.fill_padding(mesh.n_owned());
    detonation.reinit(mesh, points, charges);
    field.set_burn(&detonation.burn(), time);
    stepper->reinit(field);
  }

  /// Takes one stable step, times @p factor.
  typename TimeStepper<dim>::Result step(const double factor = 1.)
  {
    const auto result =
      stepper->advance(field, time, factor * stepper->stable_step());
    if (!result.failed)
      time += result.step;
    field.set_burn(field.burn(), time);
    return result;
  }

  void steps(const unsigned int n)
  {
    for (unsigned int i = 0; i < n; ++i)
      if (step().failed)
        throw NumericsError("step " + std::to_string(i) + " failed");
  }

  /// Adapts the mesh once; whether it changed.
  bool adapt()
  {
    stepper->update_ghosts(field);
    const bool changed = adaptation->adapt(field, time, quiet_leaves.get());
    if (changed && !charges.empty())
    {
      detonation.reinit(mesh, points, charges);
      field.set_burn(&detonation.burn(), time);
    }
    if (changed)
      reinit();
    size_ratios = adaptation->levels().size_ratios(time);
    return changed;
  }

  /// See AdaptationPace.
  double front_travel() const
  {
    const auto rates = stepper->largest_rates(size_ratios);
    return rates.front_rate / rates.all;
  }

  std::map<std::string, double> totals() const
  {
    std::map<std::string, double> result;
    for (const auto &value : gas_totals(mesh, points, field, material))
      result[value.name] = value.value;
    return result;
  }

  /// Values of the leaves of this rank by the names of their cells.
  std::map<std::string, std::vector<double>> leaves() const
  {
    std::map<std::string, std::vector<double>> result;
    for (unsigned int leaf = 0; leaf < mesh.n_owned(); ++leaf)
      result[mesh.cell(leaf)->id().to_string()] = field.leaf(leaf);
    return result;
  }

  /// The gas after a step of size @p step [s], for recorders.
  GasSnapshot<dim> snapshot(const double step = 0.) const
  {
    return {*this, mesh, field, cut_leaves, *quiet_leaves, time, step, 0, {}};
  }

  Detonation<dim> detonation;
  AdaptationParameters adaptation_parameters;
  LeafMesh<dim> mesh;
  CutLeaves<dim> cut_leaves;
  GasField field;
  std::unique_ptr<QuietLeaves<dim>> quiet_leaves;
  std::unique_ptr<TimeStepper<dim>> stepper;
  std::unique_ptr<Adaptation<dim>> adaptation;
  std::vector<double> size_ratios;
  double time = 0.;
};
} // namespace contrecoup::gas
