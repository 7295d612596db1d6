// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/hex_space.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/// A fixed rigid plane.
struct ContactPlane
{
  std::string name;
  dealii::Point<3> point;
  dealii::Tensor<1, 3> normal; ///< towards the matter
  double friction = 0.;        ///< Coulomb friction coefficient [-]
};

/// Contact forces and works of one step, of this rank.
struct ContactMeasures
{
  double force = 0.;         ///< along the normals, mean over the step [N]
  double area = 0.;          ///< of the free surface in contact [m^2]
  double work = 0.;          ///< by normal forces [J]
  double friction_work = 0.; ///< [J]
  double sliding_work = 0.;  ///< frictional work for a coefficient of 1 [J]
};

/**
 * Contact of free surfaces with rigid planes: subsections "Plane *". A node
 * that touches a plane at the start of a step gets no further velocity into
 * the plane, but may leave it; Coulomb friction acts while the plane holds the
 * node. The impact of a node is plastic: the kinetic energy lost by its mass
 * counts as work of the plane, and converges to zero with the cell size.
 */
class ContactPlanes
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a zero normal
  void parse_parameters(dealii::ParameterHandler &prm);

  void set_planes(const std::vector<ContactPlane> &planes)
  {
    planes_ = planes;
  }

  const std::vector<ContactPlane> &planes() const
  {
    return planes_;
  }

  bool empty() const
  {
    return planes_.empty();
  }

  /**
   * Finds the nodes of free surfaces. Collective.
   * @param position of the nodes, node_width numbers each [m]
   * @param is_free whether a boundary id is a free surface
   */
  void reinit(const HexSpace &space,
              const dealii::AlignedVector<double> &position,
              const std::function<bool(dealii::types::boundary_id)> &is_free);

  /// Corrects the velocities of nodes that touch a plane at @p position, and
  /// stores the corrections.
  void apply(dealii::AlignedVector<double> &velocity,
             const dealii::AlignedVector<double> &position);

  /**
   * Forces and works of the last apply() in a step.
   * @param mean of the velocities before and after the step [m/s]
   * @param velocity after the step, with inverse masses
   */
  ContactMeasures measures(const dealii::AlignedVector<double> &mean,
                           const dealii::AlignedVector<double> &velocity,
                           const double step) const;

private:
  /// A node of a free surface.
  struct SurfaceNode
  {
    std::uint32_t node;
    double area; ///< [m^2]
  };

  /// A velocity correction.
  struct VelocityCorrection
  {
    SurfaceNode at;
    double normal;                   ///< [m/s]
    dealii::Tensor<1, 3> direction;  ///< normal of the plane
    dealii::Tensor<1, 3> tangential; ///< [m/s]
  };

  const HexSpace *space_ = nullptr;
  std::vector<ContactPlane> planes_;
  std::vector<SurfaceNode> surface_;
  std::vector<VelocityCorrection> corrections_;
};
} // namespace contrecoup::ale
