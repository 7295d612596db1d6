// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/record/solid_recorder.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * Cavities of tissues with a bounded tension (SolidMaterial::cavitates()):
 * their volume over time, and the pressures at which they collapse.
 */
template <typename Real>
class CavityRecord : public SolidRecorder<Real>
{
public:
  void reinit(const SolidBody<Real> &body) override;
  void record(const SolidBody<Real> &body) override;

  /// Volume of the cavities by tissue, as "vapour_volume_brain" [m^3].
  std::vector<NamedValue> history(const SolidBody<Real> &body) const override;

  /// By tissue the largest volume of cavities over time, with its time, and
  /// the highest pressure of an element after it had held a cavity, with the
  /// time and the centre of the undeformed element; zero without any. A volume
  /// that grows, and a pressure that grows or while cavities are open, have a
  /// "NAME_cut_off", which is 1.
  std::vector<NamedValue> results(const SolidBody<Real> &body) const override;

  void save(const SolidBody<Real> &body,
            const std::string &folder) const override;
  void restore(const SolidBody<Real> &body, const std::string &folder) override;

private:
  /// An element that held a cavity.
  struct Collapse
  {
    std::uint32_t held = 0;
    float highest = 0.F; ///< pressure after the cavity [Pa]
    double time = 0.;    ///< of that pressure [s]
  };
  /// The same in a checkpoint.
  struct CollapseRecord
  {
    std::uint32_t number; ///< of the element in the whole mesh
    Collapse collapse;
  };

  /// A cavitating tissue.
  struct Cavities
  {
    unsigned int tissue = 0;             ///< in the mesh
    std::vector<std::uint32_t> elements; ///< of this rank
    std::vector<double> volumes;         ///< undeformed [m^3]
    std::vector<Collapse> collapses;     ///< by element
    double volume = 0.;                  ///< of all ranks [m^3]
    double largest = 0.;                 ///< volume over time [m^3]
    double time = 0.;                    ///< of the largest volume [s]
  };

  void record_elements(const SolidBody<Real> &body, Cavities &one) const;

  std::vector<Cavities> tissues_;
};
} // namespace contrecoup::solid
