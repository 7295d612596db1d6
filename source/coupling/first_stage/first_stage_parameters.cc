// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/first_stage/first_stage_parameters.h>
#include <contrecoup/gas/conditions/rigid_body.h>
#include <contrecoup/gas/scene/scene_places.h>
#include <contrecoup/materials/gas_material.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace contrecoup::coupling
{
namespace
{
  using Changes = std::map<std::string, std::string>;

  /// Copies all entries of @p from to @p to, except those in @p left_out
  /// (beginnings of paths); @p changes, by "Section/Entry", replace values.
  void copy_entries(const ParameterHandler &from,
                    const Changes &changes,
                    ParameterHandler &to,
                    const std::vector<std::string> &left_out)
  {
    std::vector<Assignment> assignments;
    for (Assignment &assignment : assignments_of(from))
    {
      std::string path;
      for (const std::string &section : assignment.sections)
        path += section + "/";
      if (std::any_of(
            left_out.begin(), left_out.end(), [&](const std::string &begin) {
              return path.rfind(begin, 0) == 0;
            }))
        continue;
      const auto change = changes.find(path + assignment.entry);
      if (change != changes.end())
        assignment.value = change->second;
      assignments.push_back(assignment);
    }
    apply_assignments(assignments, to);
  }

  /// Moves balls, charges and ignition points to the centre or axis of a
  /// stage; points on the axis keep their height, z in the scene and y in the
  /// stage.
  void move_charges(const ParameterHandler &scene,
                    const std::map<std::string, std::string> &values,
                    const int stage_dim,
                    Changes &changes)
  {
    const auto moved = [&](const std::string &place) {
      const auto words = split(place, ',');
      return stage_dim == 1 ? "0" : "0, " + (words.size() > 2 ? words[2] : "0");
    };
    for (const std::string &name : item_names(scene, "Initial state/Region"))
    {
      const std::string entry = "Initial state/Region " + name + "/Center";
      changes[entry] = moved(values.at(entry));
    }
    for (const std::string &name : item_names(scene, "Charges/Charge"))
    {
      const std::string charge = "Charges/Charge " + name;
      changes[charge + "/Center"] = moved(values.at(charge + "/Center"));
      std::vector<std::string> points;
      for (const auto &point :
           split(values.at(charge + "/Ignition points"), ';'))
        points.push_back(moved(point));
      changes[charge + "/Ignition points"] = join(points, "; ");
    }
  }

  /// Sets the entries of the first stage of the first stage.
  void set_stage_before(const std::map<std::string, std::string> &values,
                        const FirstStageParameters &parameters,
                        const int stage_dim,
                        Changes &changes)
  {
    const bool is_staged = stage_dim > 1 && parameters.spherical_cell_size > 0.;
    changes["First stage/Kind"] = is_staged ? "spherical" : "none";
    changes["First stage/Cell size"] = is_staged
                                         ? exact(parameters.spherical_cell_size)
                                         : values.at("First stage/Cell size");
    changes["First stage/Hand over at"] = "auto";
    changes["First stage/Spherical cell size"] = "0";
  }

  template <int dim>
  std::string text_of(const dealii::Point<dim> &point)
  {
    std::vector<std::string> words;
    for (unsigned int d = 0; d < dim; ++d)
      words.push_back(exact(point[d]));
    return join(words, ",");
  }

  /// @throws InputError for a charge (current subsection) without the symmetry
  /// of the stage
  void check_charge(const ParameterHandler &prm,
                    const std::string &name,
                    const bool axisymmetric_stage)
  {
    const std::string where = "First stage: Charges/Charge " + name;
    const std::string shape = prm.get("Shape");
    const auto axis = read_list(prm, "Axis");
    const bool upright = axis[0] == 0. && axis[1] == 0.;
    if (shape != "sphere" &&
        !(axisymmetric_stage && shape == "cylinder" && upright))
      throw InputError(where + " must be a sphere or, if the stage is "
                               "axisymmetric, an upright cylinder");
    auto centre = read_list(prm, "Center");
    centre.resize(3, 0.);
    for (const std::string &point : split(prm.get("Ignition points"), ';'))
    {
      const auto words = split(point, ',');
      for (unsigned int d = 0; d < words.size(); ++d)
        if (std::stod(words[d]) != centre[d] && !(axisymmetric_stage && d == 2))
          throw InputError(where + " must be ignited at its centre or, if the "
                                   "stage is axisymmetric, on its axis");
    }
  }

  /// Common centre of the charges of the scene, or of its balls of hot gas
  /// [m].
  template <int dim>
  dealii::Point<dim> centre_of_charge(ParameterHandler &scene,
                                      const bool axisymmetric_stage)
  {
    std::optional<std::vector<double>> centre;
    const auto meet = [&](const std::vector<double> &other) {
      if (centre && *centre != other)
        throw InputError("First stage: charges with different centres can "
                         "only be computed with First stage/Kind = none");
      centre = other;
    };
    const auto padded = [](std::vector<double> numbers) {
      numbers.resize(3, 0.);
      return numbers;
    };
    for (const std::string &name : item_names(scene, "Charges/Charge"))
    {
      const Section charges(scene, "Charges");
      const Section charge(scene, "Charge " + name);
      check_charge(scene, name, axisymmetric_stage);
      meet(padded(read_list(scene, "Center")));
    }
    const auto names = item_names(scene, "Initial state/Region");
    const Section section(scene, "Initial state");
    if (scene.get("Kind") == "regions")
      for (const std::string &name : names)
      {
        const Section region(scene, "Region " + name);
        if (scene.get("Shape") != "sphere")
          throw InputError("First stage: Initial state/Region " + name +
                           " must be a sphere");
        meet(padded(read_list(scene, "Center")));
      }
    if (!centre)
      throw InputError("First stage: the scene has no charge; \"Charges/Charge "
                       "<name>\" or Initial state/Kind = regions give one");
    dealii::Point<dim> result;
    for (unsigned int d = 0; d < dim; ++d)
      result[d] = (*centre)[d];
    return result;
  }

  void declare_hand_over(ParameterHandler &prm)
  {
    const UsedWith used("First stage/Kind not none");
    declare_selection(
      prm,
      "Hand over at",
      "auto",
      {"auto", "time", "radius"},
      "Criterion of the hand-over from the first stage to the scene: just "
      "before the front reaches the body, the ground or another side of the "
      "domain that is not a plane of symmetry of the charge, at a time, or "
      "at a radius of the front.");
    declare_double(prm,
                   "Time",
                   "0",
                   0.,
                   bounds::time,
                   "s",
                   used_with("First stage/Hand over at = time",
                             "Time of the hand-over, if at a time."));
    declare_double(
      prm,
      "Radius",
      "1",
      bounds::smallest_length,
      bounds::length,
      "m",
      used_with("First stage/Hand over at = radius",
                "Distance of the front from the charge's centre or axis "
                "at the hand-over, if at a radius."));
  }
} // namespace


void FirstStageParameters::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "First stage");
  declare_selection(prm,
                    "Kind",
                    "none",
                    {"none", "spherical", "axisymmetric"},
                    "Dimension of the first stage: none, spherical (1-D around "
                    "the centre of the charge), or axisymmetric (for 3-D, "
                    "around the vertical through the charge).");
  declare_double(prm,
                 "Cell size",
                 "0.001",
                 bounds::smallest_length,
                 bounds::length,
                 "m",
                 used_with("First stage/Kind not none",
                           "Edge of the subcells of the first stage, of the "
                           "smallest ones if it is axisymmetric."));
  declare_integer(
    prm,
    "Levels",
    "3",
    0,
    20,
    used_with("First stage/Kind = axisymmetric",
              "Refinement levels of an axisymmetric first stage; leaves "
              "of the finest level have subcells of the Cell size."));
  declare_double(
    prm,
    "Spherical cell size",
    "0",
    0.,
    bounds::length,
    "m",
    used_with("First stage/Kind = axisymmetric",
              "Edge of the subcells of a spherical stage before the "
              "axisymmetric one, until the front approaches the ground; "
              "0: no spherical stage."));
  declare_hand_over(prm);
}


