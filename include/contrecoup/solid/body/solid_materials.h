// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/own_tissues.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Material of each tissue: subsection "Materials".
class SolidMaterials
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Call before names of tissues are read elsewhere: new ones become known.
  /// @throws InputError for properties that no stable solid has
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a tissue without properties
  SolidMaterial find(Tissue tissue) const;

  /// Materials of several tissues, in the order of @p tissues.
  std::vector<SolidMaterial> find(const std::vector<Tissue> &tissues) const;

  /// Changes of a tissue of the library by the file, or values of a new one:
  /// "Shear modulus = 2000 Pa instead of 2.857e+07"; empty: nothing.
  std::string changes(Tissue tissue) const;

  /// Name of the set of the library.
  const std::string &set() const
  {
    return set_;
  }

  /// Tissues that cavitate.
  const std::vector<Tissue> &cavitating() const
  {
    return cavitating_;
  }

  /// Tissues that have a section of their own.
  std::vector<Tissue> own() const
  {
    return own_.tissues();
  }

private:
  SolidMaterial of_library(Tissue tissue) const;

  std::string set_;
  bool has_gas_ = true; ///< whether the lung of a set contains air
  bool g1_is_long_term_ = false;
  std::vector<Tissue> cavitating_;
  double largest_tension_ = no_cavitation; ///< of cavitating tissues [Pa]
  OwnTissues own_;
};
} // namespace contrecoup::solid
