// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/layered_head.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>

#include <deal.II/base/numbers.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Ratio of cell edges in the inner cube to those at the brain surface.
  constexpr double cube_part = 0.5;

  /// Slope of the sides of a wedge. The relative error of the kinetic energy
  /// of radial motion is the square of the slope.
  constexpr double wedge_slope = 0.03;
} // namespace


void LayeredHead::declare_parameters(ParameterHandler &prm)
{
  declare_symmetry_planes(prm);
  const UsedWith used("Mesh/Kind = layered head");
  declare_list(prm,
               "Semi-axes",
               "0.07, 0.07, 0.07",
               3,
               3,
               1e-6,
               1e3,
               "m",
               "Semi-axes of the brain of a layered head.");
  for (const auto &[name, value] :
       {std::pair<std::string, std::string>("CSF", "0.004"),
        {"Skull", "0.007"},
        {"Scalp", "0"}})
  {
    declare_double(prm,
                   name + " thickness",
                   value,
                   0.,
                   1e3,
                   "m",
                   name == "Scalp" ? "0: no scalp."
                                   : "Positive, of a layered head.");
    declare_integer(prm,
                    name + " cells",
                    "2",
                    1,
                    1000,
                    "Cells across this layer, 1 to 1000.");
  }
  declare_double(
    prm,
    "Cell size",
    "0.004",
    1e-6,
    1e3,
    "m",
    "Approximate cell size at the brain surface; inner cells are smaller.");
}


void LayeredHead::add_layer(const std::string &name,
                            const double thickness,
                            const unsigned int cells)
{
  auto axes_of_layer = ball_.semi_axes.back();
  for (double &axis : axes_of_layer)
    axis += thickness;
  ball_.semi_axes.push_back(axes_of_layer);
  ball_.cells_across.push_back(cells);
  layers_.push_back({name, {}});
}


void LayeredHead::parse_parameters(ParameterHandler &prm)
{
  const auto brain = read_point<3>(prm, "Semi-axes");
  ball_ = LayeredBall();
  ball_.semi_axes = {{{brain[0], brain[1], brain[2]}}};
  layers_ = {{"brain", {}}};
  const double size = read_double(prm, "Cell size");
  const double smallest = std::min({brain[0], brain[1], brain[2]}),
               largest = std::max({brain[0], brain[1], brain[2]});
  if (size > smallest)
    throw InputError("Mesh/Cell size must be below Mesh/Semi-axes");
  // A quarter of the circumference has the cells of two cube edges.
  ball_.cells_along_cube =
    2 * static_cast<unsigned int>(std::max(
          1., std::round(0.25 * dealii::numbers::PI * largest / size)));
  ball_.cells_across = {static_cast<unsigned int>(
    std::max(1., std::round(0.55 * smallest / size)))};
  for (const auto &[layer, name] :
       {std::pair<std::string, std::string>("csf", "CSF"),
        {"skull", "Skull"},
        {"scalp", "Scalp"}})
  {
    const double thickness = read_double(prm, name + " thickness");
    if (thickness > 0.)
      add_layer(layer, thickness, read_unsigned(prm, name + " cells"));
    else if (layer != "scalp")
      throw InputError("Mesh/" + name + " thickness must be above 0");
  }
  ball_.is_halved = read_symmetry_planes(prm);
  find_wedge(prm);
}


void LayeredHead::find_wedge(ParameterHandler &prm)
{
  ball_.wedge_axis = read_wedge_axis(prm);
  ball_.wedge_slope = wedge_slope;
  if (ball_.wedge_axis > 2)
    return;
  const unsigned int a = ball_.across_middle(), b = ball_.normal_to_middle();
  const auto &brain = ball_.semi_axes.front();
  if (brain[a] != brain[b])
    throw InputError(
      "Mesh/Wedge axis = " + std::string(1, "xyz"[ball_.wedge_axis]) +
      " needs equal Mesh/Semi-axes along " + std::string(1, "xyz"[a]) +
      " and " + std::string(1, "xyz"[b]) + ", which are " + brief(brain[a]) +
      " and " + brief(brain[b]) + " m");
}


double LayeredHead::computed_fraction() const
{
  const double fraction = fraction_within(ball_.is_halved);
  // The straight wedge replaces a quarter of the circumference.
  return ball_.wedge_axis > 2
           ? fraction
           : 4. * fraction * ball_.wedge_slope / dealii::numbers::PI;
}


double LayeredHead::n_cells_across() const
{
  double across = 0.;
  for (const unsigned int cells : ball_.cells_across)
    across += cells;
  return across;
}


double LayeredHead::n_cells_of_whole() const
{
  const double n = ball_.cells_along_cube;
  return n * n * n + 6. * n * n * n_cells_across();
}


double LayeredHead::n_cells_of_wedge(const bool is_halved) const
{
  const double n = ball_.cells_along_cube;
  return (is_halved ? 0.5 : 1.) * (0.5 * n * n + 2. * n * n_cells_across());
}


double LayeredHead::n_cells() const
{
  return ball_.wedge_axis > 2
           ? computed_fraction() * n_cells_of_whole()
           : n_cells_of_wedge(ball_.is_halved[ball_.wedge_axis]);
}


double LayeredHead::cell_size() const
{
  const auto &brain = ball_.semi_axes.front();
  double size = cube_part * 0.5 * dealii::numbers::PI *
                std::min({brain[0], brain[1], brain[2]}) /
                ball_.cells_along_cube;
  for (std::size_t i = 1; i < ball_.semi_axes.size(); ++i)
    size = std::min(size,
                    (ball_.semi_axes[i][0] - ball_.semi_axes[i - 1][0]) /
                      ball_.cells_across[i]);
  return size;
}
} // namespace contrecoup::ale
