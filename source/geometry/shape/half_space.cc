// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/geometry/shape/half_space.h>

namespace contrecoup
{
using dealii::Point;
using dealii::Tensor;

double HalfSpace::value(const Point<3> &point) const
{
  return -point[0];
}


Tensor<1, 3> HalfSpace::gradient(const Point<3> &) const
{
  Tensor<1, 3> outward;
  outward[0] = -1.;
  return outward;
}


dealii::BoundingBox<3> HalfSpace::bounding_box() const
{
  const double far = 1e12;
  return dealii::BoundingBox<3>(
    {Point<3>(0., -far, -far), Point<3>(far, far, far)});
}
} // namespace contrecoup
