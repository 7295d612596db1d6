// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/jwl_parameters.h>

#include <string>

namespace contrecoup
{
/**
 * Checks the constants of a JWL equation of state with B < 0, as in fits to
 * unreacted explosives and some products. The sound speed must be real in the
 * states that such a material reaches, for relative volumes V of at least 0.4:
 * - if the explosive releases energy: on the isentrope from the
 *   Chapman-Jouguet state until the exponentials have vanished;
 * - if it releases none: on the isentrope through V = 1 and 298 K up to V = 1,
 *   since unreacted explosive is compressed.
 *
 * Below these isentropes the sound speed may still be imaginary elsewhere; a
 * run that reaches such a state fails.
 *
 * @param where prefix of the message
 * @throws InputError that names the first relative volume with an imaginary
 * sound speed, or when there is no Chapman-Jouguet state; never if B >= 0
 */
void require_real_sound_speed(const JwlParameters &jwl,
                              const std::string &where);
} // namespace contrecoup
