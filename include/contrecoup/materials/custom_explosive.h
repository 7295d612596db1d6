// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/explosives.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// An explosive of the user: one of the library with some entries changed.
struct CustomExplosive
{
  /// A changed entry.
  struct Change
  {
    std::string entry;
    std::string unit;
    double value;
    double before; ///< that of the library
  };

  /// Named "custom". Published detonation speed and pressure of the library
  /// count as long as no constant is changed, its TNT equivalence as long as
  /// the energy per mass is the same; with another, the equivalence is the
  /// ratio of energies. The heat of combustion is that of the library.
  Explosive explosive;
  std::string like; ///< explosive of the library
  std::vector<Change> changes;

  /// Entries, in the order of declaration, without "Like".
  static const std::vector<std::string> &entry_names();

  /// Declares the entries in the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads the entries of the current subsection.
   * @param section its path, for messages
   * @throws InputError for constants without a real sound speed
   */
  void parse_parameters(const dealii::ParameterHandler &prm,
                        const std::string &section);
};

/// The explosive named by entry "Explosive" of the current subsection, of the
/// library or that of "Custom explosive" there.
/// @throws InputError as CustomExplosive::parse_parameters()
Explosive read_explosive(dealii::ParameterHandler &prm);

/**
 * Checks that the products of @p explosive can release @p energy [J/kg] by
 * afterburn: none, the usual energy, or up to complete combustion but no less
 * than any fuel has, as numbers in MJ/kg are.
 * @param entry of this energy, for messages
 * @throws InputError for another energy
 */
void check_afterburn(const Explosive &explosive,
                     double energy,
                     const std::string &entry);
} // namespace contrecoup
