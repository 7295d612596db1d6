// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/coupling/scene/scene_layout.h>
#include <contrecoup/coupling/scene/scene_parameters.h>

#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * A first answer without a run, as lines for the screen: the blast wave at the
 * body's distance by the tables of Kingery and Bulmash for the TNT equivalence
 * of the explosive, and what its incident and its reflected peak would do to
 * eardrums and lungs. Ground reflection, afterburn, the body's shape and its
 * tissues are left out.
 *
 * @param body_mass [kg]
 */
std::vector<std::string> first_answer(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const double body_mass);
} // namespace contrecoup::coupling
