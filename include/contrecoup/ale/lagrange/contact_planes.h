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
/// A rigid plane at rest.
struct ContactPlane
{
  std::string name;
  dealii::Point<3> point;
  dealii::Tensor<1, 3> normal; ///< into the side where matter may be
  double friction = 0.;        ///< Coulomb's coefficient [-]
};

/// What planes did in a step, this rank's part.
struct ContactMeasures
{
  double force = 0.;         ///< along the normals, mean of the step [N]
  double area = 0.;          ///< of the free surface in contact [m^2]
  double work = 0.;          ///< along the normals [J]
  double friction_work = 0.; ///< [J]
  double sliding_work = 0.;  ///< that a coefficient of 1 would take [J]
};

/**
 * Rigid planes that the nodes of free surfaces do not cross: subsections
 * "Plane *". A node that has reached a plane at the start of a step does not
 * move into it any further, and is free to leave; while the plane holds it,
 * friction slows it along the plane. It stops at once, as in a plastic impact:
 * the kinetic energy that its mass loses is work of the plane, and goes to zero
 * with the cell size.
 */
class ContactPlanes
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a normal of length zero
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
   * @param position of the nodes at the start, AleState::width numbers each [m]
   * @param is_free whether a boundary id is that of a free surface
   * @throws InputError for a plane that cuts the mesh at the start. Collective.
   */
  void reinit(const HexSpace &space,
              const dealii::AlignedVector<double> &position,
              const std::function<bool(dealii::types::boundary_id)> &is_free);

  /// Changes velocities of nodes that are at a plane at @p position, and keeps
  /// by how much.
  void apply(dealii::AlignedVector<double> &velocity,
             const dealii::AlignedVector<double> &position);

  /**
   * What the last apply() means for a step.
   * @param mean of the velocities before and after the step [m/s]
   * @param velocity after it, with the inverse masses
   */
  ContactMeasures measures(const dealii::AlignedVector<double> &mean,
                           const dealii::AlignedVector<double> &velocity,
                           const double step) const;

private:
  void require_outside(const ContactPlane &plane,
                       const dealii::AlignedVector<double> &position) const;

  /// A node of a free surface.
  struct SurfaceNode
  {
    std::uint32_t node;
    double area; ///< [m^2]
  };

  /// A change of velocity.
  struct Push
  {
    SurfaceNode at;
    double normal;                   ///< [m/s]
    dealii::Tensor<1, 3> direction;  ///< of the plane's normal
    dealii::Tensor<1, 3> tangential; ///< [m/s]
  };

  const HexSpace *space_ = nullptr;
  std::vector<ContactPlane> planes_;
  std::vector<SurfaceNode> surface_;
  std::vector<Push> pushes_;
};
} // namespace contrecoup::ale
