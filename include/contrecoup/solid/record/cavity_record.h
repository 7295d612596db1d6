// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/run/simulation.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <string>
#include <vector>

namespace contrecoup::solid
{
/**
 * Cavities of tissues with a bounded tension (SolidMaterial::cavitates()):
 * their volume over time, and the pressures at which they collapse.
 */
template <typename Real>
class CavityRecord
{
public:
  /// @p body must outlive this.
  void reinit(const SolidBody<Real> &body);

  /// Whether any tissue cavitates, the same on all ranks.
  bool active() const
  {
    return !tissues_.empty();
  }

  /// Call after each step. Collective.
  void record(const SolidBody<Real> &body);

  /// Volume of the cavities by tissue, as "vapour_volume_brain" [m^3].
  std::vector<NamedValue> history(const SolidBody<Real> &body) const;

  /// By tissue the largest volume of cavities over time, with its time, and
  /// the highest pressure of an element after it had held a cavity, with the
  /// time and the centre of the undeformed element; zero without any. A volume
  /// that grows, and a pressure that grows or while cavities are open, have a
  /// "NAME_cut_off", which is 1. Collective.
  std::vector<NamedValue> measures(const SolidBody<Real> &body) const;

  /// Saves this rank's part to @p folder, or restores what any number of
  /// ranks saved. @throws InputError for files of another scene
  void save(const SolidBody<Real> &body, const std::string &folder) const;
  void restore(const SolidBody<Real> &body, const std::string &folder);

private:
  /// An element that held a cavity.
  struct Collapse
  {
    std::uint32_t held = 0;
    float highest = 0.F; ///< pressure after the cavity [Pa]
    double time = 0.;    ///< of that pressure [s]
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
