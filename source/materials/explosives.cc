// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/mie_grueneisen.h>
#include <contrecoup/materials/units.h>

#include <boost/math/tools/roots.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup
{
namespace
{
  /// A row of the library, in units of the literature.
  struct Row
  {
    std::string name, title;
    double density;             ///< [kg/m^3]
    double A, B, R1, R2, omega; ///< [GPa], [-]
    double energy;              ///< per volume [GPa]
    double detonation_speed;    ///< [m/s]
    double cj_pressure;         ///< [GPa]
    double combustion;          ///< heat, with water vapour [MJ/kg]
    double afterburn;           ///< fitted [MJ/kg]; NaN: none known
    std::string source;
  };

  constexpr double not_fitted = std::numeric_limits<double>::quiet_NaN();

  const std::vector<Row> &rows()
  {
    const std::string unseen = "; the original was not seen";
    const std::string map = "MaterialMap EOS_JWL.toml, after Schwer (2016, "
                            "2017)";
    const std::string foam = "validation cases of blastFoam 6.2";
    const std::string common = "set of the LLNL Explosives Handbook "
                               "(Dobratz and Crawford 1985) in common use";
    // clang-format off
    static const std::vector<Row> table{
      {"tnt", "TNT", 1630., 373.8, 3.747, 4.15, 0.90, 0.35, 6.0, 6930., 21.0, 14.5, 3.5,
       "Tan, Saunders and Bagchi, COUPLED PROBLEMS 2017, table 2 (3.68 "
       "MJ/kg)"},
      {"tnt dobratz", "TNT Dobratz", 1630., 371.2, 3.231, 4.15, 0.95, 0.30, 7.0, 6930., 21.0, 14.5, 3.0,
       map + unseen},
      {"c-4", "C-4", 1601., 609.77, 12.95, 4.5, 1.4, 0.25, 9.0, 8193., 28.0, 11.6, 3.5,
       foam + "; detonation speed: " + common + unseen},
      {"composition b", "composition B", 1717., 524.23, 7.678, 4.2, 1.1, 0.34, 8.5, 7980., 29.5, 11.1, not_fitted,
       common + unseen},
      {"petn 1.77", "PETN 1.77", 1770., 617.0, 16.926, 4.4, 1.2, 0.25, 10.1, 8300., 33.5, 7.58, not_fitted,
       map},
      {"petn 1.50", "PETN 1.50", 1500., 625.3, 23.29, 5.25, 1.6, 0.28, 8.56, 7450., 22.0, 7.58, not_fitted,
       common + unseen},
      {"anfo", "ANFO", 931., 49.46, 1.891, 3.907, 1.118, 0.3333, 2.484, 4160., 5.15, 2.67, 0.,
       map + "; energy, detonation speed and pressure: in common use" + unseen},
      {"pentolite", "pentolite", 1700., 540.94, 9.373, 4.5, 1.1, 0.35, 8.1, 7530., 25.5, 11.0, not_fitted,
       common + unseen}};
    // clang-format on
    return table;
  }

  /// Detonation energy [J/kg].
  double detonation_energy(const Row &row)
  {
    return row.energy * gigapascal / row.density;
  }

  double detonation_energy(const std::string &name)
  {
    return detonation_energy(
      *std::find_if(rows().begin(), rows().end(), [&](const Row &row) {
        return row.name == name;
      }));
  }

  TntEquivalence tnt_equivalence(const Row &row)
  {
    if (row.name.compare(0, 3, "tnt") == 0)
      return {1., 1., true, "TNT"};
    if (row.name == "c-4")
      return {1.37, 1.19, true, "averages of TM 5-855-1 (1986)"};
    const double ratio =
      detonation_energy(row) / detonation_energy("tnt dobratz");
    return {ratio, ratio, false, "ratio of detonation energies"};
  }

  Afterburn afterburn_of(const Row &row)
  {
    constexpr double megajoule = 1e6;
    constexpr double usual_part = 0.32; // that of TNT
    const double largest =
      std::max(0., row.combustion * megajoule - detonation_energy(row));
    if (row.name == "anfo")
      return {0., largest, "its oxygen is balanced"};
    return std::isnan(row.afterburn)
             ? Afterburn{usual_part * largest,
                         largest,
                         "the part of the heat of combustion that fits TNT"}
             : Afterburn{row.afterburn * megajoule,
                         largest,
                         row.name == "c-4"
                           ? "that of TNT, which agrees with Kingery and "
                             "Bulmash at 1 to 2 m"
                           : "fitted to Kingery and Bulmash at 1 to 2 m"};
  }

  Explosive to_explosive(const Row &row)
  {
    constexpr double volumetric_heat = 1e6; // [J/(m^3 K)]
    JwlParameters jwl;
    jwl.A = row.A * gigapascal;
    jwl.B = row.B * gigapascal;
    jwl.R1 = row.R1;
    jwl.R2 = row.R2;
    jwl.omega = row.omega;
    jwl.reference_density = row.density;
    jwl.energy_density = row.energy * gigapascal;
    jwl.specific_heat = volumetric_heat / row.density;
    return {row.name,
            row.title,
            jwl,
            row.detonation_speed,
            row.cj_pressure * gigapascal,
            row.source,
            tnt_equivalence(row),
            afterburn_of(row)};
  }

  /// Pressure on the Hugoniot curve of the products at a relative volume.
  double hugoniot_pressure(const JwlParameters &jwl,
                           const MieGrueneisen &products,
                           const double volume)
  {
    const double initial = products.pressure(
      jwl.reference_density / volume, jwl.energy_density / volume, 1.);
    return initial / (1. - 0.5 * jwl.omega * (1. - volume) / volume);
  }
} // namespace

const std::vector<Explosive> &explosive_library()
{
  static const std::vector<Explosive> library = []() {
    std::vector<Explosive> explosives;
    for (const Row &row : rows())
      explosives.push_back(to_explosive(row));
    return explosives;
  }();
  return library;
}

std::vector<std::string> explosive_names()
{
  std::vector<std::string> names;
  for (const Explosive &explosive : explosive_library())
    names.push_back(explosive.name);
  return names;
}

std::string in_words(const TntEquivalence &tnt)
{
  const std::string of_pressure =
    brief(tnt.pressure, 3) + " times its mass of TNT";
  return tnt.pressure == tnt.impulse
           ? of_pressure
           : of_pressure + " for pressures, " + brief(tnt.impulse, 3) +
               " for impulses";
}

const Explosive &find_explosive(const std::string &name)
{
  for (const Explosive &explosive : explosive_library())
    if (explosive.name == name)
      return explosive;
  throw InputError("There is no explosive named '" + name + "'" +
                   suggestion(name, explosive_names()));
}

ChapmanJouguetState chapman_jouguet(const JwlParameters &jwl)
{
  const MieGrueneisen products = MieGrueneisen::jwl(jwl);
  const double rho_0 = jwl.reference_density;

  // (rho c)^2 minus the slope of the Rayleigh line, p rho_0 / (1 - V).
  const auto excess = [&](const double volume) {
    const double density = rho_0 / volume;
    const double pressure = hugoniot_pressure(jwl, products, volume);
    return products.sound_speed_squared(density, pressure, 1.) * density *
             density / rho_0 -
           pressure / (1. - volume);
  };

  const double smallest = std::max(0.3, 1.01 * jwl.omega / (2. + jwl.omega));
  const double largest = 0.999;
  if (!(excess(smallest) > 0.) || !(excess(largest) < 0.))
    throw InputError("These JWL constants have no Chapman-Jouguet state with "
                     "a density between 1 and 3 times the reference density");
  std::uintmax_t iterations = 200;
  const auto bracket = boost::math::tools::toms748_solve(
    excess,
    smallest,
    largest,
    boost::math::tools::eps_tolerance<double>(50),
    iterations);
  const double volume = 0.5 * (bracket.first + bracket.second);

  ChapmanJouguetState state;
  state.pressure = hugoniot_pressure(jwl, products, volume);
  state.density = rho_0 / volume;
  state.detonation_speed = std::sqrt(state.pressure / (rho_0 * (1. - volume)));
  state.velocity = state.detonation_speed * (1. - volume);
  return state;
}

std::string describe_detonation(const Explosive &explosive)
{
  const double allowed = 1e-3;
  const ChapmanJouguetState state = chapman_jouguet(explosive.jwl);
  std::string line = "Explosive " + explosive.title +
                     ": its constants give a detonation speed of " +
                     brief(state.detonation_speed, 5) +
                     " m/s and a Chapman-Jouguet pressure of " +
                     brief(state.pressure / gigapascal, 5) + " GPa";
  const auto compare = [&](const double computed,
                           const double published,
                           const double unit,
                           const std::string &name) {
    if (!(published > 0.))
      return;
    const double change = computed / published - 1.;
    line += ", published " + brief(published / unit, 5) + " " + name;
    if (std::abs(change) > allowed)
      line += " (warning: the constants are off by " + brief(100. * change, 3) +
              " %)";
  };
  compare(state.detonation_speed, explosive.detonation_speed, 1., "m/s");
  compare(state.pressure, explosive.cj_pressure, gigapascal, "GPa");
  return line;
}
} // namespace contrecoup
