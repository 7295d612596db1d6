// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/conditions/initial_state.h>
#include <contrecoup/gas/conditions/reference_solution.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>
#include <contrecoup/materials/gas_material.h>

#include "../set_entries.h"

#include <string>
#include <vector>

namespace contrecoup::gas
{
/// Initial state and reference as a parameter file with the given
/// "Section/Entry=value" lines would set them.
template <int dim>
class Scene
{
public:
  explicit Scene(const std::vector<std::string> &lines)
  {
    CoarseMesh<dim>::declare_parameters(prm_);
    GasMaterial::declare_parameters(prm_);
    InitialState<dim>::declare_parameters(prm_);
    ReferenceSolution<dim>::declare_parameters(prm_);

    set_entries(prm_, lines);

    material.parse_parameters(prm_);
    initial.parse_parameters(prm_, material);
    reference.parse_parameters(prm_, material);
  }

  GasMaterial material;
  InitialState<dim> initial;
  ReferenceSolution<dim> reference;

private:
  dealii::ParameterHandler prm_;
};

/// The message with which a scene is refused; empty when it is not.
template <int dim>
std::string refusal(const std::vector<std::string> &lines)
{
  try
  {
    Scene<dim> scene(lines);
  }
  catch (const InputError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace contrecoup::gas
