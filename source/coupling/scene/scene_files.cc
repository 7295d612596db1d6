// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/scene_files.h>
#include <contrecoup/materials/explosives.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::coupling
{
using dealii::Point;

namespace
{
  /// List of entries in the order of assignment.
  class Entries
  {
  public:
    /// @param origin entry of the scene that determines the value; empty:
    /// none, users override the task's own entry
    void set(const std::string &path,
             const std::string &value,
             const std::string &origin = "")
    {
      entries_.push_back(parse_override(path + "=" + value));
      entries_.back().origin = origin;
    }
    void set(const std::string &path,
             const double value,
             const std::string &origin = "")
    {
      set(path, exact(value), origin);
    }
    void set(const std::string &path,
             const unsigned int value,
             const std::string &origin = "")
    {
      set(path, std::to_string(value), origin);
    }
    std::vector<Assignment> take()
    {
      return std::move(entries_);
    }

  private:
    std::vector<Assignment> entries_;
  };


  std::string text_of(const Point<3> &point)
  {
    return exact(point[0]) + ", " + exact(point[1]) + ", " + exact(point[2]);
  }


  /// Centres of balls that cover the body and the region in front of it.
  std::vector<Point<3>> balls_near(const SceneLayout &layout,
                                   const double spacing)
  {
    const auto &body = layout.body;
    Point<3> axis = body.center();
    const double before = axis[0] < layout.charge[0] ? spacing : -spacing;
    const double height = body.side_length(2);
    const auto count =
      std::max(1U, static_cast<unsigned int>(std::ceil(height / spacing)));
    std::vector<Point<3>> places;
    for (unsigned int i = 0; i < count; ++i)
    {
      axis[2] = body.lower_bound(2) + (i + 0.5) * height / count;
      places.push_back(axis);
      places.push_back(axis + Point<3>(before, 0., 0.));
    }
    return places;
  }


  /// Length of the diagonal [m].
  double diagonal(const dealii::BoundingBox<3> &box)
  {
    const auto corners = box.get_boundary_points();
    return corners.first.distance(corners.second);
  }


  /// Entry that determines the position of the charge.
  std::string place_entry(const SceneParameters &scene)
  {
    return scene.place ? "Charge/Place" : "Charge/Distance and Height";
  }


  /// Tissues of the scene as those of a stage, in its @p section.
  void set_tissues(const SceneParameters &scene,
                   const std::string &section,
                   Entries &entries)
  {
    entries.set(section + "/Set", scene.tissues, "Tissues/Set");
    for (const Tissue tissue : scene.own_tissues.tissues())
      for (const OwnTissues::Change &change :
           scene.own_tissues.changes(tissue, {}))
      {
        const std::string entry =
          "/Tissue " + name_of(tissue) + "/" + change.entry;
        entries.set(section + entry, change.value, "Tissues" + entry);
      }
  }


  void set_domain(const SceneLayout &layout, Entries &entries)
  {
    // The end time determines the extent of the domain.
    const std::string origin = "Scene/End time";
    const std::string symmetry = "Scene/Symmetry";
    entries.set("Domain/Dimension", 3U);
    entries.set("Domain/Size", "given", origin);
    entries.set("Domain/Lower corner", text_of(layout.lower), origin);
    entries.set("Domain/Upper corner", text_of(layout.upper), origin);
    entries.set("Domain/Coarse leaves",
                std::to_string(layout.n_leaves[0]) + ", " +
                  std::to_string(layout.n_leaves[1]) + ", " +
                  std::to_string(layout.n_leaves[2]),
                origin);
    for (const std::string side : {"x low", "x high", "y high", "z high"})
      entries.set("Boundaries/" + side, "open");
    entries.set(
      "Boundaries/y low", layout.is_half ? "symmetry" : "open", symmetry);
    entries.set("Boundaries/z low", "wall");
  }


  void set_first_stage(const SceneLayout &layout, Entries &entries)
  {
    const double radial_cell = SceneLayout::radial_cell;
    double cell = 0.005;
    unsigned int levels = 4;
    // The 2-D stage continues from the ground to the body or a side, if that
    // distance is worth a stage; it ends some subcells of the scene before.
    const double front_cell = layout.cell_size(layout.front_levels);
    const double free_distance =
      layout.unobstructed_distance() - 2. * front_cell - 4. * cell;
    const bool meets_ground_first = free_distance > 1.2 * layout.charge[2];
    // A charge this close to the ground burns in 2-D from the beginning, with
    // at least ten subcells per charge radius.
    const bool burns_in_1d =
      layout.charge[2] > layout.charge_radius + 10. * radial_cell;
    for (; !burns_in_1d && cell > 0.1 * layout.charge_radius && levels < 8;
         ++levels)
      cell *= 0.5;
    if (!meets_ground_first && !burns_in_1d)
      throw InputError(
        "Charge/Height: " + brief(layout.charge[2]) +
        " m above the ground the charge, " + brief(layout.charge_radius) +
        " m in radius, burns in two dimensions, for which it is too near to "
        "the body or a side, " +
        brief(layout.unobstructed_distance()) +
        " m away; a Height of at least " +
        brief(layout.charge_radius + 10. * radial_cell) +
        " m or a larger Distance is needed");
    entries.set("First stage/Kind",
                meets_ground_first ? "axisymmetric" : "spherical");
    entries.set("First stage/Cell size",
                meets_ground_first ? cell : radial_cell);
    if (!meets_ground_first)
      return;
    entries.set("First stage/Levels", levels);
    entries.set("First stage/Spherical cell size",
                burns_in_1d ? radial_cell : 0.);
  }


  void set_explosive(const SceneParameters &scene, Entries &entries)
  {
    const auto &custom = scene.custom_entries;
    entries.set("Material/Explosive",
                custom.empty()       ? scene.explosive.name
                : custom.size() == 1 ? custom.front().second
                                     : "custom",
                "Charge/Explosive");
    if (custom.size() < 2)
      return;
    for (const auto &[entry, value] : custom)
      entries.set("Material/Custom explosive/" + entry,
                  value,
                  "Charge/Custom explosive/" + entry);
  }


  void set_charge(const SceneParameters &scene,
                  const SceneLayout &layout,
                  Entries &entries)
  {
    const TntEquivalence &tnt = scene.explosive.tnt;
    const std::string mass = "Charge/Mass", place = place_entry(scene);
    entries.set("Material/Equation of state", "jwl in air");
    set_explosive(scene, entries);
    entries.set("Charges/Charge 1/Mass", scene.mass, mass);
    entries.set("Charges/Charge 1/Center", text_of(layout.charge), place);
    entries.set("Charges/Afterburn/Kind",
                scene.afterburn > 0. ? "miller" : "none",
                "Charge/Afterburn energy");
    if (scene.afterburn > 0.)
      entries.set(
        "Charges/Afterburn/Energy", scene.afterburn, "Charge/Afterburn energy");
    set_first_stage(layout, entries);
    const std::string reference = "Reference/Kingery Bulmash/";
    entries.set("Reference/Kind", "kingery bulmash");
    entries.set(reference + "Mass", scene.mass, mass);
    entries.set(reference + "Burst",
                IncidentWave::tables_for(layout.is_surface_burst),
                place);
    entries.set(reference + "Center", text_of(layout.charge), place);
    entries.set(reference + "TNT equivalence of pressure", tnt.pressure);
    entries.set(reference + "TNT equivalence of impulse", tnt.impulse);
  }


  void set_limit(const std::string &name,
                 const unsigned int level,
                 const std::string &shape,
                 const std::vector<Point<3>> &centers,
                 const double radius,
                 Entries &entries)
  {
    const std::string limit = "Adaptation/Limit " + name + "/";
    std::vector<std::string> places;
    for (const Point<3> &center : centers)
      places.push_back(text_of(center));
    entries.set(limit + "Largest level", level, "Scene/Accuracy");
    entries.set(limit + "Shape", shape);
    entries.set(limit + "Center", join(places, "; "));
    entries.set(limit + "Radius", radius);
  }


  /// Distance between centres of balls of fine cells, and their radius [m].
  constexpr double spacing = 0.6, fine_radius = 0.7;

  /// Centres of the balls in which fronts are as fine as at the body: around
  /// body, probe and gauges of the user, unless these need so many that each
  /// leaf would take long.
  std::vector<Point<3>> fine_places(const SceneParameters &scene,
                                    const SceneLayout &layout)
  {
    constexpr std::size_t most = 400;
    std::vector<Point<3>> places = balls_near(layout, spacing);
    if (layout.probe)
      places.push_back(*layout.probe);
    const std::size_t n_own = places.size();
    for (const GaugeRaster &gauge : scene.gauges)
    {
      const auto more = gauge.places(spacing);
      places.insert(places.end(), more.begin(), more.end());
    }
    if (places.size() > most)
      places.resize(n_own);
    return places;
  }


  /// Radius about @p center that holds all gauges, at least @p radius [m].
  double radius_with_gauges(const SceneParameters &scene,
                            const SceneLayout &layout,
                            const Point<3> &center,
                            double radius)
  {
    for (const GaugeRaster &gauge : layout.gauges(scene))
      radius =
        std::max(radius, farthest_distance(gauge.box(), center) + spacing);
    return radius;
  }


  /// Coarser cells when the wave has passed body and gauges.
  void set_later_adaptation(const SceneParameters &scene,
                            const SceneLayout &layout,
                            Entries &entries)
  {
    const unsigned int front = layout.front_levels;
    const std::string accuracy = "Scene/Accuracy";
    // After the ground reflection, too, has passed the whole body.
    const double later =
      std::max(2.8 * layout.earliest_arrival, layout.last_arrival);
    const double at_last = 1.5 * later;
    if (later >= scene.end_time)
      return;
    entries.set("Adaptation/Limit later/From time", later);
    entries.set("Adaptation/Limit later/Largest level",
                front > 1 ? front - 1 : 0U,
                accuracy);
    if (at_last < scene.end_time)
    {
      entries.set("Adaptation/Limit at last/From time", at_last);
      entries.set("Adaptation/Limit at last/Largest level",
                  front > 2 ? front - 2 : 0U,
                  accuracy);
    }
    // Fronts that have passed the body, the ground reflection included, do not
    // return.
    const Point<3> center = layout.body.center();
    set_limit(
      "gone",
      0U,
      "outside of ball",
      {center},
      radius_with_gauges(
        scene, layout, center, 0.5 * diagonal(layout.body) + SceneLayout::leaf),
      entries);
    entries.set("Adaptation/Limit gone/From time", later);
  }


  void set_adaptation(const SceneParameters &scene,
                      const SceneLayout &layout,
                      Entries &entries)
  {
    const unsigned int front = layout.front_levels;
    const auto below = [&](const unsigned int n) {
      return front > n ? front - n : 0U;
    };
    const Point<3> middle =
      layout.charge + 0.5 * (layout.body.center() - layout.charge);
    entries.set("Adaptation/Active", "true");
    entries.set("Adaptation/Sensor", "blast");
    entries.set("Adaptation/Noise", 0.05);
    entries.set("Adaptation/Interval", 0U);
    entries.set("Adaptation/Buffer side", "ahead");
    entries.set("Adaptation/Largest level", front, "Scene/Accuracy");
    set_limit("not at the body",
              below(1),
              "outside of ball",
              fine_places(scene, layout),
              fine_radius,
              entries);
    set_limit("fireball",
              below(1),
              "ball",
              {layout.charge},
              layout.fireball_radius(scene),
              entries);
    set_limit("far away",
              below(2),
              "outside of ball",
              {middle},
              radius_with_gauges(
                scene, layout, middle, 0.5 * layout.distance + spacing),
              entries);
    set_later_adaptation(scene, layout, entries);
  }


  void set_output(const double end_time,
                  const unsigned int n_fields,
                  Entries &entries)
  {
    entries.set("Time/End time", end_time, "Scene/End time");
    entries.set("Output/History every steps", 20U);
    entries.set(
      "Output/Fields interval", end_time / n_fields, "Scene/End time");
    entries.set("Output/Checkpoint every minutes", 5.);
  }

  /// From this size [m] on, bones are one or two elements thick. With one point
  /// of integration hourglass modes are then what bends them: in the quickstart
  /// they store 23 % of the skeleton's energy with elements of 10 mm, 9 % with
  /// 5 mm.
  constexpr double least_full_integration = 0.005;

  bool has_tissue(const Body &body, const Tissue tissue)
  {
    const std::vector<BodyPart> &parts = body.parts();
    return std::any_of(parts.begin(), parts.end(), [&](const BodyPart &part) {
      return part.tissue == tissue;
    });
  }

  /// The user's own thresholds of the measures that biomechanics takes.
  void set_thresholds(const OwnThresholds &own, Entries &entries)
  {
    for (const std::string &measure : own.measures())
      if (own.criterion(measure).of != "gauges")
        for (const auto &[entry, value] : own.entries(measure))
          entries.set("Injury/Measure " + measure + "/" + entry,
                      value,
                      own.path(measure) + "/" + entry);
  }

  /// Point of the skin in front of the middle of a body, which faces +x.
  dealii::Point<3> front_of(const Body &body)
  {
    const dealii::BoundingBox<3> box = body.surface()->bounding_box();
    dealii::Point<3> place = box.center();
    place[0] = box.upper_bound(0);
    return body.surface()->project(place);
  }

  /// Body mass clamped to the range of the entries; small bodies have no
  /// chest.
  double allowed_mass(const double body_mass)
  {
    return std::clamp(body_mass, 1., 500.);
  }
} // namespace


std::vector<Assignment> anatomy_entries(const SceneParameters &scene)
{
  Entries entries;
  entries.set("Mesh/Element size", scene.element_size, "Scene/Element size");
  set_tissues(scene, "Tissues", entries);
  return entries.take();
}


std::vector<Assignment> blast_entries(const SceneParameters &scene,
                                      const SceneLayout &layout,
                                      const double body_mass)
{
  Entries entries;
  set_domain(layout, entries);
  set_charge(scene, layout, entries);
  entries.set("Method/Precision", "single");
  entries.set("Method/Subcells", SceneLayout::subcells);
  entries.set("Method/CFL number", 0.9);
  entries.set("Rigid body/Kind", "body", "Body/Kind");
  entries.set("Rigid body/Levels", layout.levels, "Scene/Accuracy");
  entries.set("Loads/Record", "true");
  entries.set("Loads/Interval", scene.end_time / 2400., "Scene/End time");
  entries.set("Loads/Body mass", allowed_mass(body_mass), "Body");
  set_adaptation(scene, layout, entries);
  if (layout.probe)
    entries.set("Probes/Points", text_of(*layout.probe));
  entries.set("Pictures/Planes", "y = " + exact(layout.charge[1]));
  entries.set("Pictures/Resolution", 640U);
  set_output(scene.end_time, 24, entries);
  entries.set("Output/Volume fields", "false");
  return entries.take();
}


std::vector<Assignment>
biomechanics_entries(const SceneParameters &scene,
                     const SceneLayout &layout,
                     const Body &body,
                     const std::vector<TissuePlace> &places,
                     const double body_mass)
{
  Entries entries;
  entries.set("Mesh/Kind", "body", "Body/Kind");
  entries.set("Mesh/Element size", scene.element_size, "Scene/Element size");
  set_tissues(scene, "Materials", entries);
  entries.set("Elements/Kinematics", "finite rotation");
  entries.set("Elements/Precision", "single");
  if (scene.element_size >= least_full_integration)
    entries.set("Elements/Integration", "full", "Scene/Element size");
  entries.set("Loads/Recorded/Largest distance", 0.5);
  entries.set(
    "Loads/Recorded/Mirror", layout.is_half ? "y" : "none", "Scene/Symmetry");
  const bool has_lung = has_tissue(body, Tissue::lung);
  entries.set("Injury/Active",
              has_lung || has_tissue(body, Tissue::brain) ? "true" : "false");
  if (has_lung)
    entries.set("Injury/Chest", text_of(front_of(body)));
  entries.set("Injury/Body mass", allowed_mass(body_mass), "Body");
  set_thresholds(scene.own_thresholds, entries);
  for (const Landmark &landmark : body.landmarks())
    if (landmark.name == "chest")
    {
      // The blast has a gauge at each landmark, which reports the injuries.
      entries.set("Injury/Chest", text_of(landmark.place));
      entries.set("Injury/Chest load", "false");
    }
  std::vector<std::string> points;
  for (const TissuePlace &place : places)
    points.push_back(text_of(place.place));
  entries.set("Probes/Points", join(points, "; "));
  entries.set("Peaks/Active", "true");
  entries.set("Output/Probes every steps", 5U);
  set_output(scene.end_time, 24, entries);
  return entries.take();
}
} // namespace contrecoup::coupling
