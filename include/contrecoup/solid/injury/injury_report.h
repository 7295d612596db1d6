// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/simulation.h>
#include <contrecoup/solid/body/surface_patch.h>
#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/injury/brain_record.h>
#include <contrecoup/solid/injury/chest_injury.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * Follows what injures: strains and pressures in the brain, motion of the head,
 * pressure on the chest. Subsection "Injury".
 */
template <typename Real>
class InjuryReport
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether anything is followed.
  bool active() const
  {
    return active_;
  }

  /// @p body must outlive this.
  void reinit(const SolidBody<Real> &body);

  /// Call after each step. Collective.
  void follow(const SolidBody<Real> &body);

  /// Of the brain as it is now, by volume: the principal strain that 95 % of it
  /// does not exceed, and the pressures that 95 % and 5 % do not. Collective.
  std::vector<NamedValue> history(const SolidBody<Real> &body) const;

  /// What was found so far. Collective.
  std::vector<InjuryMeasure> measures(const SolidBody<Real> &body) const;

  /// Of this rank, into and from @p folder.
  void save(const SolidBody<Real> &body, const std::string &folder) const;
  void restore(const SolidBody<Real> &body, const std::string &folder);

private:
  void follow_brain(const SolidBody<Real> &body, const double span);
  void follow_head(const SolidBody<Real> &body);
  void add_brain(const SolidBody<Real> &body,
                 std::vector<InjuryMeasure> &list) const;
  void add_head(std::vector<InjuryMeasure> &list) const;

  bool active_ = false;
  bool averaged_ = true; ///< whether pressures are
  unsigned int interval_ = 10;
  ChestInjury chest_;
  SurfacePatch chest_wall_;
  unsigned int brain_ = 0; ///< index of the tissue; number of tissues: none
  TissueAverage average_;  ///< over the brain
  std::vector<std::uint32_t> piece_of_cell_;
  BrainRecord record_;
};
} // namespace contrecoup::solid
