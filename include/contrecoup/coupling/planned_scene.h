// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/coupling/scene_layout.h>
#include <contrecoup/coupling/tissue_places.h>
#include <contrecoup/geometry/body_description.h>

#include <optional>

namespace contrecoup::coupling
{
/// What is known of a scene before anything of it is computed.
class PlannedScene
{
public:
  /// @param prm the scene's entries, declared and read
  /// @throws InputError for a scene that is not possible
  explicit PlannedScene(dealii::ParameterHandler &prm);

  const SceneParameters &parameters() const
  {
    return parameters_;
  }

  /// Kind of the body: phantom, image, and so on.
  const std::string &body_kind() const
  {
    return description_.kind();
  }

  const Body &body() const
  {
    return *body_;
  }

  /// [kg]
  double body_mass() const
  {
    return body_mass_;
  }

  const SceneLayout &layout() const
  {
    return *layout_;
  }

  /// Where biomechanics takes histories; none unless injuries are asked for.
  const std::vector<TissuePlace> &tissue_places() const
  {
    return tissue_places_;
  }

  /// What it takes for granted, without its blast.
  const std::vector<Assumption> &plan() const
  {
    return plan_;
  }

  /// Logs all of this.
  void print() const;

private:
  /// Its mass, and places in its tissues if injuries are asked for.
  void find_body();

  SceneParameters parameters_;
  BodyDescription description_;
  BodyPointer body_;
  double body_mass_ = 0.;
  std::optional<SceneLayout> layout_;
  std::vector<TissuePlace> tissue_places_;
  std::vector<Assumption> plan_;
};
} // namespace contrecoup::coupling
