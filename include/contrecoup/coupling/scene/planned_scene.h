// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/base/run/simulation.h>
#include <contrecoup/coupling/scene/person.h>
#include <contrecoup/coupling/scene/scene_layout.h>
#include <contrecoup/coupling/scene/scene_plan.h>
#include <contrecoup/coupling/scene/tissue_places.h>
#include <contrecoup/geometry/body/body_description.h>

#include <optional>

namespace contrecoup::coupling
{
/// Scene before any computation: parameters, body, layout and plan.
class PlannedScene
{
public:
  /// @param prm entries of the scene, declared and parsed
  /// @param wrote all assignments of the user
  /// @throws InputError for an impossible scene
  PlannedScene(dealii::ParameterHandler &prm,
               const std::vector<Assignment> &wrote);

  const SceneParameters &parameters() const
  {
    return parameters_;
  }

  /// Adds entries of stages to those that are shown as changed.
  void add_changes(const std::vector<ChangedEntry> &changes);

  /// Kind of the body: phantom, image, ...
  const std::string &body_kind() const
  {
    return description_.kind();
  }

  const Body &body() const
  {
    return *body_;
  }

  /// Whether a part of the body is of this tissue.
  bool has(Tissue tissue) const;

  /// Mass by which injuries of the lungs are judged: of the body, or of an
  /// adult where it has no lungs [kg].
  double person_mass() const;

  /// Who is in the scene and how the person is turned to the charge.
  const Person &person() const
  {
    return *person_;
  }

  const SceneLayout &layout() const
  {
    return *layout_;
  }

  /// The gauge on the skin that is nearest to the charge, of those whose last
  /// words are one of @p parts, or of all; nothing of a body without such.
  std::optional<Landmark>
  nearest_gauge(const std::vector<std::string> &parts = {}) const;

  /// The layout with the distance of the trunk, where this is much farther from
  /// the charge than the nearest skin, as with a charge at the feet, or where
  /// no probe has the wave next to the body: there its skin tells of the lungs.
  std::optional<SceneLayout> layout_at_trunk() const;

  /// The layout with the distance of the nearer ear.
  std::optional<SceneLayout> layout_at_ears() const;

  /// Probes of biomechanics in tissues; empty unless injury is asked for.
  const std::vector<TissuePlace> &tissue_places() const
  {
    return tissue_places_;
  }

  /// Sides of the domain that the user chose.
  const std::vector<ChosenSide> &sides() const
  {
    return sides_;
  }

  /// Assumptions of the scene, without those of its blast.
  const std::vector<Assumption> &plan() const
  {
    return plan_;
  }

  /// Shows the layout, and remarks and plan too if @p with_plan; else these
  /// are details.
  void print(bool with_plan) const;

  /// Answer of the tables alone, as lines for the screen.
  std::vector<std::string> first_answer() const;

  /// Remarks on the body and on layers that are thinner than its elements.
  const std::vector<std::string> &remarks() const
  {
    return remarks_;
  }

  /// A warning of layers that may be in pieces, which the stage anatomy knows.
  const std::vector<std::string> &uncertain_layers() const
  {
    return uncertain_layers_;
  }

private:
  /// The layout with the distance of nearest_gauge().
  std::optional<SceneLayout>
  layout_at(const std::vector<std::string> &parts) const;
  /// Answer of the tables on lungs at layout_at_trunk(); empty without one.
  std::string answer_at_trunk() const;
  /// The same of a wave along the body; empty unless it comes from head or
  /// feet.
  std::string answer_along_body() const;
  /// Answer of the tables on eardrums at layout_at_ears(); empty where it is
  /// the same at the nearest skin.
  std::string answer_at_ears() const;
  /// The elements of the body and their size.
  std::string elements_in_words() const;

  /// Computes the mass of the body and, if injury is asked for, the probes in
  /// tissues.
  void find_body(dealii::ParameterHandler &prm);
  void find_remarks(dealii::ParameterHandler &prm);
  /// @throws InputError for thresholds of a measure that this scene has not
  void require_measures() const;

  SceneParameters parameters_;
  BodyDescription description_;
  BodyPointer body_;
  double body_mass_ = 0.;
  std::optional<Person> person_;
  std::optional<SceneLayout> layout_;
  std::vector<TissuePlace> tissue_places_;
  std::vector<ChosenSide> sides_;
  std::vector<Assumption> plan_;
  std::vector<std::string> remarks_, uncertain_layers_;
};
} // namespace contrecoup::coupling
