// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/mesh_description.h>
#include <contrecoup/base/system/exceptions.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Level set of an ellipsoid around the origin: below 1 inside.
  double ellipsoid(const dealii::Point<3> &place,
                   const std::array<double, 3> &semi_axes)
  {
    double sum = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      sum += std::pow(place[d] / semi_axes[d], 2);
    return sum;
  }
} // namespace


int MeshDescription::layer_at(const dealii::Point<3> &place) const
{
  if (body_)
  {
    const unsigned char part = body_->part_at(place);
    return part == LabelGrid::outside ? -1 : part;
  }
  if (kind_ == "half ball")
    return place[0] >= 0. && place.norm() < radius_ ? 0 : -1;
  if (kind_ == "box")
  {
    for (unsigned int d = 0; d < 3; ++d)
      if (place[d] < lower_[d] || place[d] > upper_[d])
        return -1;
    return 0;
  }
  for (unsigned int d = 0; d < 3; ++d)
    if (head_.is_halved()[d] && place[d] < 0.)
      return -1;
  const auto &axes = head_.semi_axes();
  for (std::size_t layer = 0; layer < axes.size(); ++layer)
    if (ellipsoid(place, axes[layer]) < 1.)
      return static_cast<int>(layer);
  return -1;
}


std::array<dealii::Point<3>, 2> MeshDescription::corners() const
{
  if (kind_ == "file" || !position_.empty())
    throw InputError("Mesh: particles need a box, a half ball or a layered "
                     "head, without Position x, y, z; choose one of these, or "
                     "Method = ale");
  if (kind_ == "box")
    return {{lower_, upper_}};
  if (body_)
  {
    const auto box = body_->surface()->bounding_box().get_boundary_points();
    return {{box.first, box.second}};
  }
  std::array<dealii::Point<3>, 2> result;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const bool is_ball = kind_ == "half ball";
    result[1][d] = is_ball ? radius_ : head_.semi_axes().back()[d];
    const bool is_halved = is_ball ? d == 0 : head_.is_halved()[d];
    result[0][d] = is_halved ? 0. : -result[1][d];
  }
  return result;
}


std::vector<MeshDescription::Shell> MeshDescription::shells() const
{
  std::vector<Shell> result;
  const auto &axes = head_.semi_axes();
  for (std::size_t i = 1; kind_ == "layered head" && i < axes.size(); ++i)
    result.push_back({head_.layers()[i].name,
                      axes[i][0] - axes[i - 1][0],
                      0.5 * (axes[i][0] + axes[i - 1][0]),
                      head_.cells_across()[i]});
  return result;
}


template <typename Choice>
std::array<bool, 6> MeshDescription::box_sides(const Choice &is_chosen) const
{
  std::array<bool, 6> result{};
  if (kind_ == "box")
    for (unsigned int i = 0; i < 6; ++i)
      result[i] = is_chosen(i);
  else if (kind_ == "half ball")
    result[0] = is_chosen(1);
  else if (kind_ == "layered head")
    for (unsigned int d = 0; d < 3; ++d)
      result[2 * d] = head_.is_halved()[d] && is_chosen(1 + d);
  return result;
}


std::array<bool, 6> MeshDescription::sides_at_rest() const
{
  for (const auto &wall : walls_)
    for (const double time : {0., 1e-6, 1e-3, 1.})
      if (wall.second(time) != 0.)
        throw InputError("Side " + side_names()[wall.first] +
                         "/Velocity: walls of particles are at rest");
  return box_sides([&](const auto id) { return walls_.count(id) == 1; });
}


std::array<bool, 6> MeshDescription::clamped_sides() const
{
  return box_sides([&](const auto id) { return clamped_.count(id) == 1; });
}
} // namespace contrecoup::ale
