// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/solid_material.h>

#include <deal.II/base/parameter_handler.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup
{
/**
 * Tissues of the user's own: subsections "Tissue NAME". Each of their entries
 * replaces one property of the tissue of this name in the library and leaves
 * the others as they are. A name that is not in the library makes a new tissue,
 * which needs a density and two moduli.
 */
class OwnTissues
{
public:
  /// Declares "Tissue *" in the current subsection.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /**
   * Reads all "Tissue NAME" of a section, and makes new names known to
   * find_tissue(): call this before names of tissues are read.
   * @param section path of the section that holds them: "Materials"
   * @throws InputError for a new tissue without enough entries, for entries
   * that contradict each other, and for those without an effect
   */
  void parse_parameters(dealii::ParameterHandler &prm,
                        const std::string &section);

  /// All tissues that have entries, in the order of the file.
  std::vector<Tissue> tissues() const;

  /**
   * The material of a tissue, with what the entries change.
   * @param library its properties in the library; not used for new tissues
   * @throws InputError, naming the entries, for what no stable solid has, and
   * for a new tissue without entries, which another run of the process made
   */
  SolidMaterial apply(Tissue tissue, const SolidMaterial &library) const;

  /// An entry that replaces a property.
  struct Change
  {
    std::string entry;
    std::string unit; ///< "-" for none
    double value;
    std::optional<double> before; ///< in the library; none of a new tissue

    /// The value with its unit, "Density = 1100 kg/m^3".
    std::string in_words() const;
  };

  /// Changes by the entries of a tissue; empty for a tissue without entries.
  std::vector<Change> changes(Tissue tissue,
                              const SolidMaterial &library) const;

  /// The same in words: "Density = 1100 kg/m^3 instead of 1000, ...".
  std::string changes_in_words(Tissue tissue,
                               const SolidMaterial &library) const;

private:
  /// Entries of a tissue, by name; those that the file leaves out are missing.
  struct Entries
  {
    Tissue tissue;
    std::string path;
    std::map<std::string, double> values;

    bool has(const std::string &name) const
    {
      return values.count(name) > 0;
    }
    double value_or(const std::string &name, double other) const
    {
      return has(name) ? values.at(name) : other;
    }
    void refuse_contradictions() const;
    void refuse_incomplete(const std::string &name) const;
    void set_moduli(SolidMaterial &material) const;
    void set_relaxation(SolidMaterial &material) const;
    void set_gas(SolidMaterial &material) const;
  };

  const Entries *find(Tissue tissue) const;

  std::vector<Entries> entries_;
};

/// The material of a tissue of a set, with the user's changes; new tissues
/// have these alone. @throws InputError as OwnTissues::apply()
SolidMaterial find_solid_material(const std::string &set,
                                  Tissue tissue,
                                  const OwnTissues &own);
} // namespace contrecoup
