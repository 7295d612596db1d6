// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/solid_material.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Material of each tissue: subsection "Materials".
class SolidMaterials
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for properties that no stable solid has
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a tissue without properties
  SolidMaterial find(Tissue tissue) const;

  /// Materials of several tissues, in the order of @p tissues.
  std::vector<SolidMaterial> find(const std::vector<Tissue> &tissues) const;

private:
  std::string set_;
  bool has_gas_ = true; ///< whether the lung of a set contains air
  bool g1_is_long_term_ = false;
  std::vector<Tissue> cavitating_;
  double largest_tension_ = no_cavitation; ///< of cavitating tissues [Pa]
  std::map<Tissue, SolidMaterial> custom_;
};
} // namespace contrecoup::solid
