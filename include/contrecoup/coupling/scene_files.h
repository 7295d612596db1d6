// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameter_file.h>
#include <contrecoup/coupling/scene_layout.h>
#include <contrecoup/coupling/scene_words.h>
#include <contrecoup/coupling/tissue_places.h>
#include <contrecoup/geometry/body.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

namespace contrecoup::coupling
{
/// @name What the stages of a scene are given: the entries that make the
/// parameter file of each application, without the body itself. Their origins
/// are the entries of the scene that they follow from, if they do.
/// @{
std::vector<Assignment> anatomy_entries(const SceneParameters &scene);

/**
 * The blast: a charge above rigid ground in 1-D, then in 2-D around the
 * vertical through it, then in 3-D with the body, whose facets record their
 * loads. Cells grow away from the body, and with time once the front has
 * passed.
 * @param body_mass [kg]
 */
std::vector<Assignment> blast_entries(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const double body_mass);

/// The body under these loads, whose file is given later.
std::vector<Assignment>
biomechanics_entries(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const Body &body,
                     const std::vector<TissuePlace> &places,
                     double body_mass);
/// @}

/// A stage's parameter file.
struct StageText
{
  std::string text; ///< with every entry
  SceneWords words; ///< for what the stage says about them
};


/**
 * The parameter file of a stage.
 * @param entries of the scene's choice, in the order in which they win
 * @param scene all entries of the scene's file, of which the body and those
 * under @p name, which the user @p wrote, win over these
 * @param declare declares the entries of the application
 * @throws InputError for entries that the application does not have
 */
StageText
stage_text(const std::string &name,
           const std::vector<Assignment> &entries,
           const dealii::ParameterHandler &scene,
           const std::vector<Assignment> &wrote,
           const std::function<void(dealii::ParameterHandler &)> &declare);
} // namespace contrecoup::coupling
