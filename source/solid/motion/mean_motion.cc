// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/solid/motion/mean_motion.h>

#include <deal.II/base/symmetric_tensor.h>

#include <cmath>

namespace contrecoup::solid
{
void MeanMotion::add(const double mass,
                     const Vector &position,
                     const Vector &velocity)
{
  const Vector angular_momentum = cross_product_3d(position, velocity);
  sums_[0] += mass;
  for (unsigned int d = 0; d < 3; ++d)
  {
    sums_[1 + d] += mass * position[d];
    sums_[4 + d] += mass * velocity[d];
    sums_[7 + d] += mass * angular_momentum[d];
    sums_[10 + d] += mass * position[d] * position[d];
    sums_[13 + d] += mass * position[d] * position[(d + 1) % 3];
  }
}


bool MeanMotion::find(const MPI_Comm communicator,
                      const std::array<bool, 3> &is_mirrored)
{
  dealii::Utilities::MPI::sum(sums_, communicator, sums_);
  if (!(sums_[0] > 0.))
    return false;
  for (unsigned int i = 1; i < sums_.size(); ++i)
    sums_[i] /= sums_[0];
  const Vector centre({sums_[1], sums_[2], sums_[3]});
  centre_ = centre;
  velocity_ = Vector({sums_[4], sums_[5], sums_[6]});
  Vector angular_momentum = Vector({sums_[7], sums_[8], sums_[9]}) -
                            cross_product_3d(centre, velocity_);
  dealii::SymmetricTensor<2, 3> inertia;
  double square = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const unsigned int e = (d + 1) % 3;
    const double own = sums_[10 + d] - centre[d] * centre[d];
    square += own;
    inertia[d][d] = -own;
    inertia[d][e] = -(sums_[13 + d] - centre[d] * centre[e]);
  }
  for (unsigned int d = 0; d < 3; ++d)
    inertia[d][d] += square;
  for (unsigned int d = 0; d < 3; ++d)
    if (is_mirrored[d])
    {
      // A body and its mirror image turn about the plane's normal only.
      velocity_[d] = 0.;
      for (unsigned int e = 0; e < 3; ++e)
        if (e != d)
          angular_momentum[e] = inertia[d][e] = 0.;
    }
  constexpr double least_part = 1e-12;
  angular_velocity_ =
    determinant(inertia) > least_part * std::pow(trace(inertia), 3)
      ? Vector(invert(inertia) * angular_momentum)
      : Vector();
  return true;
}
} // namespace contrecoup::solid
