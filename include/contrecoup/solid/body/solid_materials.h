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
/// What each tissue is made of: subsection "Materials".
class SolidMaterials
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for numbers that are no solid
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a tissue without properties
  SolidMaterial find(Tissue tissue) const;

  /// The materials of tissues, in their order.
  std::vector<SolidMaterial> find(const std::vector<Tissue> &tissues) const;

private:
  std::string set_;
  bool has_gas_ = true; ///< in the tissues of the set that hold some
  bool g1_is_long_term_ = false;
  std::map<Tissue, SolidMaterial> custom_;
};
} // namespace contrecoup::solid
