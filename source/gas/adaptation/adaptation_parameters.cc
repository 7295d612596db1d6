// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/adaptation/adaptation_parameters.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  void declare_sensor(ParameterHandler &prm)
  {
    declare_selection(
      prm,
      "Sensor",
      "density and pressure",
      {"density and pressure", "pressure", "blast"},
      "What leaves are halved for: bends of density and "
      "pressure; of pressure alone, which lets the mesh coarsen "
      "at contacts, as in the hot core of an explosion; or, with "
      "blast, pressure fronts alone, also weak ones.");
    declare_double(prm,
                   "Refine above",
                   "0.5",
                   0.,
                   1.,
                   "-",
                   "Sensor value, a bend relative to the slope, above which a "
                   "leaf is halved.");
    declare_double(prm,
                   "Coarsen below",
                   "0.2",
                   0.,
                   1.,
                   "-",
                   "Sensor value below which sibling leaves are merged.");
    declare_double(prm,
                   "Noise",
                   "0.02",
                   1e-12,
                   1.,
                   "-",
                   "Relative differences between neighbouring points that "
                   "the sensor takes for noise; with the blast sensor the "
                   "relative strength of fronts for which it is one half.");
  }


  void declare_fine_box(ParameterHandler &prm)
  {
    declare_list(prm,
                 "Fine box lower corner",
                 "0, 0, 0",
                 1,
                 3,
                 -bounds::length,
                 bounds::length,
                 "m",
                 "Corner of smallest coordinates of a box that stays fine.");
    declare_list(prm,
                 "Fine box upper corner",
                 "1, 1, 1",
                 1,
                 3,
                 -bounds::length,
                 bounds::length,
                 "m",
                 "Its corner of largest coordinates.");
    declare_integer(prm,
                    "Fine box levels",
                    "0",
                    0,
                    20,
                    "Times that leaves with their centre in this box stay "
                    "halved beyond the initial refinement, also where the mesh "
                    "does not adapt; 0 for no such box.");
  }
} // namespace


void AdaptationParameters::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Adaptation");
  declare_bool(prm,
               "Active",
               "false",
               "Whether leaves are halved and merged during the run.");
  declare_integer(prm,
                  "Interval",
                  "5",
                  0,
                  1000000,
                  "Steps between adaptations; fewer where a front could else "
                  "cross the buffer in between, and 0 for as many as it "
                  "allows.");
  declare_integer(prm,
                  "Smallest level",
                  "0",
                  0,
                  20,
                  "Times that every coarse leaf stays halved at least.");
  declare_integer(prm,
                  "Largest level",
                  "0",
                  0,
                  20,
                  "Times that a coarse leaf may be halved at most.");
  declare_sensor(prm);
  declare_integer(prm,
                  "Buffer",
                  "1",
                  0,
                  10,
                  "Layers of leaves around marked ones that are halved "
                  "with them.");
  declare_selection(prm,
                    "Buffer side",
                    "all",
                    {"all", "ahead"},
                    "On which sides of marked leaves these layers are: on all, "
                    "or with the blast sensor only ahead, where the pressure "
                    "falls and fronts run to; it costs less.");
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
  if (!is_axis_aligned)
    throw InputError("Adaptation needs Domain/Mesh = box");
  if (coarsen > refine)
    throw InputError("Adaptation/Coarsen below must not be larger than "
                     "Adaptation/Refine above");
  if (buffer_only_ahead && sensor != Sensor::blast)
    throw InputError("Adaptation/Buffer side = ahead needs Adaptation/Sensor = "
                     "blast, which knows where fronts run to");
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
