// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <vector>

namespace contrecoup::coupling
{
/// What a scene asks for, as its parameter file says.
struct SceneParameters
{
  /// Sizes that go together, finest last.
  struct Accuracy
  {
    std::string name;
    unsigned int levels;       ///< halvings of coarse leaves at the skin
    unsigned int front_levels; ///< the same where fronts are near the body
    double element_size;       ///< of the body [m]
    std::string cost;          ///< of the man of the paper, in a few words
  };
  /// All that can be chosen.
  static const std::vector<Accuracy> accuracies;

  /// Declares subsections "Scene", "Charge", "Body" and "Tissues", and
  /// "Anatomy", "Blast" and "Biomechanics" with every entry of these
  /// applications.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads "Scene", "Charge" and "Tissues".
  /// @throws InputError for a charge at no place.
  void parse_parameters(dealii::ParameterHandler &prm);

  bool wants_injury() const
  {
    return question == "injury";
  }

  std::string title;
  std::string question; ///< loads, injury
  Accuracy accuracy;
  double end_time = 0.;                  ///< [s]
  std::string symmetry;                  ///< auto, none, y
  bool has_forecast = true;              ///< of what stages cost
  bool draws_report = true;              ///< report.html
  std::string explosive;                 ///< of the library
  double mass = 0.;                      ///< [kg]
  double afterburn = 0.;                 ///< energy [J/kg]
  double distance = 0.;                  ///< from its centre to the body [m]
  double height = 0.;                    ///< of its centre above the ground [m]
  std::optional<dealii::Point<3>> place; ///< of its centre instead [m]
  std::string tissues;                   ///< set of the tissue library
};
} // namespace contrecoup::coupling
