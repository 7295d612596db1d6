// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/coupling/scene/scene_files.h>

namespace contrecoup::coupling
{
/**
 * Checks entries of the blast that the user wrote against the scene: the domain
 * must hold body and charge, the run must last until the front is at the body
 * and beyond the hand-over of its first stage, probes must be in the air,
 * gauges within their radius and two cells of the skin.
 * @throws InputError that names the entry and what is allowed
 */
void check_blast(const PlannedScene &scene, const TaskText &blast);

/**
 * A warning where the domain that the user wrote lets the front come back from
 * an open side, taken as a mirror, to a probe, also one of a line or a plane,
 * before the end of the scene;
 * empty: it does not.
 */
std::string reflection_warning(const PlannedScene &scene,
                               const TaskText &blast);

/// A warning where an open side of the user's domain is so near that the front
/// runs along it before it reaches the body; empty: none is.
std::string grazing_warning(const PlannedScene &scene);

/**
 * A warning where probes, lines and planes of gauges have coarser cells than
 * fronts at the body, too coarse for the cells that the positive phase should
 * have there; empty: they have not.
 */
std::string gauge_cells_warning(const PlannedScene &scene,
                                const TaskText &blast);

/**
 * Checks biomechanics against the blast: it may not last longer than the loads,
 * and its probes must be within an element of the body.
 * @throws InputError that names the entry and what is allowed
 */
void check_biomechanics(const PlannedScene &scene,
                        const TaskText &blast,
                        const TaskText &biomechanics);
} // namespace contrecoup::coupling
