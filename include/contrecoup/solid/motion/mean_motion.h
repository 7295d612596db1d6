// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <array>
#include <vector>

namespace contrecoup::solid
{
/// The rigid motion that has the momentum and the moment of momentum of matter:
/// velocity of its centre, and the rate at which it turns.
class MeanMotion
{
public:
  using Vector = dealii::Tensor<1, 3>;

  /// Adds a mass in a point.
  /// @param mass in any unit
  void add(const double mass, const Vector &place, const Vector &velocity);

  /**
   * Adds up all ranks. Collective.
   * @param is_mirrored by axis, whether what was added is the half of a body
   *   that is the same on the other side of a plane normal to it: the motion is
   *   that of the whole
   * @return whether there is any mass
   */
  bool find(const MPI_Comm communicator,
            const std::array<bool, 3> &is_mirrored = {{false, false, false}});

  const Vector &velocity() const ///< [m/s]
  {
    return velocity_;
  }
  /// 0 for matter on a line [rad/s].
  const Vector &turning() const
  {
    return turning_;
  }

private:
  /// Mass, first moments, momentum, moment of momentum, squares of places, and
  /// products x y, y z, z x.
  std::vector<double> sums_ = std::vector<double>(16, 0.);
  Vector velocity_, turning_;
};
} // namespace contrecoup::solid
