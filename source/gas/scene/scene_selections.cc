// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameter_tree.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/selections.h>
#include <contrecoup/base/system/log.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/conditions/region.h>
#include <contrecoup/gas/scene/box_search.h>
#include <contrecoup/gas/scene/scene_selections.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace contrecoup::gas
{
namespace
{
  template <int dim>
  Box<dim> domain_of(const CoarseMesh<dim> &mesh)
  {
    return {mesh.lower_corner(), mesh.upper_corner()};
  }


  /// Whether a region of the initial state (current subsection) has volume in
  /// the domain.
  template <int dim>
  bool is_in_domain(const ParameterHandler &prm,
                    const std::string &where,
                    const Box<dim> &domain)
  {
    const std::string shape = prm.get("Shape");
    const dealii::Point<dim> center(read_vector<dim>(prm, "Center", where));
    const auto lower = read_vector<dim>(prm, "Lower corner", where);
    const auto upper = read_vector<dim>(prm, "Upper corner", where);
    const auto normal = read_direction<dim>(prm, "Normal", where);
    dealii::Point<dim> nearest, deepest;
    bool overlaps = true;
    for (unsigned int d = 0; d < dim; ++d)
    {
      nearest[d] = std::clamp(center[d], domain.lower[d], domain.upper[d]);
      deepest[d] = normal[d] > 0. ? domain.lower[d] : domain.upper[d];
      overlaps =
        overlaps && lower[d] < domain.upper[d] && upper[d] > domain.lower[d];
    }
    if (shape == "sphere")
      return nearest.distance(center) < read_double(prm, "Radius");
    return shape == "box" ? overlaps : normal * (deepest - center) < 0.;
  }


  template <int dim>
  void add_initial_regions(ParameterHandler &prm,
                           const Box<dim> &domain,
                           Selections &selections)
  {
    const auto names = item_names(prm, "Initial state/Region");
    const Section section(prm, "Initial state");
    if (prm.get("Kind") != "regions")
      return;
    for (const std::string &name : names)
    {
      const Section region(prm, "Region " + name);
      const std::string where = "Initial state/Region " + name;
      const std::string shape = prm.get("Shape");
      const std::string place =
        shape == "box"
          ? prm.get("Lower corner") + " to " + prm.get("Upper corner")
          : prm.get("Center");
      selections.add(where,
                     shape + " at " + place,
                     "gas",
                     is_in_domain(prm, where, domain) ? 1 : 0);
    }
  }


  /// Number of leaves of the initial refinement with their centre in the fine
  /// box (current subsection is "Adaptation").
  template <int dim>
  std::uint64_t n_in_fine_box(const ParameterHandler &prm,
                              const CoarseMesh<dim> &mesh)
  {
    const auto low = read_list(prm, "Fine box lower corner");
    const auto high = read_list(prm, "Fine box upper corner");
    std::uint64_t count = 1;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const double n = std::ldexp(mesh.coarse_cells(d),
                                  static_cast<int>(mesh.initial_refinement()));
      const double origin = mesh.lower_corner()[d];
      const double width = (mesh.upper_corner()[d] - origin) / n;
      const double first =
        std::max(0., std::ceil((low[d] - origin) / width - 0.5 - 1e-9));
      const double last =
        std::min(n - 1., std::floor((high[d] - origin) / width - 0.5 + 1e-9));
      count *= last < first ? 0U : std::uint64_t(last - first + 1.);
    }
    return count;
  }


  template <int dim>
  void add_fine_box(ParameterHandler &prm,
                    const CoarseMesh<dim> &mesh,
                    Selections &selections)
  {
    const Section section(prm, "Adaptation");
    if (read_unsigned(prm, "Fine box levels") > 0)
      selections.add("Adaptation/Fine box lower corner and upper corner",
                     prm.get("Fine box lower corner") + " to " +
                       prm.get("Fine box upper corner"),
                     "centre of a leaf",
                     n_in_fine_box(prm, mesh));
  }


  template <int dim>
  void add_size_limits(ParameterHandler &prm,
                       const Box<dim> &domain,
                       const double end_time,
                       Selections &selections)
  {
    for (const std::string &name : item_names(prm, "Adaptation/Limit"))
    {
      const Section section(prm, "Adaptation");
      const Section limit(prm, "Limit " + name);
      const double from = read_double(prm, "From time");
      if (from >= end_time)
        log_line("Adaptation/Limit " + name + "/From time = " + brief(from) +
                 " s is not before Time/End time = " + brief(end_time) +
                 " s: the limit never holds");
      Region region;
      region.parse_parameters(prm);
      // A ball that grows reaches farther; a shrinking one counts as it begins.
      const double growth =
        std::max(0., read_double(prm, "Radius growth")) *
        std::max(0., std::min(read_double(prm, "Until time"), end_time) - from);
      Box<dim> reach = domain;
      for (unsigned int d = 0; d < dim && region.is_ball(); ++d)
      {
        reach.lower[d] -= growth;
        reach.upper[d] += growth;
      }
      selections.add("Adaptation/Limit " + name,
                     prm.get("Shape"),
                     "leaf",
                     region.meets(reach.lower, reach.upper) ? 1 : 0);
    }
  }


  /// The part of a domain that holds a region (current subsection); none where
  /// they do not meet. It holds all of several balls.
  template <int dim>
  std::optional<Box<dim>> bounds_of(const ParameterHandler &prm,
                                    const Box<dim> &domain)
  {
    const std::string shape = prm.get("Shape");
    if (shape != "box" && shape != "ball")
      return domain;
    const double radius = shape == "ball" ? read_double(prm, "Radius") : 0.;
    std::vector<dealii::Point<dim>> corners;
    for (const std::string &text :
         split(shape == "ball"
                 ? prm.get("Center")
                 : prm.get("Lower corner") + ";" + prm.get("Upper corner"),
               ';'))
    {
      const auto words = split(text, ',');
      corners.emplace_back();
      for (unsigned int d = 0; d < dim; ++d)
        corners.back()[d] = std::stod(words[d]);
    }
    Box<dim> box = domain;
    for (unsigned int d = 0; d < dim; ++d)
    {
      const auto [low, high] = std::minmax_element(
        corners.begin(), corners.end(), [d](const auto &a, const auto &b) {
          return a[d] < b[d];
        });
      box.lower[d] = std::max(domain.lower[d], (*low)[d] - radius);
      box.upper[d] = std::min(domain.upper[d], (*high)[d] + radius);
      if (box.lower[d] > box.upper[d])
        return {};
    }
    return box;
  }


  template <int dim>
  void add_finer_regions(ParameterHandler &prm,
                         const Box<dim> &domain,
                         const RigidBody &body,
                         Selections &selections)
  {
    const auto value = [&](const dealii::Point<dim> &x) {
      return body.value(x);
    };
    for (const std::string &name : item_names(prm, "Rigid body/Finer region"))
    {
      const Section section(prm, "Rigid body");
      const Section finer(prm, "Finer region " + name);
      const auto box = bounds_of(prm, domain);
      const bool has_body =
        box && !find_below(*box, 0., domain.radius() / 128., value).is_nowhere;
      selections.add("Rigid body/Finer region " + name,
                     prm.get("Shape"),
                     "place of the body",
                     has_body ? 1 : 0);
    }
  }
} // namespace


