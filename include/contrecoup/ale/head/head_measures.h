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
 * Records injury measures of a head: strain and pressure in the brain, and the
 * motion of the skull, or of the brain in a mesh without skull. Subsection
 * "Injury". With symmetry planes, the measures are those of the whole head:
 * velocities normal to the planes are zero, and rotation is about the normal
 * of one plane.
 */
class HeadMeasures
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether the mesh has a brain or a skull.
  bool active() const
  {
    return brain_ != none || skull_ != none;
  }

  /// Selects the cells of the undeformed mesh.
  /// @throws InputError if brain or skull are no solids
  void reinit(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state,
              const std::vector<Region> &regions);

  /// Call before the first step and after each step. Collective.
  void follow(const HexSpace &space,
              const LagrangeStep &lagrange,
              const AleState &state);

  /// Measures recorded so far. Collective.
  std::vector<solid::InjuryMeasure> measures(const MPI_Comm communicator) const;

  /// Saves this rank's record to @p folder, or restores it after reinit().
  /// @throws InputError for a checkpoint of another scene
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
  /// The region whose motion is that of the head.
  unsigned int moving_region() const
  {
    return skull_ != none ? skull_ : brain_;
  }

  std::string brain_name_, skull_name_;
  bool averaged_ = true; ///< pressures, over neighbours
  unsigned int interval_ = 10;
  SymmetryPlanes is_mirrored_{};
  unsigned int brain_ = none; ///< region number
  unsigned int skull_ = none;
  std::vector<std::uint32_t> cells_; ///< locally owned cells of the brain
  solid::NodalAverage average_;      ///< over cells_
  solid::BrainRecord record_;        ///< with velocities of moving_region()
};
} // namespace contrecoup::ale
