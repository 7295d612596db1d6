// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>

#include <limits>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * Parameters of the first stage, read from subsection "First stage": spherical
 * around the centre of the charge, or axisymmetric around the vertical through
 * it, until the front comes close to anything without that symmetry; or
 * spherical first, then axisymmetric.
 */
class FirstStageParameters
{
public:
  /// Declares subsection "First stage".
  static void declare_parameters(ParameterHandler &prm);

  /// @throws InputError for entries that cannot be combined.
  void parse_parameters(ParameterHandler &prm);

  /// Says that a hand-over at a time is too late for a run until @p end_time
  /// [s]; empty: it is not.
  std::string late_hand_over(const double end_time) const;

  std::string kind = "none"; ///< none, spherical, axisymmetric
  double cell_size = 0.001;  ///< edge of the smallest subcells [m]
  unsigned int levels = 3;   ///< refinement levels, if axisymmetric
  /// Edge of the subcells of the spherical stage before an axisymmetric one
  /// [m]; 0: no such stage, as with any other kind.
  double spherical_cell_size = 0.;
  std::string criterion = "auto"; ///< auto, time, radius
  double time = 0.;               ///< time of the hand-over [s]
  double radius = 0.; ///< distance of the front at the hand-over [m]
};


/// Position of the charge in a scene, and the distances up to which the blast
/// has the symmetry of the first stage.
template <int dim>
struct FirstStageLayout
{
  /// Centre of spheres or, for an axisymmetric stage, the foot of the axis
  /// [m].
  dealii::Point<dim> centre;
  /// Distance from the centre or the axis to the nearest side of the domain
  /// that is not a plane of symmetry through it [m].
  double nearest_side = std::numeric_limits<double>::max();
  /// Distance from the charge along the axis of an axisymmetric stage to the
  /// nearest such side [m].
  double along_axis = 0.;
  /// Distance to the farthest corner [m].
  double farthest = 0.;
  /// Fraction of the full blast within the domain [-]: 1, halved for each side
  /// of the domain through the centre.
  double domain_fraction = 1.;
  /// For each direction, the side of such a plane on which the domain lies, -1
  /// or 1; 0: both sides.
  std::array<int, dim> side{};
  /// Radius of the domain of the first stage [m].
  double domain_radius = 0.;
};


/**
 * Locates the charge in the scene, which must consist of spheres around one
 * centre (for an axisymmetric stage also upright cylinders, ignited on the
 * axis), and measures the domain around it.
 * @throws InputError for scenes that cannot begin with a first stage
 */
template <int dim>
FirstStageLayout<dim>
make_first_stage_layout(ParameterHandler &scene,
                        const FirstStageParameters &parameters);

/**
 * Sets the entries of the first stage, which has @p stage_dim dimensions, from
 * those of the scene: the same material, charge, ambient gas and method in a
 * domain of its own. @p stage has the same declarations.
 * @param probes positions of probes in the domain of the stage [m]
 */
template <int dim, int stage_dim>
void derive_first_stage(const ParameterHandler &scene,
                        const FirstStageParameters &parameters,
                        const FirstStageLayout<dim> &plan,
                        const std::vector<dealii::Point<stage_dim>> &probes,
                        ParameterHandler &stage);

/// Sets the entries of the second stage: the scene without charges.
void derive_second_stage(const ParameterHandler &scene,
                         ParameterHandler &stage);
} // namespace contrecoup::coupling
