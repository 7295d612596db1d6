// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/region.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::gas
{
namespace
{
  std::vector<std::vector<double>> read_centers(const ParameterHandler &prm)
  {
    std::vector<std::vector<double>> centers;
    for (const std::string &point : split(prm.get("Center"), ';'))
    {
      centers.emplace_back();
      for (const std::string &number : split(point, ','))
        centers.back().push_back(std::stod(number));
    }
    return centers;
  }


  /// Distances from a position to the nearest and the farthest point of a box
  /// [m].
  template <int dim>
  std::pair<double, double> distances(const std::vector<double> &place,
                                      const dealii::Point<dim> &lower,
                                      const dealii::Point<dim> &upper)
  {
    double near = 0., far = 0.;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double below = lower[d] - place[d], above = place[d] - upper[d];
      near += std::pow(std::max({below, above, 0.}), 2);
      far += std::pow(std::max(std::abs(below), std::abs(above)), 2);
    }
    return {std::sqrt(near), std::sqrt(far)};
  }
} // namespace


void Region::declare_parameters(ParameterHandler &prm, const std::string &rule)
{
  declare_selection(prm,
                    "Shape",
                    "everywhere",
                    {"everywhere", "ball", "outside of ball", "box"},
                    rule);
  declare_points(
    prm,
    "Center",
    "0, 0, 0",
    "m",
    used_with(
      "Shape = ball, outside of ball",
      "Centre of the ball, or centres of several balls of equal radius."));
  for (const std::string name : {"Lower corner", "Upper corner"})
    declare_list(
      prm,
      name,
      "0, 0, 0",
      1,
      3,
      -bounds::length,
      bounds::length,
      "m",
      used_with("Shape = box", "Position in the coordinates of the mesh."));
  declare_double(
    prm,
    "Radius",
    "1",
    0.,
    bounds::length,
    "m",
    used_with("Shape = ball, outside of ball",
              "Radius of the ball; of a growing ball, its initial radius."));
}


void Region::parse_parameters(ParameterHandler &prm)
{
  shape_ = prm.get("Shape");
  centers_ = read_centers(prm);
  radius_ = read_double(prm, "Radius");
  lower_ = read_list(prm, "Lower corner");
  upper_ = read_list(prm, "Upper corner");
}


void Region::check(const std::string &where, const unsigned int dim) const
{
  const bool is_short =
    std::any_of(centers_.begin(), centers_.end(), [&](const auto &center) {
      return center.size() < dim;
    });
  if ((has_ball() && (centers_.empty() || is_short)) ||
      (shape_ == "box" && std::min(lower_.size(), upper_.size()) < dim))
    throw InputError(
      where + ": " +
      (has_ball() ? "Center needs " : "Lower corner and Upper corner need ") +
      std::to_string(dim) + " numbers, one for each direction");
}


template <int dim>
bool Region::contains(const dealii::Point<dim> &place,
                      const double margin) const
{
  if (shape_ == "everywhere")
    return true;
  if (shape_ == "box")
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (place[d] < lower_[d] || place[d] > upper_[d])
        return false;
    return true;
  }
  const bool is_within =
    std::any_of(centers_.begin(),
                centers_.end(),
                [&](const std::vector<double> &coordinates) {
                  dealii::Point<dim> center;
                  for (unsigned int d = 0; d < dim; ++d)
                    center[d] = coordinates[d];
                  return place.distance(center) <= radius_ + margin;
                });
  return is_within == is_ball();
}


template <int dim>
bool Region::meets(const dealii::Point<dim> &lower,
                   const dealii::Point<dim> &upper) const
{
  if (shape_ == "everywhere")
    return true;
  if (shape_ == "box")
  {
    for (unsigned int d = 0; d < dim; ++d)
      if (upper[d] < lower_[d] || lower[d] > upper_[d])
        return false;
    return true;
  }
  const auto is_near = [&](const std::vector<double> &center) {
    return distances<dim>(center, lower, upper).first <= radius_;
  };
  const auto is_covered = [&](const std::vector<double> &center) {
    return distances<dim>(center, lower, upper).second <= radius_;
  };
  return is_ball() ? std::any_of(centers_.begin(), centers_.end(), is_near)
                   : std::none_of(centers_.begin(), centers_.end(), is_covered);
}


#define CONTRECOUP_INSTANTIATE(dim)                                         \
  template bool Region::contains(const dealii::Point<dim> &, double) const; \
  template bool Region::meets(const dealii::Point<dim> &,                   \
                              const dealii::Point<dim> &) const

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
