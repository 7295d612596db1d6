// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

/**
 * @file
 * Header of Contrecoup for other programs. It precedes every header of deal.II.
 * applications/example is a program that uses it.
 *
 * Programs are built by CMake: `find_package(Contrecoup)` gives the target
 * Contrecoup::contrecoup. They initialise MPI before all else, as by
 * dealii::Utilities::MPI::MPI_InitFinalize. Errors are InputError,
 * NumericsError and SystemError. Lines for the user go to the screen unless
 * `Log::instance().set_active(false)`.
 *
 * **A whole application**, with its output folder:
 * coupling::blast_application() and the like describe it. io::declare_entries()
 * declares its entries in a dealii::ParameterHandler, in which the program sets
 * them, io::read_parameters() those of a parameter file, and io::run_entries()
 * runs it.
 *
 * **A blast in steps of one's own**: gas::GasSimulation, or
 * coupling::StagedSimulation with a first stage.
 *
 * | function | does |
 * |---|---|
 * | set_entries() | gives it its entries |
 * | setup(), advance_to() | builds mesh and initial state; steps to a time |
 * | states_at() | density, velocity and pressure at any places |
 * | probes() | the same at the probes of its entries |
 * | history() | conserved totals and extrema |
 * | loads() | overpressures on the facets of a body and at its gauges |
 * | results() | peaks, impulses and arrivals at probes and gauges, loads |
 * | write_fields() | files for ParaView |
 * | add_recorder() | calls a class derived from gas::Recorder after each step |
 *
 * In a recorder, gas::PointSampler reads the state at places.
 */

// clang-format off
#include <contrecoup/base/lanes/library_lanes.h> // before deal.II
// clang-format on

#include <contrecoup/ale/run/head_impact_application.h>
#include <contrecoup/base/run/advance_to.h>
#include <contrecoup/base/run/time_parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/coupling/application/anatomy_application.h>
#include <contrecoup/coupling/application/biomechanics_application.h>
#include <contrecoup/coupling/application/blast_application.h>
#include <contrecoup/coupling/first_stage/staged_simulation.h>
#include <contrecoup/coupling/scene/scene_application.h>
#include <contrecoup/gas/run/gas_simulation.h>
#include <contrecoup/gas/state/point_sampler.h>
#include <contrecoup/io/application/run_entries.h>
#include <contrecoup/io/application/tool.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Gives a solver its entries: defaults, those of a parameter file unless @p
/// file is empty, and @p overrides as after --set, "Section/Entry=value".
/// @throws InputError for an unknown entry or a value that is not allowed
template <typename Solver>
void set_entries(Solver &solver,
                 const std::string &file,
                 const std::vector<std::string> &overrides = {})
{
  dealii::ParameterHandler prm;
  TimeParameters::declare_parameters(prm);
  Solver::declare_parameters(prm);
  io::CommandLine command;
  command.parameter_file = file;
  command.overrides = overrides;
  io::read_parameters(command, prm);
  solver.parse_parameters(prm);
}
} // namespace contrecoup
