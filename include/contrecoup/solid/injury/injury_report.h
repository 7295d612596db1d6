// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/solid/body/surface_patch.h>
#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/injury/brain_record.h>
#include <contrecoup/solid/injury/chest_injury.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <deal.II/base/parameter_handler.h>

#include <limits>
#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Records injury measures: strain and pressure in the brain, motion of the
/// head, pressure on the chest. Subsection "Injury".
template <typename Real>
class InjuryReport
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @param phantom_mass of the body [kg]; NaN: it is no phantom
  void parse_parameters(
    dealii::ParameterHandler &prm,
    double phantom_mass = std::numeric_limits<double>::quiet_NaN());

  /// Whether recording is active.
  bool active() const
  {
    return active_;
  }

  /// Thresholds that are not the published ones, and the mass of the person
  /// beside that of @p body, by which lungs are judged. Collective.
  std::vector<Assumption> assumptions(const SolidBody<Real> &body) const;

  /// Thresholds that are not the published ones.
  const OwnThresholds &own_thresholds() const
  {
    return own_;
  }

  /// @p body must outlive this. @throws InputError if the body has a lung but
  /// no surface near the chest
  void reinit(const SolidBody<Real> &body);

  /// Finds the surface near the chest, as reinit() does. Collective.
  /// @throws InputError if the body has a lung but no surface there
  void find_chest(const SolidMesh &mesh, MPI_Comm communicator);

  /// Call after each step. Collective.
  void record(const SolidBody<Real> &body);

  /// Percentiles by volume of the brain at the present: 95 % of principal
  /// strain, 95 % and 5 % of pressure. Collective.
  std::vector<NamedValue> history(const SolidBody<Real> &body) const;

  /// All measures recorded so far. Collective.
  std::vector<InjuryMeasure> measures(const SolidBody<Real> &body) const;

  /// Saves the record of this rank to @p folder, or restores it.
  void save(const SolidBody<Real> &body, const std::string &folder) const;
  void restore(const SolidBody<Real> &body, const std::string &folder);

private:
  void follow_brain(const SolidBody<Real> &body, const double span);
  void follow_head(const SolidBody<Real> &body);
  static bool has(const Tissue tissue, const SolidMesh &mesh);
  /// @throws InputError if the chest is not on the body's surface
  void refuse_far_chest() const;
  void find_skull(const SolidBody<Real> &body);
  void add_brain(const SolidBody<Real> &body,
                 std::vector<InjuryMeasure> &list) const;
  void add_head(const SolidBody<Real> &body,
                std::vector<InjuryMeasure> &list) const;

  bool active_ = false;
  bool averaged_ = true; ///< pressures, over neighbours
  unsigned int interval_ = 10;
  OwnThresholds own_;
  ChestInjury chest_;
  SurfacePatch chest_wall_;
  /// index of the tissue; number of tissues if there is none
  unsigned int brain_ = 0;
  TissueAverage average_; ///< of the brain
  std::vector<std::uint32_t> sample_of_element_;
  /// Elements of bone at the brain, with their volumes [m^3].
  std::vector<std::pair<std::uint32_t, double>> skull_;
  bool has_skull_ = false; ///< on any rank
  BrainRecord record_;
};
} // namespace contrecoup::solid
