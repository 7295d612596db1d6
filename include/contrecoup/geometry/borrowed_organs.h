// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/geometry/body.h>

namespace contrecoup
{
/**
 * A body with the organs of another one: @p giver is scaled to the height of
 * the surface of @p taker and moved so that the middles of their bottoms meet;
 * then every part of it that is neither skin nor soft tissue takes its place
 * in @p taker, as far as it is inside. The giver's landmarks move to the
 * nearest places of the surface. Remarks tell the scale, and how much of the
 * organs was outside.
 * @param taker a body of one part that stands as the giver does
 * @throws InputError when more than @p largest_loss of the organs' volume is
 *   outside
 */
BodyPointer
borrow_organs(const Body &taker, const ShapeBody &giver, double largest_loss);
} // namespace contrecoup
