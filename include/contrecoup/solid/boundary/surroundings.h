// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/solid/body/node_fields.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace contrecoup::solid
{
/**
 * Gravity, and rigid ground without friction on which the body may stand or
 * bounce: subsections "Gravity" and "Ground". A node below the ground is pushed
 * back by a spring in proportion to its mass.
 */
class Surroundings
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Whether there is ground.
  bool has_ground() const
  {
    return has_ground_;
  }

  /**
   * Gives the springs their stiffness by mass, a part of 4 / @p step^2.
   * @param step that is stable [s]
   * @param used what the body itself has of that at most, (omega step)^2 / 4
   * @throws InputError when there is not so much left
   */
  void set_step(const double step, const double used);

  /// Adds its forces to those of all other kinds, which each rank has in full.
  template <typename Real>
  void add_forces(NodeFields<Real> &nodes) const;

  /// Power of gravity [W], of the nodes that count on this rank.
  template <typename Real>
  double power(const NodeFields<Real> &nodes,
               const std::vector<unsigned char> &counted) const;

  /// What the springs of the ground hold [J], of nodes that count.
  template <typename Real>
  double contact_energy(const NodeFields<Real> &nodes,
                        const std::vector<unsigned char> &counted) const;

  /// Force of the ground on the body, upwards [N], of nodes that count.
  template <typename Real>
  double contact_force(const NodeFields<Real> &nodes,
                       const std::vector<unsigned char> &counted) const;

private:
  template <typename Real>
  double depth(const NodeFields<Real> &nodes, std::size_t node) const;

  dealii::Tensor<1, 3> gravity_; ///< [m/s^2]
  bool has_gravity_ = false;
  bool has_ground_ = false;
  double height_ = 0.;    ///< of the ground [m]
  double part_ = 0.;      ///< of 4 / step^2
  double stiffness_ = 0.; ///< by mass [1/s^2]
};
} // namespace contrecoup::solid