void FirstStageParameters::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "First stage");
  kind = prm.get("Kind");
  cell_size = read_double(prm, "Cell size");
  levels = kind == "axisymmetric" ? read_unsigned(prm, "Levels") : 0;
  spherical_cell_size =
    kind == "axisymmetric" ? read_double(prm, "Spherical cell size") : 0.;
  criterion = prm.get("Hand over at");
  time = read_double(prm, "Time");
  radius = read_double(prm, "Radius");
}


std::string FirstStageParameters::late_hand_over(const double end_time) const
{
  return kind == "none" || criterion != "time" || time < end_time
           ? ""
           : "First stage/Time = " + brief(time) +
               " s is not before Time/End time = " + brief(end_time) + " s";
}


namespace
{
  /// Lower bound of the distance of the front when it meets the body: from the
  /// charge's centre or, if axisymmetric, from its axis [m].
  template <int dim>
  double distance_to_body(const gas::RigidBody &body,
                          const CoarseMesh<dim> &domain,
                          dealii::Point<dim> centre,
                          const std::string &stage)
  {
    if (body.empty())
      return std::numeric_limits<double>::max();
    if (stage != "axisymmetric")
      return body.value(centre);
    const unsigned int n = 1000;
    const double low = domain.lower_corner()[dim - 1];
    const double spacing = (domain.upper_corner()[dim - 1] - low) / n;
    double nearest = std::numeric_limits<double>::max();
    for (unsigned int i = 0; i < n; ++i)
    {
      centre[dim - 1] = low + (i + 0.5) * spacing;
      nearest = std::min(nearest, body.value(centre) - 0.5 * spacing);
    }
    return nearest;
  }


