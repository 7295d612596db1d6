// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * What each element went through so far: highest and lowest pressure, largest
 * von Mises stress and largest principal strain, for the fields, and by tissue
 * for the summary. Subsection "Peaks".
 */
template <typename Real>
class PeakFields
{
public:
  static constexpr unsigned int n_fields = 4;

  /// Names of the fields.
  static const std::array<std::string, n_fields> names;

  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether peaks are kept.
  bool active() const
  {
    return active_;
  }

  /// @p body must outlive this. Collective.
  void reinit(const SolidBody<Real> &body);

  /// Call after each step. Collective.
  void follow(const SolidBody<Real> &body);

  /// Of each tissue, as "highest_pressure_brain": the extremes of its elements
  /// and, as "principal_strain_95_brain", the largest principal strain that 95
  /// % of its volume never exceeded. Collective.
  std::vector<NamedValue> measures(const SolidBody<Real> &body) const;

  /// A field by elements of this rank, by its number in names.
  const std::vector<float> &field(const unsigned int number) const
  {
    return fields_[number];
  }

  /// Of this rank, into and from @p folder; any number of ranks wrote.
  /// @throws InputError for files of another scene
  void save(const SolidBody<Real> &body, const std::string &folder) const;
  void restore(const SolidBody<Real> &body, const std::string &folder);

private:
  bool active_ = false;
  bool averaged_ = true; ///< whether pressures are
  unsigned int interval_ = 10;
  std::uint64_t n_steps_ = 0;
  std::vector<TissueAverage> averages_; ///< by tissue
  std::array<std::vector<float>, n_fields> fields_;
};
} // namespace contrecoup::solid
