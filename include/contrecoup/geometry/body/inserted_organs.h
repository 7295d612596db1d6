// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>

namespace contrecoup
{
/**
 * Returns @p recipient with the organs of @p donor. The donor is scaled to the
 * height of the recipient's surface and shifted so that the bottom centres of
 * both bounding boxes coincide. Every part of the donor except skin and soft
 * tissue then replaces the recipient's tissue, where it is inside the
 * recipient. Landmarks of the donor are projected onto the surface of the
 * recipient. Remarks state the scale and the volume of organs outside.
 * @param recipient a body of one part with the same posture as the donor
 * @throws InputError when more than the fraction @p largest_loss of the
 * organs' volume is outside
 */
BodyPointer insert_organs(const Body &recipient,
                          const ShapeBody &donor,
                          double largest_loss);
} // namespace contrecoup
