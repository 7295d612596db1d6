// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/surface_patch.h>
#include <contrecoup/solid/body/tissue_average.h>
#include <contrecoup/solid/injury/brain_record.h>
#include <contrecoup/solid/injury/chest_injury.h>
#include <contrecoup/solid/record/solid_recorder.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/// Records injury measures: strain and pressure in the brain, motion of the
/// head, pressure on the chest. Subsection "Injury".
template <typename Real>
class InjuryReport : public SolidRecorder<Real>
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm,
                        const MeshDescription &mesh) override;
  bool active() const
  {
    return active_;
  }

  /// Thresholds that are not the published ones, and the mass of the person
  /// alongside that of @p body, by which lungs are judged. Collective.
  std::vector<Assumption> assumptions(const SolidBody<Real> &body) const;

  /// Thresholds that are not the published ones.
  const OwnThresholds &own_thresholds() const
  {
    return own_;
  }

  /// Finds the surface near the chest, as reinit() does.
  /// @throws InputError if the body has a lung but no surface there
  void check(const SolidMesh &mesh, MPI_Comm communicator) override;

  void reinit(const SolidBody<Real> &body) override;
  void record(const SolidBody<Real> &body) override;

  /// Percentiles by volume of the brain at the present: 95 % of principal
  /// strain, 95 % and 5 % of pressure.
  std::vector<NamedValue> history(const SolidBody<Real> &body) const override;

  /// All measures recorded so far. Collective.
  std::vector<InjuryMeasure> measures(const SolidBody<Real> &body) const;
  std::vector<NamedValue> results(const SolidBody<Real> &body) const override
  {
    return active_ ? values_of(measures(body)) : std::vector<NamedValue>();
  }

  void save(const SolidBody<Real> &body,
            const std::string &folder) const override;
  void restore(const SolidBody<Real> &body, const std::string &folder) override;

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
