// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/reflecting_plane.h>

#include <optional>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// Answer of tables alone on a blast: the incident wave at the
/// body's distance, and its effects on eardrums and lungs.
struct TableAnswer
{
  /// Effect of a wave on a person at this distance.
  struct Effect
  {
    double overpressure;    ///< peak that bursts eardrums [Pa]
    double eardrum_rupture; ///< probability [-]
    double lung_exposure;   ///< load over that which kills half [-]
    double lung_lethality;  ///< probability [-]
  };

  double arrival;       ///< [s]
  double impulse;       ///< of the positive phase [Pa s]
  double duration;      ///< of the positive phase [s]
  Effect in_the_open;   ///< under the incident wave, of who stands
  Effect before_a_wall; ///< under its reflection at a wall, normal incidence
  Effect along_body;    ///< under its side-on pressure, from head or feet
};


/// The answer of the tables at the body's distance; nothing where they do not
/// cover charge and distance.
/// @param body_mass [kg]
std::optional<TableAnswer> table_answer(const SceneParameters &scene,
                                        const SceneLayout &layout,
                                        double body_mass);

/// Words for a body that is not SceneLayout::is_far().
std::string unknown_beforehand();

/// Words on the tables for the charge's place: "in free air", or for a surface
/// burst.
std::string burst_in_words(const SceneLayout &layout);

/// Words on the TNT equivalence by which tables are entered: factors, source,
/// and that it is an estimate if it was not measured.
std::string equivalence_in_words(const Explosive &explosive);

/// A probability in per cent: "more than 99 %", "less than 0.1 %".
std::string percent(double probability);

/// The entry Charge/Distance after a blank, in brackets, where the nearest
/// point of the skin is not where the line along -x meets it; else "".
std::string distance_along_x(const SceneParameters &scene,
                             const SceneLayout &layout);

/**
 * A first answer without a run, as lines for the screen: the blast wave at the
 * body's distance by the tables of Kingery and Bulmash for the TNT equivalence
 * of the explosive, and what its incident and its reflected peak would do to
 * eardrums and lungs. The ground counts for a surface burst; else its
 * reflection is left out, as are those by walls that the user adds, with a word
 * on their size if a run has them, and afterburn, the body's shape and, where
 * injury is asked for, its tissues. The ModelBias of a run, if it was measured.
 *
 * @param body_mass [kg]
 * @param person who is in the scene, in words; empty: not said
 * @param sides of the domain that the user chose
 */
std::vector<std::string>
first_answer(const SceneParameters &scene,
             const SceneLayout &layout,
             double body_mass,
             const std::string &person = "",
             const std::vector<ChosenSide> &sides = {});
} // namespace contrecoup::coupling
