// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/adaptation/adaptation_parameters.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  void declare_sensor(ParameterHandler &prm)
  {
    const UsedWith used("Adaptation/Active = true");
    declare_selection(
      prm,
      "Sensor",
      "density and pressure",
      {"density and pressure", "pressure", "blast"},
      "Sensor for refinement: curvature of density and pressure; of pressure "
      "only, so that the mesh coarsens at contacts, as in the hot core of an "
      "explosion; or, with blast, pressure fronts only, including weak ones.");
    declare_double(prm,
                   "Refine above",
                   "0.5",
                   0.,
                   1.,
                   "-",
                   "Sensor value above which a leaf is refined.");
    declare_double(prm,
                   "Coarsen below",
                   "0.2",
                   0.,
                   1.,
                   "-",
                   "Sensor value below which sibling leaves are coarsened.");
    declare_double(prm,
                   "Noise",
                   "0.02",
                   1e-12,
                   1.,
                   "-",
                   "Relative differences between neighbouring points that "
                   "the sensor treats as noise; of the blast sensor, the "
                   "relative strength of a front for which it is one half.");
  }


  void declare_fine_box(ParameterHandler &prm)
  {
    declare_list(
      prm,
      "Fine box lower corner",
      "0, 0, 0",
      1,
      3,
      -bounds::length,
      bounds::length,
      "m",
      used_with(
        "Adaptation/Fine box levels not 0",
        selecting("Corner with the smallest coordinates of a box with a "
                  "smallest refinement level.")));
    declare_list(
      prm,
      "Fine box upper corner",
      "1, 1, 1",
      1,
      3,
      -bounds::length,
      bounds::length,
      "m",
      used_with("Adaptation/Fine box levels not 0",
                selecting("Corner with the largest coordinates of this box.")));
    declare_integer(prm,
                    "Fine box levels",
                    "0",
                    0,
                    20,
                    "Smallest refinement level, above the initial "
                    "refinement, of leaves with their centre in this box, "
                    "on any mesh, also if it does not adapt; 0: no such box.");
  }
} // namespace


void AdaptationParameters::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Adaptation");
  declare_bool(prm,
               "Active",
               "false",
               "Whether leaves are refined and coarsened during the run; "
               "needs Domain/Mesh = box.");
  {
    const UsedWith used("Adaptation/Active = true");
    declare_integer(prm,
                    "Interval",
                    "5",
                    0,
                    1000000,
                    "Largest number of steps between adaptations, fewer if a "
                    "front could otherwise cross the AMR buffer; 0: only the "
                    "AMR buffer limits this number.");
  }
  declare_integer(prm,
                  "Smallest level",
                  "0",
                  0,
                  20,
                  "Smallest refinement level of the leaves.");
  declare_integer(prm,
                  "Largest level",
                  "0",
                  0,
                  20,
                  "Largest refinement level of the leaves.");
  declare_sensor(prm);
  {
    const UsedWith used("Adaptation/Active = true");
    declare_integer(prm,
                    "Buffer",
                    "1",
                    0,
                    10,
                    "AMR buffer width: layers of leaves around marked leaves "
                    "that are refined with them.");
    declare_selection(prm,
                      "Buffer side",
                      "all",
                      {"all", "ahead"},
                      "Sides of marked leaves with the AMR buffer: all, or "
                      "(blast sensor only) only ahead, towards falling "
                      "pressure, which costs less.");
  }
  declare_fine_box(prm);
  SizeLimits::declare_parameters(prm);
}


void AdaptationParameters::parse_parameters(
  ParameterHandler &prm,
  const unsigned int dim,
  const unsigned int initial_refinement,
  const unsigned int n_points,
  const bool is_finite_volume,
  const bool is_axis_aligned)
{
  const Section section(prm, "Adaptation");
  active = prm.get_bool("Active");
  interval = read_unsigned(prm, "Interval");
  min_level = read_unsigned(prm, "Smallest level");
  max_level = std::max(read_unsigned(prm, "Largest level"), initial_refinement);
  refine = read_double(prm, "Refine above");
  coarsen = read_double(prm, "Coarsen below");
  noise = read_double(prm, "Noise");
  const std::string name = prm.get("Sensor");
  sensor = name == "blast"      ? Sensor::blast
           : name == "pressure" ? Sensor::pressure_jump
                                : Sensor::jump;
  buffer = read_unsigned(prm, "Buffer");
  buffer_only_ahead = prm.get("Buffer side") == "ahead";
  fine_lower = read_list(prm, "Fine box lower corner");
  fine_upper = read_list(prm, "Fine box upper corner");
  const unsigned int fine_levels = read_unsigned(prm, "Fine box levels");
  fine_level = fine_levels > 0 ? initial_refinement + fine_levels : 0;
  max_level = std::max(max_level, fine_level);
  limits.parse_parameters(prm, dim);
  if (active || fine_level > 0)
    check(dim, n_points, is_finite_volume, is_axis_aligned);
}


void AdaptationParameters::check(const unsigned int dim,
                                 const unsigned int n_points,
                                 const bool is_finite_volume,
                                 const bool is_axis_aligned) const
{
  if (is_finite_volume && n_points % 2 == 1 && n_points != 1)
    throw InputError("Adaptation needs Method/Subcells = 1 or an even number, "
                     "not " +
                     std::to_string(n_points));
  if (active && !is_axis_aligned)
    throw InputError("Adaptation/Active = true needs Domain/Mesh = box; other "
                     "meshes can be refined before the run, by "
                     "Adaptation/Fine box levels");
  if (coarsen > refine)
    throw InputError("Adaptation/Coarsen below must not be larger than "
                     "Adaptation/Refine above");
  if (buffer_only_ahead && sensor != Sensor::blast)
    throw InputError("Adaptation/Buffer side = ahead needs Adaptation/Sensor = "
                     "blast, which detects the direction of fronts");
  if (min_level > max_level)
    throw InputError("Adaptation/Smallest level must not be larger than "
                     "Adaptation/Largest level");
  if (fine_level > 0 && (fine_lower.size() < dim || fine_upper.size() < dim))
    throw InputError("Adaptation/Fine box lower corner and upper corner need " +
                     std::to_string(dim) + " numbers, one for each direction");
}


void AdaptationParameters::find_buffer_steps(const double courant_number,
                                             const unsigned int dim,
                                             const unsigned int n_points)
{
  // Upper bound of the shock speed over |u| + dim c behind the shock, for
  // adiabatic exponents of at least 1.2 and any shock strength.
  const double shock_speed_ratio = dim == 1 ? 1. : (dim == 2 ? 0.65 : 0.54);
  // The front may be at the edge of a marked leaf, and the sensor detects it
  // one point ahead.
  const double margin = buffer - 1. / n_points;
  buffer_steps = std::max(1., margin / (courant_number * shock_speed_ratio));
}
} // namespace contrecoup::gas
