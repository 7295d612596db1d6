// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/shape/shape.h>

namespace contrecoup
{
/// The half space x > 0. Exact distance.
class HalfSpace : public Shape
{
public:
  double value(const dealii::Point<3> &point) const override;
  dealii::Tensor<1, 3> gradient(const dealii::Point<3> &point) const override;
  /// A box larger than any scene.
  dealii::BoundingBox<3> bounding_box() const override;
};
} // namespace contrecoup