  /// @throws InputError if the front would meet a side or the body before the
  /// charge has burned in the stage
  template <int dim>
  void check_room_to_burn(const FirstStageParameters &parameters,
                          const FirstStageLayout<dim> &plan,
                          const double charge_extent)
  {
    // The front leaves the charge while its last subcells burn.
    constexpr double burning_cells = 8.;
    const double size = parameters.spherical_cell_size > 0.
                          ? parameters.spherical_cell_size
                          : parameters.cell_size;
    const double least = charge_extent + burning_cells * size;
    if (parameters.criterion != "auto" || charge_extent == 0. ||
        plan.nearest_side > least)
      return;
    throw InputError(
      "First stage/Kind = " + parameters.kind +
      ": the centre of the charge is " + brief(plan.nearest_side) +
      " m from the body or a side of the domain, and " + brief(least) +
      " m are needed to burn it, " + brief(charge_extent) +
      " m in radius, in cells of " + brief(size) +
      " m; move it, use smaller cells, or First stage/Kind = none");
  }


  /// Reduces FirstStageLayout::nearest_side to the distance to the body, after
  /// checks of charges and body.
  template <int dim>
  void meet_body(ParameterHandler &scene,
                 const CoarseMesh<dim> &domain,
                 const FirstStageParameters &parameters,
                 FirstStageLayout<dim> &plan)
  {
    GasMaterial material;
    material.parse_parameters(scene);
    gas::RigidBody body;
    body.parse_parameters(scene);
    gas::check_places(scene, material, domain, body);
    plan.nearest_side =
      std::min(plan.nearest_side,
               distance_to_body(body, domain, plan.centre, parameters.kind));
    // Trial runs for cost estimates have larger subcells and are not checked.
    if (body.is_required())
      check_room_to_burn(
        parameters, plan, gas::largest_charge_extent(scene, material, domain));
  }
} // namespace


template <int dim>
FirstStageLayout<dim>
make_first_stage_layout(ParameterHandler &scene,
                        const FirstStageParameters &parameters)
{
  CoarseMesh<dim> domain;
  domain.parse_parameters(scene);
  const bool axisymmetric_stage = parameters.kind == "axisymmetric";
  const bool axisymmetric_scene = domain.geometry() == Geometry::axisymmetric;
  if (!domain.is_axis_aligned() || dim == 1 ||
      !(axisymmetric_scene || dim == 3))
    throw InputError("First stage: only boxes in axisymmetric 2-D and in 3-D "
                     "can begin with one");
  if (axisymmetric_stage && dim != 3)
    throw InputError("First stage: Kind = axisymmetric needs 3 dimensions");

  FirstStageLayout<dim> plan;
  plan.centre = centre_of_charge<dim>(scene, axisymmetric_stage);
  const auto &lower = domain.lower_corner(), &upper = domain.upper_corner();
  double square = 0.;
  for (unsigned int d = 0; d < dim; ++d)
  {
    const double tolerance = 1e-9 * (upper[d] - lower[d]);
    const double below = plan.centre[d] - lower[d];
    const double above = upper[d] - plan.centre[d];
    if (std::min(below, above) < -tolerance)
      throw InputError("First stage: the charge must be in the domain");
    if (axisymmetric_stage && d == dim - 1)
    {
      const double side = std::min(below, above);
      plan.along_axis = side > tolerance ? side : std::max(below, above);
      continue;
    }
    square += std::pow(std::max(below, above), 2);
    if (std::min(below, above) > tolerance)
      plan.nearest_side = std::min({plan.nearest_side, below, above});
    else
    {
      plan.nearest_side = std::min(plan.nearest_side, std::max(below, above));
      if (axisymmetric_scene && d == 0)
        continue;
      plan.side[d] = below < above ? 1 : -1;
      plan.domain_fraction *= 0.5;
    }
  }
  meet_body(scene, domain, parameters, plan);
  if (axisymmetric_stage)
    plan.centre[dim - 1] = 0.;
  if (axisymmetric_scene && plan.centre[0] != 0.)
    throw InputError("First stage: the charge must be on the axis");
  plan.farthest = std::sqrt(square);
  plan.domain_radius = parameters.criterion == "auto" ? plan.nearest_side
                       : parameters.criterion == "radius"
                         ? 1.1 * parameters.radius
                         : plan.farthest;
  return plan;
}


