// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace contrecoup::solid
{
/// The rigid motion with the same momentum and angular momentum as a set of
/// point masses: velocity of the centre of mass, and angular velocity.
class MeanMotion
{
public:
  using Vector = dealii::Tensor<1, 3>;

  /// Adds a point mass.
  /// @param mass in any unit
  void add(const double mass, const Vector &position, const Vector &velocity);

  /**
   * Sums over all ranks and solves for the motion. Collective.
   * @param is_mirrored by axis: whether the masses are one half of a body that
   * is symmetric about a plane normal to the axis; the motion is then that of
   * the whole body
   * @return whether the total mass is positive
   */
  bool find(const MPI_Comm communicator,
            const std::array<bool, 3> &is_mirrored = {{false, false, false}});

  const Vector &velocity() const ///< of the centre of mass [m/s]
  {
    return velocity_;
  }
  /// Centre of mass, of the half if it is mirrored [m].
  const Vector &centre() const
  {
    return centre_;
  }
  /// Velocity of the rigid motion at @p point [m/s].
  Vector velocity_at(const Vector &point) const
  {
    return velocity_ + cross_product_3d(angular_velocity_, point - centre_);
  }
  /// Angular velocity [rad/s]; 0 for masses on a line.
  const Vector &angular_velocity() const
  {
    return angular_velocity_;
  }

private:
  /// Mass, first moments, momentum, angular momentum, squares of coordinates,
  /// and products x y, y z, z x.
  std::vector<double> sums_ = std::vector<double>(16, 0.);
  Vector velocity_, angular_velocity_, centre_;
};
} // namespace contrecoup::solid
