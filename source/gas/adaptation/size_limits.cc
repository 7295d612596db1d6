// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selecting.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/adaptation/size_limits.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  void declare_when(ParameterHandler &prm)
  {
    declare_double(prm,
                   "From time",
                   "0",
                   -bounds::time,
                   bounds::time,
                   "s",
                   "Time when the limit begins to hold.");
    declare_double(prm,
                   "Until time",
                   "1e9",
                   -bounds::time,
                   bounds::time,
                   "s",
                   "Time when the limit ends; the default is after every run.");
  }


  void declare_where(ParameterHandler &prm)
  {
    Region::declare_parameters(
      prm,
      selecting(
        "Region of the limit, tested at the centres of leaves: the whole domain, "
        "within Radius of a Center, farther from all Centers, or between two "
        "corners. A leaf of any size that intersects a ball gets the ball's "
        "Smallest level and is exempt from a Largest level outside of the ball."));
    declare_double(prm,
                   "Radius growth",
                   "0",
                   -bounds::speed,
                   bounds::speed,
                   "m/s",
                   used_with("Shape = ball, outside of ball",
                             "Growth rate of Radius after From time."));
  }
} // namespace


void SizeLimits::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Limit *");
  declare_integer(prm,
                  "Smallest level",
                  "0",
                  0,
                  20,
                  "Smallest refinement level of leaves in the region.");
  declare_integer(prm,
                  "Largest level",
                  "20",
                  0,
                  20,
                  "Largest refinement level of leaves in the region.");
  declare_when(prm);
  declare_where(prm);
}


void SizeLimits::parse_parameters(ParameterHandler &prm, const unsigned int dim)
{
  limits_.clear();
  for (const std::string &name : item_names(prm, "Adaptation/Limit"))
  {
    const Section section(prm, "Limit " + name);
    Limit limit;
    limit.levels = {read_unsigned(prm, "Smallest level"),
                    read_unsigned(prm, "Largest level")};
    limit.from = read_double(prm, "From time");
    limit.until = read_double(prm, "Until time");
    limit.region.parse_parameters(prm);
    limit.growth = read_double(prm, "Radius growth");
    check(limit, "Adaptation/Limit " + name, dim);
    limits_.push_back(limit);
  }
}


void SizeLimits::check(const Limit &limit,
                       const std::string &where,
                       const unsigned int dim)
{
  if (limit.levels.min_level > limit.levels.max_level)
    throw InputError(where + ": Smallest level must not be larger than "
                             "Largest level");
  if (!(limit.from < limit.until))
    throw InputError(where + ": From time must be before Until time");
  limit.region.check(where, dim);
}


template <int dim>
bool SizeLimits::holds(const Limit &limit,
                       const dealii::Point<dim> &place,
                       const double time,
                       const double margin)
{
  if (time < limit.from || time >= limit.until)
    return false;
  return limit.region.contains(place,
                               limit.growth * (time - limit.from) + margin);
}


template <int dim>
SizeLimits::Levels SizeLimits::levels(const dealii::Point<dim> &place,
                                      const double time,
                                      const Levels &general,
                                      const double corner_distance) const
{
  Levels result = general;
  for (const Limit &limit : limits_)
  {
    const bool is_ball = limit.region.is_ball();
    if (holds(limit, place, time, is_ball ? corner_distance : 0.))
      result.min_level = std::max(result.min_level, limit.levels.min_level);
    if (holds(limit, place, time, is_ball ? 0. : corner_distance))
      result.max_level = std::min(result.max_level, limit.levels.max_level);
  }
  result.min_level = std::min(result.min_level, result.max_level);
  return result;
}


template SizeLimits::Levels SizeLimits::levels(const dealii::Point<1> &,
                                               double,
                                               const Levels &,
                                               double) const;
template SizeLimits::Levels SizeLimits::levels(const dealii::Point<2> &,
                                               double,
                                               const Levels &,
                                               double) const;
template SizeLimits::Levels SizeLimits::levels(const dealii::Point<3> &,
                                               double,
                                               const Levels &,
                                               double) const;
} // namespace contrecoup::gas