template <int dim, int stage_dim>
void derive_first_stage(const ParameterHandler &scene,
                        const FirstStageParameters &parameters,
                        const FirstStageLayout<dim> &plan,
                        const std::vector<dealii::Point<stage_dim>> &probes,
                        ParameterHandler &stage)
{
  const auto values = parameter_values(scene);
  const double leaf =
    parameters.cell_size * std::stod(values.at("Method/Subcells"));
  const double coarse = leaf * std::pow(2., parameters.levels);
  Changes changes;
  const double n = std::ceil(plan.domain_radius / coarse * (1. - 1e-12)) + 1.;
  dealii::Point<stage_dim> lower, upper;
  upper[0] = n * coarse;
  std::string leaves = brief(n, 12);
  if constexpr (stage_dim == 2)
  {
    const auto low = split(values.at("Domain/Lower corner"), ',');
    const auto high = split(values.at("Domain/Upper corner"), ',');
    lower[1] = std::stod(low[2]);
    upper[1] = std::stod(high[2]);
    const double height = std::round((upper[1] - lower[1]) / coarse);
    leaves += ", " + brief(std::max(1., height), 12);
    for (const std::string side : {"low", "high"})
    {
      const std::string kind = values.at("Boundaries/z " + side);
      changes["Boundaries/y " + side] = kind == "symmetry" ? "wall" : kind;
    }
  }
  changes["Domain/Dimension"] = std::to_string(stage_dim);
  changes["Domain/Geometry"] = stage_dim == 1 ? "spherical" : "axisymmetric";
  changes["Domain/Lower corner"] = text_of(lower);
  changes["Domain/Upper corner"] = text_of(upper);
  changes["Domain/Coarse leaves"] = leaves;
  changes["Domain/Initial refinement"] = "0";
  changes["Domain/Periodic directions"] = "";
  changes["Boundaries/x low"] = "symmetry";
  changes["Boundaries/x high"] = "open";
  changes["Adaptation/Active"] = parameters.levels > 0 ? "true" : "false";
  changes["Adaptation/Smallest level"] = "0";
  changes["Adaptation/Largest level"] = std::to_string(parameters.levels);
  changes["Adaptation/Fine box levels"] = "0";
  changes["Method/Scheme"] = "finite volume";
  changes["Method/Precision"] = "double";
  changes["Rigid body/Kind"] = "none";
  changes["Loads/Record"] = "false";
  changes["Reference/Kind"] = "none";
  changes["Pictures/Planes"] = "";
  changes["Output/Profile file"] = "";
  std::vector<std::string> places;
  for (const auto &place : probes)
    places.push_back(text_of(place));
  changes["Probes/Points"] = join(places, ";");
  changes["Probes/Lines"] = "";
  changes["Probes/Gauge planes"] = "";
  changes["Probes/Injury"] = "false";
  set_stage_before(values, parameters, stage_dim, changes);
  move_charges(scene, values, stage_dim, changes);
  // Positions in the scene have no meaning in the stage.
  copy_entries(
    scene, changes, stage, {"Adaptation/Limit ", "Rigid body/Finer region "});
}


void derive_second_stage(const ParameterHandler &scene, ParameterHandler &stage)
{
  copy_entries(
    scene, {{"Initial state/Kind", "uniform"}}, stage, {"Charges/Charge "});
}


#define CONTRECOUP_INSTANTIATE(dim)                       \
  template FirstStageLayout<dim> make_first_stage_layout( \
    ParameterHandler &, const FirstStageParameters &)
#define CONTRECOUP_INSTANTIATE_STAGE(dim, stage_dim) \
  template void derive_first_stage(                  \
    const ParameterHandler &,                        \
    const FirstStageParameters &,                    \
    const FirstStageLayout<dim> &,                   \
    const std::vector<dealii::Point<stage_dim>> &,   \
    ParameterHandler &)

CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
CONTRECOUP_INSTANTIATE_STAGE(2, 1);
CONTRECOUP_INSTANTIATE_STAGE(3, 1);
CONTRECOUP_INSTANTIATE_STAGE(3, 2);
#undef CONTRECOUP_INSTANTIATE
#undef CONTRECOUP_INSTANTIATE_STAGE
} // namespace contrecoup::coupling
