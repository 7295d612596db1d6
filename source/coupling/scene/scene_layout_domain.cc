// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/coupling/scene/scene_layout.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::coupling
{
using dealii::Point;

namespace
{
  double product_of(const std::array<std::array<double, 2>, 3> &leaves)
  {
    double product = 1.;
    for (const auto &[below, above] : leaves)
      product *= below + above;
    return product;
  }
} // namespace


std::array<std::array<double, 2>, 3>
SceneLayout::leaves_for(const double front_distance) const
{
  // Expected fronts are some per cent off.
  constexpr double margin = 1.03;
  const double path = margin * front_distance;
  dealii::BoundingBox<3> watched = body;
  if (probe)
    watched.merge_with({{*probe, *probe}});
  for (const Point<3> &place : watched_)
    watched.merge_with({{place, place}});
  // Smallest distance of an open side along direction d: the charge's mirror
  // image in it is farther from body and probe than the front travels, and one
  // leaf fits between it and body and charge.
  const auto side = [&](const unsigned int d, const double sign) {
    const double farthest =
      sign > 0. ? watched.upper_bound(d) : -watched.lower_bound(d);
    const double place = sign * charge[d];
    double across = 0.;
    for (unsigned int e = 0; e < 3; ++e)
      if (e != d)
        across += std::pow(std::max({0.,
                                     watched.lower_bound(e) - charge[e],
                                     charge[e] - watched.upper_bound(e)}),
                           2);
    const double along = std::sqrt(std::max(0., path * path - across));
    return std::max(0.5 * (along + farthest + place),
                    std::max(farthest, place) + leaf);
  };
  std::array<std::array<double, 2>, 3> leaves;
  for (unsigned int d = 0; d < 3; ++d)
  {
    leaves[d] = {
      {std::ceil(side(d, -1.) / leaf), std::ceil(side(d, 1.) / leaf)}};
    if (d == 2 || (d == 1 && is_half))
      leaves[d][0] = 0.;
  }
  return leaves;
}


void SceneLayout::size_domain(const SceneParameters &scene,
                              const ExpectedBlast &blast)
{
  const auto fits = [&](const double radius) {
    return product_of(leaves_for(radius)) <= max_leaves;
  };
  const std::string many =
    " leaves of " + brief(leaf) + " m, more than " + brief(max_leaves);
  if (!fits(0.))
    throw InputError(
      std::string(scene.place ? "Charge/Place" : "Charge/Distance and Height") +
      ": charge and body are " + brief(distance) +
      " m apart; a domain with both would have " +
      brief(product_of(leaves_for(0.)), 2) + many);
  if (!fits(front_distance))
  {
    double low = 0., high = front_distance;
    for (unsigned int i = 0; i < 200; ++i)
    {
      const double middle = 0.5 * (low + high);
      (fits(middle) ? low : high) = middle;
    }
    const double latest = blast.arrival(low);
    throw InputError(
      "Scene/End time = " + brief(scene.end_time) + " s: the front travels " +
      brief(front_distance, 2) +
      " m until then; a domain without reflections from open sides at the "
      "body would have " +
      brief(product_of(leaves_for(front_distance)), 2) + many + "; " +
      (latest > arrival
         ? "from " + brief(arrival) + " to " + brief(latest, 3) +
             " s are possible"
         : "none is possible, for the blast reaches the body at " +
             brief(arrival) + " s; a smaller distance or body is needed"));
  }
  set_corners();
  watch(scene.gauges);
}


void SceneLayout::set_corners()
{
  const auto leaves = leaves_for(front_distance);
  for (unsigned int d = 0; d < 3; ++d)
  {
    lower[d] = 0. - leaves[d][0] * leaf; // not -0
    upper[d] = leaves[d][1] * leaf;
    n_leaves[d] = static_cast<unsigned int>(leaves[d][0] + leaves[d][1]);
  }
}


void SceneLayout::watch(const std::vector<GaugeRaster> &gauges)
{
  // The domain for one gauge may hold the next one, too.
  std::size_t n_watched = 0;
  do
  {
    n_watched = watched_.size();
    watched_.clear();
    const dealii::BoundingBox<3> domain({lower, upper});
    for (const GaugeRaster &gauge : gauges)
      if (domain.point_inside(gauge.begin) && domain.point_inside(gauge.end))
        for (const Point<3> &corner : {gauge.begin, gauge.end})
          watched_.push_back(corner);
    if (product_of(leaves_for(front_distance)) > max_leaves)
      watched_.clear();
    set_corners();
  } while (watched_.size() > n_watched);
}


void SceneLayout::take_domain(const SceneParameters &scene)
{
  lower = own_.lower.value_or(lower);
  upper = own_.upper.value_or(upper);
  for (const unsigned int d : {1U, 2U})
    if ((d == 2 ? own_.has_ground : is_half) && lower[d] != 0.)
      throw InputError(
        "Blast/Domain/Lower corner = " + coordinates(lower) + ": its " +
        std::string(1, "xyz"[d]) + " must be 0, where the " +
        (d == 2 ? "ground is"
                : "plane of symmetry is (Scene/Symmetry = none has none)"));
  leaf_edge = 0.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double side = upper[d] - lower[d];
    n_leaves[d] = own_.n_leaves ? std::max(1U, (*own_.n_leaves)[d])
                                : static_cast<unsigned int>(std::clamp(
                                    std::ceil(side / leaf - 1e-9), 1., 1e9));
    leaf_edge = std::max(leaf_edge, side / n_leaves[d]);
  }
  if (double(n_leaves[0]) * n_leaves[1] * n_leaves[2] > max_leaves)
    throw InputError("Blast/Domain: from " + coordinates(lower) + " to " +
                     coordinates(upper) + " m it has more than " +
                     brief(max_leaves) + " leaves of " + brief(leaf) + " m");
  choose_levels(scene);
  check_charge(scene);
}


double SceneLayout::fireball_radius(const SceneParameters &scene) const
{
  return 0.685 * std::cbrt(scene.mass);
}
} // namespace contrecoup::coupling
