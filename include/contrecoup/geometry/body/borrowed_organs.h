// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body/body.h>

namespace contrecoup
{
/**
 * Returns @p taker with the organs of @p giver. The giver is scaled to the
 * height of the taker's surface and shifted so that the bottom centres of both
 * bounding boxes coincide. Every part of the giver except skin and soft tissue
 * then replaces the taker's tissue, where it is inside the taker. Landmarks of
 * the giver are projected onto the surface of the taker. Remarks state the
 * scale and the volume of organs outside.
 * @param taker a body of one part with the same posture as the giver
 * @throws InputError when more than the fraction @p largest_loss of the
 * organs' volume is outside
 */
BodyPointer
borrow_organs(const Body &taker, const ShapeBody &giver, double largest_loss);
} // namespace contrecoup
