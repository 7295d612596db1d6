// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/jwl_parameters.h>

#include <string>

namespace contrecoup
{
/**
 * Checks the constants of a JWL equation of state with B below 0, as fits to
 * unreacted explosives and to some products have it: the sound speed must be
 * real where such a material comes to. These are the relative volumes V from
 * 0.4
 *  - on the isentrope from the Chapman-Jouguet state until its exponentials
 *    have vanished, if the explosive releases energy;
 *  - on the isentrope through V = 1 and 298 K up to V = 1, if it releases none:
 *    the unreacted explosive is compressed.
 * Elsewhere below these isentropes the sound speed may still be imaginary: a
 * run that comes there fails.
 *
 * @param where stands in front of the message
 * @throws InputError that names the first relative volume where it is not, or
 *   when there is no Chapman-Jouguet state. None with B of 0 or above.
 */
void require_real_sound_speed(const JwlParameters &jwl,
                              const std::string &where);
} // namespace contrecoup
