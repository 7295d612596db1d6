// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameter_file.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/gauge_raster.h>
#include <contrecoup/materials/explosives.h>
#include <contrecoup/materials/own_tissues.h>
#include <contrecoup/numerics/injury/own_thresholds.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup::coupling
{
/// An entry of the user that changes a value of a library, or an entry of a
/// stage.
struct ChangedEntry
{
  std::string entry;  ///< path in the scene
  std::string value;  ///< with its unit
  std::string before; ///< value otherwise, with its unit
  bool is_of_stage =
    false; ///< the scene chooses the value, or the default holds
};


/// Parameters of a scene, read from its parameter file.
struct SceneParameters
{
  /// Preset of mesh sizes of gas and body: the largest sizes. Scenes whose
  /// positive phase is short get finer cells, see SceneLayout.
  struct Accuracy
  {
    std::string name;
    unsigned int levels;       ///< refinement level at the skin
    unsigned int front_levels; ///< refinement level of fronts near the body
    double cells_per_phase;    ///< least for the positive phase at the body
    double element_size;       ///< largest edge of the body's elements [m]
    std::string cost; ///< cost for the reference scene of a man, as text
  };
  /// All presets, finest last.
  static const std::vector<Accuracy> accuracies;

  /// Declares subsections "Scene", "Charge", "Body", "Tissues", "Injury", and
  /// subsections "Anatomy", "Blast" and "Biomechanics" with all entries of
  /// these applications.
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// The same without those of applications.
  static void declare_own(dealii::ParameterHandler &prm);

  /// Whether a section is one with the entries of an application.
  static bool is_stage(const std::string &section);

  /// Whether an entry is one of an application.
  static bool is_of_stage(const Assignment &assignment);

  /// Reads "Scene", "Charge", "Tissues" and "Injury"; call this before names of
  /// tissues are read elsewhere: new ones become known.
  /// @throws InputError for a charge without a position and for an explosive
  /// that is not known or cannot be computed with; for tissues likewise
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Sets the edge of the elements unless an entry gives it: that of the
  /// preset, but at most a sixtieth of the body's longest side, so that a head
  /// alone has several elements through scalp and skull.
  /// @param body bounding box of the body before it is turned [m]
  void fit_elements(const dealii::BoundingBox<3> &body);

  /// Energy of the charge, of detonation and afterburn [J].
  double energy() const;

  /// The charge, for model_bias().
  BiasedBurst burst(const bool is_on_ground) const
  {
    return {explosive.name,
            mass,
            !custom_entries.empty(),
            has_usual_afterburn,
            is_on_ground};
  }

  bool wants_injury() const
  {
    return question == "injury";
  }

  std::string title;
  std::string question; ///< loads, injury
  Accuracy accuracy;
  /// Largest edge of cells at the skin [m]; 0: by accuracy
  double cell_size = 0.;
  /// Edge of the body's elements [m]; see fit_elements()
  double element_size = 0.;
  double end_time = 0.;     ///< [s]
  std::string symmetry;     ///< auto, none, y
  bool has_forecast = true; ///< whether to predict the costs of tasks
  bool draws_report = true; ///< report.html
  /// Whether a coarser run estimates the numerical error
  bool estimates_error = true;
  Explosive explosive; ///< of the library or of the user
  /// Entries of a custom explosive as the user gave them, without empty ones,
  /// "Like" first, and alone where nothing differs from that explosive; empty
  /// for explosives of the library.
  std::vector<std::pair<std::string, std::string>> custom_entries;
  double mass = 0.;      ///< [kg]
  double afterburn = 0.; ///< energy [J/kg]
  /// Whether the energy of afterburn is that of the library of explosives
  bool has_usual_afterburn = false;
  double distance = 0.; ///< from the charge's centre to the body [m]
  double height = 0.;   ///< of the charge's centre above the ground [m]
  /// Position of the charge's centre instead [m]
  std::optional<dealii::Point<3>> place;
  std::vector<GaugeRaster> gauges; ///< of Blast/Probes
  std::string tissues;             ///< set in the tissue library
  OwnTissues own_tissues;          ///< new ones and changes of those of the set
  OwnThresholds own_thresholds;    ///< of injuries
  /// Values of explosive, tissues and thresholds that are not those of the
  /// libraries.
  std::vector<ChangedEntry> changes;

private:
  void parse_scene(dealii::ParameterHandler &prm);
  void parse_charge(dealii::ParameterHandler &prm);
  void parse_tissues(dealii::ParameterHandler &prm);
  void parse_thresholds(dealii::ParameterHandler &prm);
  /// Reads entry and subsection of the explosive.
  void parse_explosive(dealii::ParameterHandler &prm);
};
} // namespace contrecoup::coupling
