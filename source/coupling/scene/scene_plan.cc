// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/application/model_bias.h>
#include <contrecoup/coupling/scene/afterburn_items.h>
#include <contrecoup/coupling/scene/scene_plan.h>
#include <contrecoup/coupling/scene/stage_results.h>
#include <contrecoup/io/file/file_format.h>
#include <contrecoup/io/run/plan_table.h>
#include <contrecoup/solid/run/strain_item.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::coupling
{
namespace
{
  constexpr double gravity = 9.81; // [m/s^2]
  /// Fewest cells for a positive phase. With fewer, cells of half the size
  /// raise the peak on a chest by a fifth and more, see
  /// parameter_files/scene/error_estimate.md.
  constexpr double least_cells = 15.;
  /// Least part of the skin: cells of 20 mm have 98 % of that of a man, those
  /// of 40 mm 95 %, those of 80 mm, which lose lower legs and feet, 70 %.
  constexpr double least_skin = 0.9;
  /// Displacement of a body at rest for the gas, in parts of its depth: the
  /// loads on its skin then move by as much.
  constexpr double largest_displacement = 0.1;

  /// Item about the body at rest, with its estimate.
  /// @param displacement while the load lasts [m]
  /// @param is_held whether biomechanics has supports
  Assumption rigid_body(const double displacement,
                        const bool is_held,
                        const SceneLayout &layout)
  {
    return {"rigid_body",
            std::string("fixed rigid body in the gas") +
              (is_held ? ", held by Supports in biomechanics" : ""),
            std::string("displacement of the ") + (is_held ? "held " : "") +
              "body during the positive phase over its depth",
            "-",
            displacement / layout.shortest_side(),
            largest_displacement,
            false,
            is_held ? "Biomechanics/Supports" : ""};
  }

  /// Item of biomechanics about small strains.
  /// @param kinematics as the user wrote it; empty: that of the scene
  Assumption strain(const std::string &kinematics)
  {
    Assumption item = solid::strain_item(
      kinematics.empty()
        ? SolidKinematics::finite_rotation
        : find_choice(solid_kinematics, kinematics, "kinematics of solids"));
    item.entry = "Biomechanics/" + item.entry;
    return item;
  }

  /// Who stands is held by the ground: the figure is for information.
  /// @param given acceleration as the user wrote it
  Assumption gravity_of_body(const double end_time,
                             const double speed,
                             const std::string &given)
  {
    return {"gravity_of_body",
            given.empty() ? "left out" : given + " m/s^2",
            "speed that gravity gives until the end over the largest speed of "
            "the body's centre of mass",
            "-",
            gravity * end_time / speed,
            unknown,
            false,
            "Biomechanics/Gravity/Acceleration"};
  }

  /// Item about the ground below a body that stands, sits or lies on it.
  Assumption ground_of_body(const SceneLayout &layout)
  {
    return {"ground_of_body",
            "left out in biomechanics: the body may move into it",
            "height of the lowest skin above the ground",
            "m",
            layout.body.lower_bound(2),
            unknown,
            false,
            "Biomechanics/Ground/Active"};
  }

  Assumption symmetry(const SceneLayout &layout)
  {
    return {"symmetry",
            layout.is_half ? "half of the gas" : "all of the gas",
            "difference between both sides of y = 0",
            "m",
            layout.asymmetry,
            layout.is_half ? layout.symmetry_limit : unknown,
            false,
            "Scene/Symmetry"};
  }

  /// Item about the lung's law under the blast wave: the pressure of air that
  /// is compressed grows beyond all bounds, that of a constant bulk modulus
  /// does not, so that the load crushes elements.
  /// @param peak reflected overpressure at the trunk [Pa]
  Assumption lung(const SceneParameters &scene, const double peak)
  {
    const SolidMaterial tissue =
      find_solid_material(scene.tissues, Tissue::lung, scene.own_tissues);
    const bool has_air = tissue.gas.exists();
    return {
      "lung",
      std::string(has_air ? "air that stiffens" : "of constant bulk modulus") +
        ", set " + scene.tissues,
      "reflected peak over the bulk modulus of the lung",
      "-",
      peak / tissue.bulk_modulus,
      has_air ? unknown : 1.,
      false,
      "Tissues/Set"};
  }

  /// Item about the cells of the gas for the blast wave at the body.
  /// @param phase positive phase there [s]
  Assumption resolution(const SceneParameters &scene,
                        const SceneLayout &layout,
                        const double phase)
  {
    const bool is_finest =
      scene.accuracy.name == SceneParameters::accuracies.back().name;
    return {"resolution",
            "cells of " + brief(1e3 * layout.cell_size()) + " mm at the skin",
            "number of cells in the positive phase of the wave at the body",
            "-",
            layout.cells_per_phase() * phase / layout.positive_phase,
            std::min(least_cells, scene.accuracy.cells_per_phase),
            true,
            is_finest || scene.cell_size > 0. ? "Scene/Cell size"
                                              : "Scene/Accuracy"};
  }

  /// Item about the cells of the gas along the body.
  Assumption body_cells(const SceneLayout &layout)
  {
    return {"body_cells",
            "cells of " + brief(1e3 * layout.cell_size()) + " mm at the skin",
            "number of cells along the body's shortest side",
            "-",
            layout.cells_across(),
            SceneLayout::least_cells_across,
            true,
            "Scene/Cell size"};
  }

  /// Item about parts of the body that are thinner than cells of the gas.
  /// @param part of the skin that the gas has [-]
  Assumption skin(const SceneLayout &layout, const double part)
  {
    return {"skin",
            "cells of " + brief(1e3 * layout.cell_size()) + " mm at the skin",
            "part of the body's skin, that the gas has",
            "-",
            part,
            least_skin,
            true,
            "Scene/Cell size"};
  }

  /// Item about the difference of the model from the tables.
  Assumption
  bias(const std::string &what, const double value, const std::string &gap)
  {
    return {"model_bias_" + what,
            gap.empty() ? "as the explosive's constants and afterburn give it"
                        : gap,
            "difference of the model's incident " + what +
              " from the tables, whatever the cells",
            "-",
            value,
            unknown,
            false,
            "Charge/Explosive"};
  }

  double number_or_unknown(const io::Json &object, const std::string &name)
  {
    return object.is_object() && object.contains(name) &&
               object[name].is_number()
             ? object[name].get<double>()
             : unknown;
  }

  /// Positive phase at the body, where the tables know one.
  double known_phase(const SceneParameters &scene, const SceneLayout &layout)
  {
    return layout.incident_wave(scene).is_tabulated(BlastQuantity::duration,
                                                    layout.distance)
             ? layout.positive_phase
             : unknown;
  }

  /// Items about charge and cells, known before the run.
  std::vector<Assumption> items_of_charge(const SceneParameters &scene,
                                          const SceneLayout &layout)
  {
    const ModelBias known =
      model_bias(scene.burst(layout.is_surface_burst), layout.distance);
    std::vector<Assumption> items = afterburn_items(scene, layout);
    items.insert(items.begin(), symmetry(layout));
    for (const Assumption &item :
         {resolution(scene, layout, known_phase(scene, layout)),
          body_cells(layout),
          skin(layout, unknown),
          bias("peak", known.peak, known.gap),
          bias("impulse", known.impulse, known.gap),
          bias("duration", known.duration, known.gap)})
      items.push_back(item);
    return items;
  }

  /// Why the phase at the probe tells nothing of that of the front; empty: it
  /// does.
  std::string gap_of_phase(const SceneLayout &layout, const std::string &blast)
  {
    if (!layout.probe)
      return "there is no probe beside the body";
    const auto result = [&](const std::string &name) {
      return stage_result(blast, "probe_1_" + name);
    };
    return result("cut_off") > 0. ? "the run ends before that at the probe does"
           : result("later_peak_time") <= result("arrival") + result("duration")
             ? "that at the probe is of several waves"
             : "";
  }

  /// End of the positive phase next to the body as the run has it, where it has
  /// one, else by the tables [s].
  double end_of_phase(const SceneLayout &layout, const std::string &blast)
  {
    const double end = stage_result(blast, "probe_1_arrival") +
                       stage_result(blast, "probe_1_duration");
    return layout.probe && std::isfinite(end)
             ? end
             : layout.arrival + layout.positive_phase;
  }

  /// The same with what a run measured: neither the rise by afterburn nor the
  /// difference from other models.
  std::vector<Assumption> found_of_charge(const SceneParameters &scene,
                                          const SceneLayout &layout,
                                          const std::string &folder)
  {
    std::vector<Assumption> items = unmeasured(items_of_charge(scene, layout));
    for (Assumption &item : items)
      if (item.name == "resolution")
      {
        const std::string gap = gap_of_phase(layout, folder + "/blast");
        item = resolution(
          scene,
          layout,
          gap.empty() ? stage_result(folder + "/blast", "probe_1_duration")
                      : unknown);
        if (!gap.empty())
          item.quantity += ", not measured, since " + gap;
      }
      else if (item.name == "skin")
        item.measure(stage_check(folder + "/blast", "loads_skin_projections") /
                     skin_projections(folder + "/anatomy"));
      else if ((item.name.rfind("afterburn_", 0) == 0 &&
                scene.afterburn > 0.) ||
               item.name.rfind("model_bias_", 0) == 0)
        item.value = unknown;
    return items;
  }

  std::string text(const io::Json &object,
                   const std::string &name,
                   const std::string &otherwise = "")
  {
    return object.contains(name) && object[name].is_string()
             ? object[name].get<std::string>()
             : otherwise;
  }

  /// Items of a task's summary, with their estimates or with measured values.
  /// @param folder of the scene
  std::vector<Assumption> task_items(const std::string &folder,
                                     const std::string &task,
                                     const char *value)
  {
    std::vector<Assumption> items;
    const std::string section = task == "blast" ? "Blast/" : "Biomechanics/";
    const io::Json summary = io::read_json(
      folder + "/" + task + "/summary.json", io::formats::summary);
    if (!summary.is_object() || !summary.contains("assumptions"))
      return items;
    for (const auto &[name, item] : summary["assumptions"].items())
    {
      if (!item.is_object())
        continue;
      Assumption one;
      one.name = name;
      one.decision = text(item, "decision");
      one.quantity = text(item, "quantity");
      one.unit = text(item, "unit", "-");
      one.value = number_or_unknown(item, value);
      one.is_lower_limit = item.contains("at_least");
      one.limit =
        number_or_unknown(item, one.is_lower_limit ? "at_least" : "at_most");
      one.entry = section + text(item, "entry");
      items.push_back(one);
    }
    return items;
  }

  /// Items of the plan about the body, with what biomechanics measured.
  std::vector<Assumption> found_of_body(const SceneParameters &scene,
                                        const SceneLayout &layout,
                                        const std::vector<Assumption> &plan,
                                        const std::string &folder)
  {
    const std::string solid = folder + "/biomechanics";
    const BodyMotion motion =
      measure_motion(solid, end_of_phase(layout, folder + "/blast"));
    const std::vector<Assumption> found =
      task_items(folder, "biomechanics", "measured");
    std::vector<Assumption> items;
    for (Assumption item : unmeasured(plan))
    {
      if (item.name == "rigid_body")
        item.measure(motion.displacement / layout.shortest_side());
      else if (const Assumption *own = io::find_assumption(found, item.name))
        item = *own;
      else if (item.name == "lung")
        item = lung(scene, largest_trunk_peak(folder + "/blast"));
      else if (item.name == "gravity_of_body")
        item.measure(gravity * scene.end_time / motion.speed);
      else if (item.name != "ground_of_body" && item.name != "strain")
        continue;
      items.push_back(item);
    }
    return items;
  }

  /// Item about a side of the domain that the user chose; between body and wall
  /// the gas needs a cell.
  Assumption chosen_side(const ChosenSide &side, const SceneLayout &layout)
  {
    std::string name = "side " + side.name;
    std::replace(name.begin(), name.end(), ' ', '_');
    return {name,
            side.in_words(layout),
            "distance of this side from the body",
            "m",
            side.is_high
              ? side.place(layout) - layout.body.upper_bound(side.direction)
              : layout.body.lower_bound(side.direction) - side.place(layout),
            side.kind == "wall" ? layout.cell_size() : unknown,
            side.kind == "wall",
            side.entry()};
  }

  Assumption end_of_load(const SceneParameters &scene, const double value)
  {
    return {"end_time",
            "followed until " + brief(1e3 * scene.end_time) + " ms",
            "end of the positive phase of the incident wave",
            "s",
            value,
            scene.end_time,
            false,
            "Scene/End time"};
  }

  /// The user's value for an entry of biomechanics; empty: none.
  std::string written(const std::vector<Assignment> &wrote,
                      const std::string &section,
                      const std::string &entry)
  {
    std::string value;
    for (const Assignment &assignment : wrote)
      if (assignment.entry == entry &&
          join(assignment.sections, "/") == "Biomechanics/" + section)
        value = trim(assignment.value);
    return value;
  }

  bool has_supports(const std::vector<Assignment> &wrote)
  {
    return std::any_of(wrote.begin(), wrote.end(), [](const auto &one) {
      return begins_with(join(one.sections, "/"), "Biomechanics/Supports/") &&
             one.sections.back() != "Support *";
    });
  }
} // namespace


std::vector<Assumption> scene_plan(const SceneParameters &scene,
                                   const SceneLayout &layout,
                                   const std::vector<Assignment> &wrote,
                                   const double body_mass,
                                   const bool has_lung)
{
  const IncidentWave wave = layout.incident_wave(scene);
  // A person fills three fifths of the box.
  const double speed =
    wave.value(BlastQuantity::reflected_impulse, layout.distance) * 0.6 *
    layout.seen_area() / body_mass;
  const double phase = known_phase(scene, layout);
  std::vector<Assumption> items = items_of_charge(scene, layout);
  for (const ChosenSide &side : find_chosen_sides(wrote, layout))
    items.push_back(chosen_side(side, layout));
  items.push_back(end_of_load(scene, layout.arrival + phase));
  // Under a load that falls linearly.
  items.push_back(rigid_body(2. / 3. * speed * phase,
                             scene.wants_injury() && has_supports(wrote),
                             layout));
  if (!scene.wants_injury())
    return items;
  items.push_back(strain(written(wrote, "Elements", "Kinematics")));
  if (has_lung)
    items.push_back(
      lung(scene,
           wave.value(BlastQuantity::reflected_overpressure, layout.distance)));
  items.push_back(gravity_of_body(
    scene.end_time, speed, written(wrote, "Gravity", "Acceleration")));
  const bool is_on_ground =
    layout.has_ground() && layout.body.lower_bound(2) < scene.element_size;
  if (is_on_ground && written(wrote, "Ground", "Active") != "true")
    items.push_back(ground_of_body(layout));
  return items;
}


std::vector<Assumption> scene_audit(const SceneParameters &scene,
                                    const SceneLayout &layout,
                                    const std::vector<Assumption> &plan,
                                    const std::string &folder)
{
  std::vector<Assumption> items = found_of_charge(scene, layout, folder);
  for (const Assumption &item : plan)
    if (item.name.rfind("side_", 0) == 0)
      items.push_back(item);
  if (scene.wants_injury())
    for (const Assumption &item : found_of_body(scene, layout, plan, folder))
      items.push_back(item);
  else
    // Nothing moves the body.
    for (const Assumption &item : plan)
      if (item.name == "rigid_body")
        items.push_back(rigid_body(unknown, false, layout));
  for (const Assumption &item : task_items(folder, "blast", "measured"))
    items.push_back(item);
  return items;
}


std::vector<Assumption> blast_plan(const std::string &folder)
{
  return task_items(folder, "blast", "estimate");
}
} // namespace contrecoup::coupling
