// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>
#include <contrecoup/geometry/coarse_mesh.h>

#include <limits>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/**
 * How a blast begins in fewer dimensions, as subsection "First stage" says:
 * spherical around the centre of the charge, or axisymmetric around the
 * vertical through it, until the front comes near what is not so; or first the
 * one, then the other.
 */
class StageParameters
{
public:
  /// Declares subsection "First stage".
  static void declare_parameters(ParameterHandler &prm);

  /// Reads it. @throws InputError for words and numbers that do not go
  /// together.
  void parse_parameters(ParameterHandler &prm);

  std::string kind = "none"; ///< none, spherical, axisymmetric
  double cell_size = 0.001;  ///< of the smallest subcells [m]
  unsigned int levels = 3;   ///< halvings by adaptation, if axisymmetric
  /// Of the spherical stage that an axisymmetric one begins with; 0: none [m].
  double spherical_cell_size = 0.;
  std::string criterion = "auto"; ///< auto, time, radius
  double time = 0.;               ///< to hand over at [s]
  double radius = 0.;             ///< of the front to hand over at [m]
};


/// Where the charge is in a scene, and how far the blast stays what the
/// first stage takes it for.
template <int dim>
struct StagePlan
{
  /// The centre of spheres or, for an axisymmetric stage, the foot of the
  /// axis [m].
  dealii::Point<dim> centre;
  /// Distance from the centre or the axis to the next side of the domain
  /// that is no plane through it [m].
  double nearest = std::numeric_limits<double>::max();
  /// From the charge along the axis of an axisymmetric stage to the next side
  /// of the domain that is no plane through it [m].
  double along_axis = 0.;
  /// To the corner that is farthest away [m].
  double farthest = 0.;
  /// The part of the whole body within the domain: 1, or a half for each
  /// side of the domain through the centre.
  double part = 1.;
  /// For each direction the side on which the domain goes on beyond such a
  /// plane, -1 or 1; 0: both.
  std::array<int, dim> side{};
  /// Radius of the domain of the first stage [m].
  double domain_radius = 0.;
};


/**
 * Finds the charge in the scene, which must be spheres around one centre
 * (for an axisymmetric stage also upright cylinders, and lit on the axis),
 * and measures the domain around it.
 * @throws InputError for scenes that a first stage cannot begin
 */
template <int dim>
StagePlan<dim> make_plan(ParameterHandler &scene,
                         const StageParameters &parameters);

/**
 * Sets the entries of the first stage, which has @p stage_dim dimensions,
 * from those of the scene: the same material, charge, ambient gas and method
 * in a domain of its own. @p stage has the same declarations.
 * @param probes places of gauges in the domain of the stage
 */
template <int dim, int stage_dim>
void derive_first_stage(const ParameterHandler &scene,
                        const StageParameters &parameters,
                        const StagePlan<dim> &plan,
                        const std::vector<dealii::Point<stage_dim>> &probes,
                        ParameterHandler &stage);

/// Sets the entries of the second stage: the scene without its charges.
void derive_second_stage(const ParameterHandler &scene,
                         ParameterHandler &stage);
} // namespace contrecoup::coupling
