// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/jwl_parameters.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// An entry of the library of explosives.
struct Explosive
{
  std::string name;
  JwlParameters jwl;
  double detonation_speed; ///< published D [m/s]
  double cj_pressure;      ///< published Chapman-Jouguet pressure [Pa]
  std::string source;
};

/// The Chapman-Jouguet state behind a plane, steady detonation.
struct ChapmanJouguetState
{
  double detonation_speed; ///< D [m/s]
  double pressure;         ///< [Pa]
  double density;          ///< [kg/m^3]
  double velocity;         ///< of the products, along D [m/s]
};

/**
 * All explosives that ship with Contrecoup. Constants are included only if
 * they reproduce their published D and Chapman-Jouguet pressure (a unit test
 * checks each set); none is known for pure RDX.
 *
 * The specific heat of the products, which weights the mixture with air and
 * gives the temperature, is rho_0 c_v = 1 MPa/K for all of them: the usual
 * 1e-5 Mbar/K of ignition-and-growth models (Tarver and coworkers).
 */
const std::vector<Explosive> &explosive_library();

/// Names of the explosives.
std::vector<std::string> explosive_names();

/// @throws InputError for an unknown explosive
const Explosive &find_explosive(const std::string &name);

/**
 * Chapman-Jouguet state: the point where the Rayleigh line touches the
 * Hugoniot curve e = E_0 / rho_0 + p (1 / rho_0 - 1 / rho) / 2 of the
 * products. There rho c equals rho_0 D (Fickett and Davis 1979, chapter 2).
 * @throws InputError when the constants admit no such state
 */
ChapmanJouguetState chapman_jouguet(const JwlParameters &jwl);

/**
 * One line for the log: Chapman-Jouguet speed and pressure of the constants,
 * the published values if positive, and a warning where both differ by more
 * than a thousandth.
 */
std::string describe_detonation(const Explosive &explosive);
} // namespace contrecoup
