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
 * Gravity, and rigid frictionless ground: subsections "Gravity" and "Ground".
 * The contact is a penalty method: a spring with stiffness proportional to the
 * node's mass pushes each node below the ground back.
 */
class Surroundings
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  bool has_gravity() const
  {
    return has_gravity_;
  }

  /// Whether the scene has ground.
  bool has_ground() const
  {
    return has_ground_;
  }

  /**
   * Sets the penalty stiffness per mass, a given fraction of 4 / @p step^2.
   * @param step the stable step [s]
   * @param used largest (omega step)^2 / 4 of the body itself
   * @throws InputError when body and springs exceed the stability limit
   */
  void set_step(const double step, const double used);

  /// @throws InputError if nodes are in the ground, on all ranks. Collective.
  template <typename Real>
  void refuse_buried(const NodeFields<Real> &nodes,
                     MPI_Comm communicator) const;

  /// Adds gravity and contact forces. Call after the exchange over ranks,
  /// since each rank adds them in full to its copies of shared nodes.
  template <typename Real>
  void add_forces(NodeFields<Real> &nodes) const;

  /// Power of gravity [W], summed over nodes with @p counted set.
  template <typename Real>
  double power(const NodeFields<Real> &nodes,
               const std::vector<unsigned char> &counted) const;

  /// Energy stored in the contact springs [J], summed over counted nodes.
  template <typename Real>
  double contact_energy(const NodeFields<Real> &nodes,
                        const std::vector<unsigned char> &counted) const;

  /// Upward contact force on the body [N], summed over counted nodes.
  template <typename Real>
  double contact_force(const NodeFields<Real> &nodes,
                       const std::vector<unsigned char> &counted) const;

private:
  template <typename Real>
  double depth(const NodeFields<Real> &nodes, std::size_t node) const;

  dealii::Tensor<1, 3> gravity_; ///< [m/s^2]
  bool has_gravity_ = false;
  bool has_ground_ = false;
  double height_ = 0.;             ///< z of the ground [m]
  double stiffness_fraction_ = 0.; ///< fraction of 4 / step^2
  double stiffness_ = 0.;          ///< per mass [1/s^2]
};
} // namespace contrecoup::solid
