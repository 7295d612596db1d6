// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/expression.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/first_stage/first_stage_parameters.h>
#include <contrecoup/coupling/scene/reflecting_plane.h>
#include <contrecoup/coupling/scene/scene_checks.h>
#include <contrecoup/gas/adaptation/size_limits.h>
#include <contrecoup/gas/run/reflected_path.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace contrecoup::coupling
{
using dealii::Point;

namespace
{
  constexpr double round_off = 1e-6; // [m]

  /// Points "x, y, z; x, y, z" of an entry.
  std::vector<Point<3>> points_of(const std::string &text)
  {
    std::vector<Point<3>> points;
    for (const std::string &part : split(text, ';'))
      if (const auto point = point_of(part))
        points.push_back(*point);
    return points;
  }


  gas::SizeLimits limits_of(const TaskText &blast)
  {
    std::vector<Assignment> of_limits;
    for (const Assignment &assignment : blast.entries)
      if (assignment.sections.size() == 2 &&
          assignment.sections[0] == "Adaptation")
        of_limits.push_back(assignment);
    dealii::ParameterHandler prm;
    {
      const Section section(prm, "Adaptation");
      gas::SizeLimits::declare_parameters(prm);
    }
    apply_assignments(of_limits, prm);
    const Section section(prm, "Adaptation");
    gas::SizeLimits limits;
    limits.parse_parameters(prm, 3);
    return limits;
  }


  dealii::BoundingBox<3> domain_of(const TaskText &blast)
  {
    const auto lower = point_of(blast.values.at("Domain/Lower corner"));
    const auto upper = point_of(blast.values.at("Domain/Upper corner"));
    if (blast.values.at("Domain/Dimension") != "3" || !lower || !upper)
      throw InputError("Blast/Domain: the gas around a body needs Dimension = "
                       "3 and corners of three numbers");
    return dealii::BoundingBox<3>({*lower, *upper});
  }


  void check_domain(const PlannedScene &scene,
                    const dealii::BoundingBox<3> &domain)
  {
    const SceneLayout &layout = scene.layout();
    const auto require = [&](const Point<3> &lower,
                             const Point<3> &upper,
                             const std::string &what) {
      for (unsigned int d = 0; d < 3; ++d)
      {
        const bool is_cut = d == 1 && layout.is_half;
        if ((lower[d] < domain.lower_bound(d) - round_off && !is_cut) ||
            upper[d] > domain.upper_bound(d) + round_off)
          throw InputError(
            "Blast/Domain: from " +
            coordinates(domain.get_boundary_points().first) + " to " +
            coordinates(domain.get_boundary_points().second) +
            " m it does not hold " + what + ", which is from " +
            coordinates(lower) + " to " + coordinates(upper) + " m");
      }
    };
    const auto corners = layout.body.get_boundary_points();
    require(corners.first, corners.second, "the body");
    Point<3> lower = layout.charge, upper = layout.charge;
    for (unsigned int d = 0; d < 3; ++d)
    {
      lower[d] -= layout.charge_radius;
      upper[d] += layout.charge_radius;
    }
    lower[2] = std::max(0., lower[2]);
    require(lower, upper, "the charge");
  }


  void require_in_domain(const PlannedScene &scene,
                         const Point<3> &probe,
                         const std::string &where,
                         const dealii::BoundingBox<3> &domain)
  {
    Point<3> image = probe;
    image[1] *= -1.;
    if (domain.point_inside(probe, round_off))
      return;
    throw InputError(
      where + "is outside of the domain, from " +
      coordinates(domain.get_boundary_points().first) + " to " +
      coordinates(domain.get_boundary_points().second) +
      " m, around the charge at " + coordinates(scene.layout().charge) +
      " m and the body; Blast/Domain enlarges it" +
      (scene.layout().is_half && domain.point_inside(image, round_off)
         ? "; by symmetry " + coordinates(image) +
             " m has the same values, and Scene/Symmetry = none computes "
             "both halves"
         : ""));
  }


  void check_probes(const PlannedScene &scene,
                    const TaskText &blast,
                    const dealii::BoundingBox<3> &domain)
  {
    const auto words = [](const GaugeRaster &gauge, const Point<3> &place) {
      return "Blast/" + gauge.entry + ": " + coordinates(place) + " m ";
    };
    for (const GaugeRaster &gauge : find_gauges(blast.values))
    {
      for (const Point<3> &place : {gauge.begin, gauge.end})
        require_in_domain(scene, place, words(gauge, place), domain);
      if (gauge.entry != "Probes/Points")
        continue;
      const Point<3> probe = gauge.begin;
      const std::string where = words(gauge, probe);
      if (scene.body().surface()->value(probe) < 0.)
        throw InputError(where + "is in the body; Blast/Loads/Gauges are on "
                                 "its skin, Biomechanics/Probes/Points in it");
    }
  }


  void check_gauges(const PlannedScene &scene, const TaskText &blast)
  {
    const double allowed = std::stod(blast.values.at("Loads/Gauge radius")) +
                           2. * scene.layout().cell_size();
    for (const std::string &gauge : split(blast.values.at("Loads/Gauges"), ';'))
    {
      const std::size_t colon = gauge.find(':');
      const auto place =
        point_of(colon == std::string::npos ? "" : gauge.substr(colon + 1));
      if (!place)
        continue;
      const double distance = scene.body().surface()->distance(*place);
      if (std::abs(distance) > allowed)
        throw InputError(
          "Blast/Loads/Gauges: \"" + trim(gauge.substr(0, colon)) + "\" at " +
          coordinates(*place) + " m is " + brief(std::abs(distance), 3) +
          " m from the skin, " + "farther than its radius and two cells, " +
          brief(allowed, 3) + " m; the nearest skin is at " +
          coordinates(scene.body().surface()->project(*place)) + " m");
    }
  }


  /// Whether a place in the body, or within an element of its skin, is where
  /// the expression is not 0.
  bool selects_place(const Expression &where,
                     const PlannedScene &scene,
                     const double element)
  {
    const auto [lower, upper] = scene.layout().body.get_boundary_points();
    Point<3> place;
    for (place[0] = lower[0] - element; place[0] <= upper[0] + element;
         place[0] += element / 2.)
      for (place[1] = lower[1] - element; place[1] <= upper[1] + element;
           place[1] += element / 2.)
        for (place[2] = lower[2] - element; place[2] <= upper[2] + element;
             place[2] += element / 2.)
          if (where.value(place) != 0. &&
              scene.body().surface()->distance(place) <= element)
            return true;
    return false;
  }


  /// Refuses supports and loads of which no mesh of the body can have a node.
  void check_places(const PlannedScene &scene, const TaskText &biomechanics)
  {
    for (const auto &[path, text] : biomechanics.values)
    {
      const std::size_t last = path.rfind('/');
      if (path.substr(last + 1) != "Where" || text == "1")
        continue;
      if (!selects_place(
            Expression(path, text), scene, scene.parameters().element_size))
        throw InputError(
          biomechanics.words(path) + " = \"" + text +
          "\" selects no place in the body, which is from " +
          coordinates(scene.layout().body.get_boundary_points().first) +
          " to " +
          coordinates(scene.layout().body.get_boundary_points().second) + " m");
    }
  }
} // namespace


void check_blast(const PlannedScene &scene, const TaskText &blast)
{
  const double arrival = scene.layout().arrival;
  const double end = std::stod(blast.values.at("Time/End time"));
  if (end <= arrival)
    throw InputError(blast.words("Time/End time") + " = " + brief(end) +
                     " s: the blast reaches the body at " + brief(arrival) +
                     " s only");
  FirstStageParameters first_stage;
  first_stage.kind = blast.values.at("First stage/Kind");
  first_stage.criterion = blast.values.at("First stage/Hand over at");
  first_stage.time = std::stod(blast.values.at("First stage/Time"));
  const std::string late = first_stage.late_hand_over(end);
  if (!late.empty())
    throw InputError(blast.words(late));
  const dealii::BoundingBox<3> domain = domain_of(blast);
  check_domain(scene, domain);
  check_probes(scene, blast, domain);
  check_gauges(scene, blast);
}


std::string reflection_warning(const PlannedScene &scene, const TaskText &blast)
{
  const SceneLayout &layout = scene.layout();
  const auto corners = domain_of(blast).get_boundary_points();
  const std::vector<GaugeRaster> gauges = find_gauges(blast.values);
  const std::array<std::string, 6> sides{
    {"x low", "x high", "y low", "y high", "z low", "z high"}};
  std::vector<unsigned int> open;
  for (unsigned int side = 0; side < sides.size(); ++side)
    if (blast.values.at("Boundaries/" + sides[side]) == "open")
      open.push_back(side);
  if (gauges.empty() || open.empty())
    return "";
  const auto nearest = [&](const Point<3> &image) {
    Point<3> found = gauges.front().nearest(image);
    for (const GaugeRaster &gauge : gauges)
      if (image.distance(gauge.nearest(image)) < image.distance(found))
        found = gauge.nearest(image);
    return found;
  };
  const auto paths = gas::reflected_paths<3>(
    layout.charge, corners.first, corners.second, open, nearest);
  const auto arrival_by = [&](const gas::ReflectedPath<3> &path) {
    return layout.earliest_return(scene.parameters(), path.image, path.gauge);
  };
  const gas::ReflectedPath<3> path = *std::min_element(
    paths.begin(), paths.end(), [&](const auto &one, const auto &other) {
      return arrival_by(one) < arrival_by(other);
    });
  const double end_time = scene.parameters().end_time;
  const double arrival = arrival_by(path);
  if (arrival >= end_time)
    return "";
  return "WARNING: reflection: from the charge by the open side " +
         sides[path.side] + " back to the probe at " + coordinates(path.gauge) +
         " m it is " + brief(path.length, 3) + " m, and the front goes that " +
         "way in " + brief(arrival, 3) + " s, before the end at " +
         brief(end_time) + " s; a " +
         (layout.has_own_corners() ? "larger Blast/Domain, or none,"
                                   : "shorter Scene/End time") +
         " keeps its reflection away";
}


std::string grazing_warning(const PlannedScene &scene)
{
  const SceneLayout &layout = scene.layout();
  if (!layout.has_own_corners())
    return "";
  const std::vector<std::string> sides =
    grazed_sides(scene.parameters(), layout, scene.sides());
  return sides.empty()
           ? ""
           : "WARNING: grazed side: the front runs along the open " +
               std::string(sides.size() == 1 ? "side " : "sides ") +
               join(sides, ", ") +
               " before it reaches the body, where the wave is disturbed "
               "from its arrival on; a larger Blast/Domain, or none, keeps "
               "that away";
}


std::string gauge_cells_warning(const PlannedScene &scene,
                                const TaskText &blast)
{
  constexpr double spacing = 0.3; // [m]
  const SceneLayout &layout = scene.layout();
  const SceneParameters &parameters = scene.parameters();
  const IncidentWave wave = layout.incident_wave(parameters);
  const gas::SizeLimits limits = limits_of(blast);
  const auto most = static_cast<unsigned int>(
    std::stoul(blast.values.at("Adaptation/Largest level")));
  double fewest = parameters.accuracy.cells_per_phase;
  std::string words;
  for (const GaugeRaster &gauge : layout.gauges(parameters))
    for (const Point<3> &place : gauge.places(spacing))
    {
      const double distance = place.distance(layout.charge);
      const double arrival = wave.value(BlastQuantity::arrival, distance);
      const unsigned int level =
        limits.levels(place, arrival, {0, most}).max_level;
      // Products are coarser next to the body, too.
      if (level >= layout.front_levels || arrival > parameters.end_time ||
          distance <= layout.fireball_radius(parameters))
        continue;
      const double cell = layout.cell_size(level);
      const double n_cells = SceneLayout::sound_speed *
                             layout.expected_phase(parameters, distance) / cell;
      if (n_cells >= fewest)
        continue;
      fewest = n_cells;
      words = "cells of " + brief(1e3 * cell) + " mm at the probe at " +
              coordinates(place) + " m have " + brief(n_cells, 2) +
              " in the positive phase";
    }
  if (words.empty())
    return "";
  const double front = layout.cell_size(layout.front_levels);
  return "WARNING: gauge cells: " + words +
         ", where fronts beside the body have " +
         brief(SceneLayout::sound_speed * layout.positive_phase / front, 2) +
         " of " + brief(1e3 * front) +
         " mm: peaks and injuries there are too low; smaller Blast/Probes/Gauge "
         "planes, or Blast/Adaptation without limits of one's own, have cells "
         "as fine as there";
}


void check_biomechanics(const PlannedScene &scene,
                        const TaskText &blast,
                        const TaskText &biomechanics)
{
  const std::string entry = "Time/End time";
  const double loads_end = std::stod(blast.values.at(entry));
  const double end = std::stod(biomechanics.values.at(entry));
  if (end > loads_end * (1. + 1e-9))
    throw InputError(biomechanics.words(entry) + " = " + brief(end) +
                     " s: the loads of the blast end at " + brief(loads_end) +
                     " s (" + blast.words(entry) + ")");
  const double element = scene.parameters().element_size;
  for (const Point<3> &probe :
       points_of(biomechanics.values.at("Probes/Points")))
  {
    const double outside = scene.body().surface()->distance(probe);
    if (outside > element)
      throw InputError("Biomechanics/Probes/Points: " + coordinates(probe) +
                       " m is " + brief(outside, 3) +
                       " m outside of the body, farther than an element, " +
                       brief(element) + " m");
  }
  check_places(scene, biomechanics);
}
} // namespace contrecoup::coupling
