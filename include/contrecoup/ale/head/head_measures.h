// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/solid/body/nodal_average.h>
#include <contrecoup/solid/injury/brain_record.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/**
 * Follows what injures a head: strains and pressures in the brain, the motion
 * of the skull, or of the brain where there is no skull. Subsection "Injury".
 * Parts between planes of symmetry have the measures of the whole: parts of the
 * brain are the same, and the skull moves along the planes and turns about the
 * normal of one.
 */
class HeadMeasures
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether there is a brain or a skull.
  bool active() const
  {
    return brain_ != none || skull_ != none;
  }

  /// Of the undeformed mesh.
  /// @throws InputError for a region that is no solid
  void reinit(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<Region> &regions);

  /// Call before the first step and after each. Collective.
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state);

  /// What was found so far. Collective.
  std::vector<solid::InjuryMeasure> measures(const MPI_Comm communicator) const;

  /// Of this rank, into and from @p folder. restore() follows reinit().
  /// @throws InputError for a checkpoint of something else
  void save(const std::string &folder, const MPI_Comm communicator) const;
  void restore(const std::string &folder, const MPI_Comm communicator);

private:
  static constexpr unsigned int none = -1;

  static unsigned int find(const std::vector<Region> &regions,
                           const std::string &entry,
                           const std::string &name);
  void follow_brain(const LagrangeStep &lagrange,
                    const AleState &state,
                    const double span);
  void follow_motion(const HexSpace &space, const AleState &state);
  /// Whose motion is that of the head.
  unsigned int moving_region() const
  {
    return skull_ != none ? skull_ : brain_;
  }

  std::string brain_name_, skull_name_;
  bool averaged_ = true; ///< whether pressures are
  unsigned int interval_ = 10;
  SymmetryPlanes is_mirrored_{};
  unsigned int brain_ = none; ///< region
  unsigned int skull_ = none;
  std::vector<std::uint32_t> cells_; ///< of the brain, own ones
  solid::NodalAverage average_;      ///< over cells_
  solid::BrainRecord record_;        ///< speeds are of moving_region()
};
} // namespace contrecoup::ale
