// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/first_answer.h>
#include <contrecoup/geometry/body/body.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Place of what is compared, unless it is a gauge on the skin.
constexpr const char *first_probe = "probe 1";

/// A quantity at the probe next to the body, or on the nearest skin, by the run
/// and by the tables.
struct ComparedQuantity
{
  /// As in the blast's results and in probe_injury.csv, or that of a load on
  /// the skin by the tables.
  std::string name;
  std::string unit;
  double run;
  /// Numerical error of the run by its coarser run [-]; NaN: unknown, as for
  /// probabilities.
  double run_error;
  double tables;
  /// Error of the tables with this TNT equivalence [-].
  double tables_error;
  /// Whether both differ by more than what is known of their errors, as that of
  /// the peak for the load, in a direction that reflections cannot explain: by
  /// ground, walls and body up to what these can add to the impulse.
  bool differs;
  std::string place = first_probe;
  /// Whether that of the run is a lower limit, as the run ends before the
  /// positive phase does.
  bool is_cut = false;
};


/// Reflections at the probe next to the body, by the ground and by sides that
/// the user made walls. One that comes as a larger wave after the incident one
/// has not merged with that.
/// @param folder of the scene
std::vector<Reflection>
reflections_at_probe(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const std::vector<ChosenSide> &sides,
                     const std::string &folder);

/**
 * Compares the blast of a finished run with the tables: wave and injuries in
 * the open at the probe next to the body; the peak is that of the first wave,
 * while the effects on people are those of all. Empty without that probe,
 * without results, and where the tables do not cover the distance.
 *
 * @param folder of the scene
 * @param body_mass [kg]
 * @param has_coarser_run whether its coarser run tells the error
 * @param sides of the domain that the user chose
 */
std::vector<ComparedQuantity>
compare_with_tables(const SceneParameters &scene,
                    const SceneLayout &layout,
                    double body_mass,
                    const std::string &folder,
                    bool has_coarser_run,
                    const std::vector<ChosenSide> &sides = {});

/**
 * Compares the load on the skin with that on a wall by the tables, for a scene
 * without a probe next to the body: first peak, impulse and arrival. Empty for
 * a gauge that is farther from the charge than the nearest skin, without
 * results, and where the tables do not cover the distance.
 *
 * @param gauge on the skin
 * @param folder of the scene
 * @param has_coarser_run whether its coarser run tells the error
 * @param sides of the domain that the user chose
 */
std::vector<ComparedQuantity>
compare_skin_with_tables(const SceneParameters &scene,
                         const SceneLayout &layout,
                         const Landmark &gauge,
                         const std::string &folder,
                         bool has_coarser_run,
                         const std::vector<ChosenSide> &sides = {});

/// A warning that names what differs; empty if nothing does.
/// @param has_open_reflection whether open sides send some of the wave back to
/// the place before the end
std::string warning_of(const std::vector<ComparedQuantity> &compared,
                       const Explosive &explosive,
                       bool has_open_reflection = false);
} // namespace contrecoup::coupling
