// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/materials/jwl_parameters.h>

#include <string>
#include <vector>

namespace contrecoup
{
/// Mass of TNT per mass of an explosive that has the same blast in air.
struct TntEquivalence
{
  double pressure;   ///< for the incident peak and the arrival [-]
  double impulse;    ///< for impulse and duration [-]
  bool is_published; ///< from measurements; else a ratio of energies
  std::string source;
};

/// Energy that detonation products release by combustion in air.
struct Afterburn
{
  double energy;  ///< default for the part that burns in time [J/kg]
  double largest; ///< complete combustion [J/kg]
  std::string source;
};

/// An entry of the library of explosives.
struct Explosive
{
  std::string name;  ///< in parameter files
  std::string title; ///< in texts for readers, as "composition B"
  JwlParameters jwl;
  double detonation_speed; ///< published D [m/s]
  double cj_pressure;      ///< published Chapman-Jouguet pressure [Pa]
  std::string source;
  TntEquivalence tnt = {1., 1., false, ""};
  Afterburn afterburn = {0., 0., ""};
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
 *
 * TNT equivalences of C-4 are the averages of TM 5-855-1 (1986); those of
 * explosives without a measured one are ratios of detonation energies to that
 * of "tnt dobratz", 4.29 MJ/kg, whose constants are of the same handbook as
 * theirs. The 3.68 MJ/kg of "tnt" are of another calibration, and would give
 * composition B 1.35 and PETN 1.55.
 *
 * The largest energy of afterburn is the heat of combustion to carbon dioxide
 * and water vapour, from standard enthalpies of formation (-393.5 and -241.8
 * kJ/mol; TNT -63, RDX +70, PETN -538 kJ/mol; binder of C-4, 9 %, 39 MJ/kg),
 * minus the energy of detonation. The default for TNT fits incident peak and
 * impulse of Kingery and Bulmash at 1 and 2 m from 0.85 kg; C-4 agrees with
 * them with the same energy. Other explosives get the part of the largest
 * energy that TNT gets, 0.32, which no measurement confirms.
 */
const std::vector<Explosive> &explosive_library();

/// Names of the explosives.
std::vector<std::string> explosive_names();

/// Such as "1.37 times its mass of TNT for pressures, 1.19 for impulses", or
/// one factor where both are equal.
std::string in_words(const TntEquivalence &tnt);

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
