// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/remark_line.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/coupling/application/anatomy_parameters.h>
#include <contrecoup/coupling/scene/afterburn_items.h>
#include <contrecoup/coupling/scene/first_answer.h>
#include <contrecoup/coupling/scene/planned_scene.h>
#include <contrecoup/geometry/body/body_layer.h>
#include <contrecoup/geometry/mesh/hex_quality.h>
#include <contrecoup/io/run/plan_table.h>
#include <contrecoup/numerics/injury/body_mass.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::coupling
{
namespace
{
  /// Distance between charge and skin in words.
  std::string distance_in_words(const SceneParameters &scene,
                                const SceneLayout &layout)
  {
    return brief(layout.distance) + " m from the nearest skin" +
           distance_along_x(scene, layout);
  }

  /// Whether the trunk is not where the nearest skin is, as in the report.
  bool is_apart(const SceneLayout &trunk, const SceneLayout &skin)
  {
    constexpr double farther = 1.05;
    return trunk.distance > farther * skin.distance;
  }

  /// Mean edge of a body's own hexahedra [m].
  double edge_of(const HexMesh &mesh)
  {
    HexQuality all;
    for (const HexQuality &quality : measure_quality(mesh))
      all = all + quality;
    return std::cbrt(all.volume / all.n_cells);
  }
} // namespace


PlannedScene::PlannedScene(dealii::ParameterHandler &prm,
                           const std::vector<Assignment> &wrote)
{
  parameters_.parse_parameters(prm);
  {
    const Section section(prm, "Body");
    description_.parse_parameters(prm);
  }
  body_ = description_.create();
  require_parts(parameters_.own_tissues, *body_);
  layout_.emplace(parameters_,
                  *body_->surface(),
                  description_.unturned_box(),
                  OwnGrid::find(wrote));
  if (const auto own = body_->own_mesh())
    parameters_.element_size = edge_of(*own);
  parameters_.fit_elements(layout_->unturned);
  find_remarks(prm);
  find_body(prm);
  require_measures();
  sides_ = find_chosen_sides(wrote, *layout_);
  plan_ =
    scene_plan(parameters_, *layout_, wrote, body_mass_, has(Tissue::lung));
}


void PlannedScene::find_remarks(dealii::ParameterHandler &prm)
{
  remarks_ = body_->remarks();
  constexpr double touches = 0.02, flies = 0.5; // [m]
  const double gap = layout_->body.get_boundary_points().first[2];
  if (layout_->has_ground() && has(Tissue::lung) && gap > touches &&
      gap < flies)
    remarks_.push_back("the lowest skin is " + brief(100. * gap) +
                       " cm above the ground: the wave runs beneath the body, "
                       "and loads its underside; Body/Shift lowers the body");
  if (!parameters_.wants_injury())
    return;
  if (!has(Tissue::brain))
    remarks_.emplace_back(
      "the body has no brain: brain and head get no measures of injury");
  SceneParameters usual = parameters_;
  usual.element_size = 0.;
  usual.fit_elements(layout_->unturned);
  const std::vector<std::string> own = parameters_.own_thresholds.measures();
  const auto is_own = [&](const std::string &measure) {
    return std::find(own.begin(), own.end(), measure) != own.end();
  };
  if (layout_->probe && !layout_at_trunk() && is_own("lung_exposure") &&
      !is_own("lung_exposure_air"))
    remarks_.emplace_back(
      "Injury/Measure lung_exposure: its thresholds judge the load on the "
      "chest's skin alone; lungs are judged by the free-field load, whose "
      "published thresholds Measure lung_exposure_air replaces");
  const std::vector<BodyLayer> layers = read_layers(prm);
  const std::string entry = "Scene/Element size";
  for (const std::string &line : thin_layer_lines(
         layers, parameters_.element_size, usual.element_size, entry))
    remarks_.push_back(line);
  uncertain_layers_ =
    uncertain_layer_lines(layers, parameters_.element_size, entry);
}


bool PlannedScene::has(const Tissue tissue) const
{
  const auto &parts = body_->parts();
  return std::any_of(parts.begin(), parts.end(), [&](const BodyPart &part) {
    return part.tissue == tissue;
  });
}


void PlannedScene::require_measures() const
{
  std::vector<std::string> kinds;
  const bool has_gauges = !body_->landmarks().empty();
  if (has_gauges)
    kinds.emplace_back("gauges");
  if (parameters_.wants_injury() && has(Tissue::brain))
    kinds.emplace_back("head");
  // Else the gauges at the landmarks have the load on the chest.
  const bool has_chest = parameters_.wants_injury() && has(Tissue::lung);
  if (has_chest && !has_gauges)
    kinds.emplace_back("chest");
  std::vector<std::string> taken = injury_measures_of(kinds);
  if (has_chest && has_gauges)
    taken.emplace_back("injury_chest_wall_velocity_mesh");
  // Measures of the wave next to the body, by which lungs are judged.
  if (has_chest && !has_gauges && layout_->probe)
    for (const char *const measure : {"lung_exposure_air", "lung_lethality"})
      taken.emplace_back(measure);
  parameters_.own_thresholds.require(taken, "");
}


void PlannedScene::find_body(dealii::ParameterHandler &prm)
{
  const Section section(prm, "Body");
  const double element_size = parameters_.element_size;
  try
  {
    body_mass_ =
      body_kind() == "phantom"
        ? description_.phantom_mass()
        : estimate_mass(*body_, element_size, [this](const Tissue tissue) {
            return find_solid_material(
                     parameters_.tissues, tissue, parameters_.own_tissues)
              .density;
          });
    if (body_mass_ == 0.)
      throw InputError("no element of " + brief(1e3 * element_size, 3) +
                       " mm has its centre in the body");
    person_.emplace(prm, *body_, body_mass_, layout_->charge);
    if (parameters_.wants_injury())
      tissue_places_ = find_tissue_places(
        *body_, layout_->charge, person_->axes(), element_size);
  }
  catch (const InputError &error)
  {
    throw InputError(
      (body_->own_mesh() ? "Body/Mesh/File: " : "Scene/Element size: ") +
      std::string(error.what()));
  }
}


std::string PlannedScene::elements_in_words() const
{
  const std::string size = brief(1e3 * parameters_.element_size, 3) + " mm";
  const auto own = body_->own_mesh();
  return own ? std::to_string(own->cells.size()) + " hexahedra of one's own, " +
                 size + " on average"
             : "elements of " + size;
}


void PlannedScene::print(const bool with_plan) const
{
  show_line("scene " + version() + " (" + git_revision() +
            "): " + brief(parameters_.mass) + " kg of " +
            parameters_.explosive.title + " and " + person_->description() +
            ", " + distance_in_words(parameters_, *layout_) + ", " +
            brief(layout_->charge[2]) + " m above the ground; cells of " +
            brief(1e3 * layout_->cell_size()) + " mm at the skin" +
            (parameters_.wants_injury() ? ", " + elements_in_words() : ""));
  const std::string direction = person_->charge_in_words();
  show_line("  the charge is at " + coordinates(layout_->charge) + " m" +
            (direction.empty() ? "" : ", " + direction));
  if (parameters_.cell_size > layout_->cell_size() * (1. + 1e-9))
    show_line("  Scene/Cell size = " + brief(parameters_.cell_size) +
              " m is an upper bound: cells are " +
              brief(1e3 * layout_->cell_size(0)) + " mm over a power of two, " +
              brief(1e3 * layout_->cell_size()) + " mm");
  const double usual = layout_->cell_size(parameters_.accuracy.levels);
  if (!(parameters_.cell_size > 0.) &&
      layout_->cell_size() < usual * (1. - 1e-9))
    show_line("  cells of " + brief(1e3 * usual) + " mm are halved to " +
              brief(1e3 * layout_->cell_size()) +
              " mm for a short positive phase or a small body; Scene/Cell "
              "size = " +
              brief(usual) + " m is cheaper, with larger errors");
  const std::string equivalence = equivalence_in_words(parameters_.explosive);
  show_line(layout_->is_far(parameters_)
              ? "  expected " + burst_in_words(*layout_) +
                  ": the front reaches the body at " +
                  brief(1e3 * layout_->arrival, 3) + " ms with " +
                  brief(1e-3 * layout_->overpressure,
                        layout_->overpressure < 1e6 ? 3 : 4) +
                  " kPa" + (equivalence.empty() ? "" : " (" + equivalence + ")")
              : "  " + unknown_beforehand());
  for (const ChangedEntry &change : parameters_.changes)
    show_line("  changed: " + change.entry + " = " + change.value +
              (change.is_of_stage ? ", otherwise " : ", in the library ") +
              change.before);
  std::vector<std::string> details;
  for (const std::string &remark : remarks_)
    details.push_back(remark_line(remark));
  if (!layout_->probe)
    details.emplace_back("  no probe beside the body: the charge, or a side of "
                         "the domain, is too near for the wave in the open");
  for (const std::string &line : io::plan_lines(plan_))
    details.push_back(line);
  const std::string energy = warn_of_energy(parameters_);
  if (!energy.empty())
    details.push_back(energy);
  for (const std::string &line : details)
    with_plan ? show_line(line) : log_line(line);
}


void PlannedScene::add_changes(const std::vector<ChangedEntry> &changes)
{
  parameters_.changes.insert(
    parameters_.changes.end(), changes.begin(), changes.end());
}


double PlannedScene::person_mass() const
{
  return has(Tissue::lung) ? body_mass_ : usual_body_mass;
}


std::optional<Landmark>
PlannedScene::nearest_gauge(const std::vector<std::string> &parts) const
{
  const auto distance = [&](const Landmark &landmark) {
    return landmark.place.distance(layout_->charge);
  };
  // "left ear" is an "ear", "rear" is none.
  const auto is_asked_for = [&](const std::string &name) {
    const auto is_name = [&](const std::string &part) {
      const std::string ending = " " + part, words = " " + name;
      return words.size() >= ending.size() &&
             words.compare(
               words.size() - ending.size(), ending.size(), ending) == 0;
    };
    return parts.empty() || std::any_of(parts.begin(), parts.end(), is_name);
  };
  // If both sides of a body are equally near, the first one recorded counts.
  constexpr double same = 1. - 1e-6;
  std::optional<Landmark> nearest;
  for (const Landmark &landmark : body_->landmarks())
    if (is_asked_for(landmark.name) &&
        (!nearest || distance(landmark) < same * distance(*nearest)))
      nearest = landmark;
  return nearest;
}


std::optional<SceneLayout>
PlannedScene::layout_at(const std::vector<std::string> &parts) const
{
  const auto gauge = nearest_gauge(parts);
  if (!gauge)
    return {};
  SceneLayout there = *layout_;
  there.distance = gauge->place.distance(layout_->charge);
  return there;
}


std::optional<SceneLayout> PlannedScene::layout_at_trunk() const
{
  const auto there = layout_at({"chest", "back", "upper arm"});
  return there && layout_->probe && !is_apart(*there, *layout_) ? std::nullopt
                                                                : there;
}


std::optional<SceneLayout> PlannedScene::layout_at_ears() const
{
  return layout_at({"ear"});
}


std::string PlannedScene::answer_at_trunk() const
{
  const auto there = layout_at_trunk();
  // The answer for the nearest skin is that of a trunk that is there.
  if (!there || !is_apart(*there, *layout_))
    return "";
  const std::string where = "  the trunk is " + brief(there->distance, 3) +
                            " m from the charge: the incident wave there ";
  const auto answer = table_answer(parameters_, *there, person_mass());
  return answer ? where + "loads the lung with " +
                    brief(answer->in_the_open.lung_exposure, 2) +
                    " of what kills half, death by lung injury: " +
                    percent(answer->in_the_open.lung_lethality) +
                    "; before a wall " +
                    brief(answer->before_a_wall.lung_exposure, 2) + ", " +
                    percent(answer->before_a_wall.lung_lethality)
                : where + "is not in the tables";
}


std::string PlannedScene::answer_along_body() const
{
  const std::string side = person_->side_to_charge();
  const auto there = layout_at_trunk();
  const auto answer =
    table_answer(parameters_, there ? *there : *layout_, person_mass());
  return !answer || (side != "head" && side != "feet")
           ? ""
           : "  along the body, from the " + side +
               ", side-on pressure alone loads the lung in the open: " +
               brief(answer->along_body.lung_exposure, 2) +
               " of what kills half, death by lung injury: " +
               percent(answer->along_body.lung_lethality);
}


std::string PlannedScene::answer_at_ears() const
{
  const auto there = layout_at_ears();
  if (!there)
    return "";
  const auto rupture_at = [&](const SceneLayout &layout) {
    const auto answer = table_answer(parameters_, layout, person_mass());
    return answer ? "eardrum rupture " +
                      percent(answer->in_the_open.eardrum_rupture) +
                      "; before a wall " +
                      percent(answer->before_a_wall.eardrum_rupture)
                  : std::string();
  };
  const std::string here = rupture_at(*there);
  return here.empty() || here == rupture_at(*layout_)
           ? ""
           : "  the nearer ear is " + brief(there->distance, 3) +
               " m from the charge: the incident wave there means " + here;
}


std::vector<std::string> PlannedScene::first_answer() const
{
  auto lines = coupling::first_answer(
    parameters_, *layout_, person_mass(), person_->description(), sides_);
  if (!has(Tissue::lung))
    lines.push_back("  the body has no lungs: those of an adult of " +
                    brief(person_mass()) + " kg are taken");
  for (const std::string &line :
       {answer_at_trunk(), answer_along_body(), answer_at_ears()})
    if (!line.empty())
      lines.push_back(line);
  return lines;
}
} // namespace contrecoup::coupling
