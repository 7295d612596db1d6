// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/coupling/scene/scene_layout.h>
#include <contrecoup/coupling/scene/tissue_places.h>
#include <contrecoup/coupling/task/scene_words.h>
#include <contrecoup/geometry/body/body.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// @name Parameter files of the tasks of a scene: entries without the body
/// itself. The origin of an entry is the entry of the scene that determines
/// it, if any.
/// @{
std::vector<Assignment> anatomy_entries(const SceneParameters &scene);

/**
 * Entries of the blast: a charge above rigid ground in 1-D, then in 2-D around
 * the vertical axis through it, then in 3-D with the body, whose facets record
 * loads. Leaves get coarser with distance from the body and, once the front
 * has passed, with time.
 * @param body_mass [kg]
 */
std::vector<Assignment> blast_entries(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const double body_mass);

/// Entries of the body under the recorded loads; the load file is set later.
std::vector<Assignment>
biomechanics_entries(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const Body &body,
                     const std::vector<TissuePlace> &places,
                     double body_mass);
/// @}

/// Changes to the entries of a stage, as a function of the entries.
using EntryChanges =
  std::function<std::vector<Assignment>(const dealii::ParameterHandler &)>;

/// Parameter file of a task.
struct TaskText
{
  std::string text; ///< content, all entries
  SceneWords words; ///< translation of the task's messages
  std::vector<Assignment> entries;
  std::map<std::string, std::string> values; ///< by path of the entry
  /// Warnings of find_unused() for what the user wrote.
  std::vector<std::string> unused;
  /// Entries of the user with another value than the stage has without them.
  std::vector<ChangedEntry> changes;
};


/**
 * Content of the parameter file that repeats a scene: all entries of the scene
 * itself, and of its stages those that the user wrote, for the scene determines
 * the others.
 * @param prm all entries of the scene
 * @param wrote all assignments of the user
 */
std::string scene_text(const dealii::ParameterHandler &prm,
                       const std::vector<Assignment> &wrote);


/**
 * Builds the parameter file of a task.
 * @param entries chosen by the scene, in order of increasing priority
 * @param scene all entries of the scene's file; those of the body and those
 * under @p name that the user @p wrote override @p entries
 * @param declare declares the entries of the application
 * @param changes changes to the resulting entries; empty: none
 * @param given entries that the task gets besides the file, if it has them
 * @throws InputError for entries that the application does not have, and for
 * those of the user that contradict an entry of the scene which describes the
 * charge, the body or its elements
 */
TaskText
task_text(const std::string &name,
          const std::vector<Assignment> &entries,
          const dealii::ParameterHandler &scene,
          const std::vector<Assignment> &wrote,
          const std::function<void(dealii::ParameterHandler &)> &declare,
          const EntryChanges &changes = {},
          const std::vector<Assignment> &given = {});
} // namespace contrecoup::coupling