template <int dim>
void check_selections(ParameterHandler &prm,
                      const CoarseMesh<dim> &mesh,
                      const RigidBody &body)
{
  // Trial runs for cost estimates have larger leaves.
  if (!mesh.is_axis_aligned() || !body.is_required())
    return;
  const Box<dim> domain = domain_of(mesh);
  double end_time = 0.;
  {
    const Section section(prm, "Time");
    end_time = read_double(prm, "End time");
  }
  Selections selections;
  add_initial_regions(prm, domain, selections);
  add_fine_box(prm, mesh, selections);
  add_size_limits(prm, domain, end_time, selections);
  if (!body.empty())
    add_finer_regions(prm, domain, body, selections);
  std::vector<std::string> low, high;
  for (unsigned int d = 0; d < dim; ++d)
  {
    low.push_back(brief(domain.lower[d]));
    high.push_back(brief(domain.upper[d]));
  }
  selections.require_some(MPI_COMM_SELF,
                          "the domain reaches from " + join(low, ", ") +
                            " to " + join(high, ", ") + " m");
}


template void
check_selections(ParameterHandler &, const CoarseMesh<1> &, const RigidBody &);
template void
check_selections(ParameterHandler &, const CoarseMesh<2> &, const RigidBody &);
template void
check_selections(ParameterHandler &, const CoarseMesh<3> &, const RigidBody &);
} // namespace contrecoup::gas
