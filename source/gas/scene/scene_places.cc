// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/scene/box_search.h>
#include <contrecoup/gas/scene/scene_bursts.h>
#include <contrecoup/gas/scene/scene_places.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace contrecoup::gas
{
namespace
{
  const std::vector<std::string> sides =
    {"x low", "x high", "y low", "y high", "z low", "z high"};

  unsigned int subcells_of(ParameterHandler &prm)
  {
    const Section section(prm, "Method");
    return read_unsigned(prm, "Subcells");
  }


  /// Fraction of a charge within the domain, from samples.
  template <int dim>
  double fraction_within(const Charge<dim> &charge, const CoarseMesh<dim> &mesh)
  {
    const dealii::QIterated<dim> grid(dealii::QMidpoint<1>(), 40);
    const auto [lower, upper] = charge.bounds();
    const unsigned int power = radial_exponent(mesh.geometry());
    double all = 0., within = 0.;
    for (const auto &x : grid.get_points())
    {
      dealii::Point<dim> point;
      bool is_within = true;
      for (unsigned int d = 0; d < dim; ++d)
      {
        point[d] = lower[d] + x[d] * (upper[d] - lower[d]);
        is_within = is_within && point[d] > mesh.lower_corner()[d] &&
                    point[d] < mesh.upper_corner()[d];
      }
      // In axisymmetric geometry the charge extends to both sides of the axis.
      if (power > 0 && point[0] < 0.)
        continue;
      if (charge.signed_distance(point) >= 0.)
        continue;
      const double weight = std::pow(point[0], power);
      all += weight;
      within += is_within ? weight : 0.;
    }
    return all > 0. ? within / all : 0.;
  }


  /// Distance of a charge's centre from a side of the domain, positive inside
  /// [m].
  template <int dim>
  double depth_of(const Charge<dim> &charge,
                  const CoarseMesh<dim> &mesh,
                  const unsigned int side)
  {
    const unsigned int d = side / 2;
    const auto [lower, upper] = charge.bounds();
    const double middle = 0.5 * (lower[d] + upper[d]);
    return side % 2 == 0 ? middle - mesh.lower_corner()[d]
                         : mesh.upper_corner()[d] - middle;
  }


  /// The first side that cuts a charge other than through its centre, and the
  /// smallest allowed distance of the centre from it.
  template <int dim>
  std::string name_cut(const Charge<dim> &charge, const CoarseMesh<dim> &mesh)
  {
    const auto [lower, upper] = charge.bounds();
    for (unsigned int side = 0; side < 2 * dim; ++side)
    {
      const unsigned int d = side / 2;
      if (side == 0 && mesh.geometry() != Geometry::plane)
        continue;
      const double half = 0.5 * (upper[d] - lower[d]);
      const double depth = depth_of(charge, mesh, side);
      if (depth < half * (1. - 1e-12) && std::abs(depth) > half * 1e-12)
        return "side " + sides[side] + " of the domain, " +
               brief(std::abs(depth)) + " m from its centre, cuts it; " +
               "Center must be at least " + brief(half) +
               " m from that side, or on it";
    }
    return "the domain cuts it through its centre, but not in a plane of "
           "symmetry; move Center inwards or choose a symmetric shape";
  }


  template <int dim>
  void check_within(const NamedCharge<dim> &one, const CoarseMesh<dim> &mesh)
  {
    if (one.charge.fraction_within(mesh))
      return;
    double fraction = fraction_within(one.charge, mesh);
    const auto [lower, upper] = one.charge.bounds();
    if (fraction == 0.)
      throw InputError(one.where + ": the charge, from " + coordinates(lower) +
                       " to " + coordinates(upper) +
                       " m, lies outside of the domain, from " +
                       coordinates(mesh.lower_corner()) + " to " +
                       coordinates(mesh.upper_corner()) + " m");
    // Fraction of the charge that planes of symmetry through its centre leave.
    for (unsigned int side = 0; side < 2 * dim; ++side)
      if (!(side == 0 && mesh.geometry() != Geometry::plane) &&
          std::abs(depth_of(one.charge, mesh, side)) <
            1e-12 * one.charge.smallest_size())
        fraction *= 2.;
    if (one.mass > 0.)
      throw InputError(
        one.where + ": of Mass = " + brief(one.mass) +
        " kg the domain would keep " + brief(fraction, 2) + ": " +
        name_cut(one.charge, mesh) +
        "; with Mass = 0 and given sizes only the volume within the domain "
        "counts");
  }


  /// Gap between a charge and the body if it is below @p least [m].
  /// Shape::value() does not suffice, since it may be less than the distance.
  std::optional<double>
  narrow_gap(const Charge<3> &charge, const RigidBody &body, const double least)
  {
    const auto [lower, upper] = charge.bounds();
    Box<3> box{lower, upper};
    for (unsigned int d = 0; d < 3; ++d)
    {
      box.lower[d] -= least;
      box.upper[d] += least;
    }
    const auto farther = [&](const dealii::Point<3> &x) {
      return std::max(charge.signed_distance(x), body.value(x));
    };
    std::optional<double> gap;
    double bound = 0.5 * least;
    const double tolerance =
      std::max(0.01 * charge.smallest_size(), 0.1 * bound);
    for (unsigned int i = 0; i < 8; ++i)
    {
      const auto found = find_below(box, bound, tolerance, farther);
      if (!found.place)
        return gap;
      const double to_surface =
        charge.signed_distance(body.project(*found.place));
      if (to_surface < least)
        gap = std::max(0., std::min(to_surface, gap.value_or(to_surface)));
      bound *= 0.5;
    }
    return gap;
  }


  template <int dim>
  void check_apart(const NamedCharge<dim> &one,
                   const RigidBody &body,
                   const CoarseMesh<dim> &mesh,
                   const double cell)
  {
    const auto [lower, upper] = one.charge.bounds();
    const auto inside = [&](const dealii::Point<dim> &x) {
      double beyond = -std::numeric_limits<double>::infinity();
      for (unsigned int d = 0; d < dim; ++d)
        beyond = std::max({beyond,
                           mesh.lower_corner()[d] - x[d],
                           x[d] - mesh.upper_corner()[d]});
      return std::max({one.charge.signed_distance(x), body.value(x), beyond});
    };
    const double tolerance = 0.01 * one.charge.smallest_size();
    const auto common =
      find_below(Box<dim>{lower, upper}, -tolerance, tolerance, inside);
    if (common.place)
      throw InputError(one.where +
                       ": the charge and the rigid body overlap around " +
                       coordinates(*common.place) +
                       " m; change the charge's Center or Body/Shift");
    if constexpr (dim == 3)
      if (const auto gap = narrow_gap(one.charge, body, cell))
        throw InputError(
          one.where + ": its surface is " + brief(*gap, 2) +
          " m from the rigid body, less than the cell size there, " +
          brief(cell, 3) + " m; move its Center away by " +
          brief(cell - *gap, 2) + " m or raise Rigid body/Levels" +
          (*gap > 0. ? " by " + brief(std::ceil(std::log2(cell / *gap)), 3)
                     : ""));
  }


  template <int dim>
  void check_body(const RigidBody &body, const CoarseMesh<dim> &mesh)
  {
    const Box<dim> domain{mesh.lower_corner(), mesh.upper_corner()};
    const auto value = [&](const dealii::Point<dim> &x) {
      return body.value(x);
    };
    const double tolerance = domain.radius() / 128.;
    if (!find_below(domain, 0., tolerance, value).is_nowhere)
      return;
    double low = 0., high = std::max(0., body.value(domain.center()));
    for (unsigned int i = 0; i < 12; ++i)
    {
      const double middle = 0.5 * (low + high);
      (find_below(domain, middle, tolerance, value).place ? high : low) =
        middle;
    }
    throw InputError("Rigid body: it lies outside of the domain, from " +
                     coordinates(domain.lower) + " to " +
                     coordinates(domain.upper) + " m, at least " +
                     brief(high, 2) +
                     " m away from it; change Body/Shift or the domain's "
                     "corners");
  }


  /// Whether a side of the domain is a plane of symmetry of the body, from
  /// samples on both sides of it.
  template <int dim>
  bool is_symmetric(const RigidBody &body,
                    const CoarseMesh<dim> &mesh,
                    const unsigned int side,
                    const double tolerance)
  {
    const dealii::QIterated<dim> grid(dealii::QMidpoint<1>(), 7);
    const unsigned int d = side / 2;
    const double plane =
      side % 2 == 0 ? mesh.lower_corner()[d] : mesh.upper_corner()[d];
    for (const auto &x : grid.get_points())
    {
      dealii::Point<dim> point;
      for (unsigned int e = 0; e < dim; ++e)
        point[e] = mesh.lower_corner()[e] +
                   x[e] * (mesh.upper_corner()[e] - mesh.lower_corner()[e]);
      dealii::Point<dim> image = point;
      image[d] = 2. * plane - point[d];
      if (std::abs(body.value(point) - body.value(image)) > tolerance)
        return false;
    }
    return true;
  }

  /// Whether the body reaches through a side of the domain by more than
  /// @p depth [m].
  /// @param tolerance size below which a cut may be missed [m]
  template <int dim>
  bool reaches_through(const RigidBody &body,
                       const CoarseMesh<dim> &mesh,
                       const unsigned int side,
                       const double depth,
                       const double tolerance)
  {
    const unsigned int d = side / 2;
    Box<dim> plane{mesh.lower_corner(), mesh.upper_corner()};
    (side % 2 == 0 ? plane.upper : plane.lower)[d] =
      (side % 2 == 0 ? plane.lower : plane.upper)[d];
    const auto value = [&](const dealii::Point<dim> &x) {
      return body.value(x);
    };
    return find_below(plane, -depth, tolerance, value).place.has_value();
  }
} // namespace


template <int dim>
double cell_at_body(const CoarseMesh<dim> &mesh,
                    const RigidBody &body,
                    const unsigned int subcells)
{
  double edge = 0.;
  for (unsigned int d = 0; d < dim; ++d)
    edge = std::max(edge,
                    (mesh.upper_corner()[d] - mesh.lower_corner()[d]) /
                      mesh.coarse_cells(d));
  const int halvings =
    static_cast<int>(mesh.initial_refinement() + body.most_levels());
  return std::ldexp(edge, -halvings) / std::max(1U, subcells);
}


template <int dim>
void check_places(ParameterHandler &prm,
                  const GasMaterial &material,
                  const CoarseMesh<dim> &mesh,
                  const RigidBody &body)
{
  if (!mesh.is_axis_aligned())
    return;
  if (!body.empty() && body.is_required())
    check_body(body, mesh);
  const auto charges = read_charges(prm, material, mesh);
  for (const NamedCharge<dim> &one : charges)
  {
    check_within(one, mesh);
    if (!body.empty() && body.is_required())
      check_apart(one, body, mesh, cell_at_body(mesh, body, subcells_of(prm)));
  }
}


template <int dim>
std::vector<std::string> remarks_on_cuts(ParameterHandler &prm,
                                         const CoarseMesh<dim> &mesh,
                                         const RigidBody &body)
{
  std::vector<std::string> lines;
  {
    const Section section(prm, "Rigid body");
    if (prm.get("Kind") != "body")
      return lines;
  }
  if (!mesh.is_axis_aligned())
    return lines;
  const double cell = cell_at_body(mesh, body, subcells_of(prm));
  const Section section(prm, "Boundaries");
  for (unsigned int side = 0; side < 2 * dim; ++side)
  {
    const unsigned int d = side / 2;
    const bool is_axis = side == 0 && mesh.geometry() != Geometry::plane;
    if (is_axis || mesh.is_periodic(d) || prm.get(sides[side]) == "symmetry")
      continue;
    const bool is_wall = prm.get(sides[side]) == "wall";
    if (reaches_through(body, mesh, side, cell, 0.5 * cell) &&
        !(is_wall && is_symmetric(body, mesh, side, 0.1 * cell)))
      lines.push_back("WARNING: the rigid body reaches through side " +
                      sides[side] +
                      " of the domain; what is beyond it is left out");
  }
  return lines;
}


template <int dim>
std::array<bool, 3> planes_of_symmetry(ParameterHandler &prm,
                                       const CoarseMesh<dim> &mesh)
{
  std::array<bool, 3> planes{};
  const Section section(prm, "Boundaries");
  for (unsigned int d = 0; d < dim && mesh.is_axis_aligned(); ++d)
  {
    const bool has_axis = d == 0 && mesh.geometry() != Geometry::plane;
    planes[d] = !has_axis && !mesh.is_periodic(d) &&
                (prm.get(sides[2 * d]) == "symmetry") !=
                  (prm.get(sides[2 * d + 1]) == "symmetry");
  }
  return planes;
}


template <int dim>
dealii::Tensor<1, 3> factors_to_whole_body(ParameterHandler &prm,
                                           const CoarseMesh<dim> &mesh,
                                           const RigidBody &body)
{
  dealii::Tensor<1, 3> factors({1., 1., 1.});
  if (body.empty() || !mesh.is_axis_aligned())
    return factors;
  if (mesh.geometry() != Geometry::plane)
    factors[0] = 0.;
  const std::array<bool, 3> planes = planes_of_symmetry(prm, mesh);
  const double cell = cell_at_body(mesh, body, subcells_of(prm));
  const Section section(prm, "Boundaries");
  for (unsigned int d = 0; d < dim; ++d)
  {
    const unsigned int side =
      2 * d + (prm.get(sides[2 * d]) == "symmetry" ? 0 : 1);
    if (!planes[d] ||
        !reaches_through(body, mesh, side, 0.1 * cell, 0.5 * cell))
      continue;
    factors *= 2.;
    factors[d] = 0.;
  }
  return factors;
}


template <int dim>
double largest_charge_extent(ParameterHandler &prm,
                             const GasMaterial &material,
                             const CoarseMesh<dim> &mesh)
{
  double extent = 0.;
  for (const NamedCharge<dim> &one : read_charges(prm, material, mesh))
  {
    const auto [lower, upper] = one.charge.bounds();
    for (unsigned int d = 0; d < dim; ++d)
      extent = std::max(extent, 0.5 * (upper[d] - lower[d]));
  }
  return extent;
}


#define CONTRECOUP_INSTANTIATE(dim)                                         \
  template double cell_at_body(                                             \
    const CoarseMesh<dim> &, const RigidBody &, unsigned int);              \
  template void check_places(ParameterHandler &,                            \
                             const GasMaterial &,                           \
                             const CoarseMesh<dim> &,                       \
                             const RigidBody &);                            \
  template std::array<bool, 3> planes_of_symmetry(ParameterHandler &,       \
                                                  const CoarseMesh<dim> &); \
  template dealii::Tensor<1, 3> factors_to_whole_body(                      \
    ParameterHandler &, const CoarseMesh<dim> &, const RigidBody &);        \
  template std::vector<std::string> remarks_on_cuts(                        \
    ParameterHandler &, const CoarseMesh<dim> &, const RigidBody &);        \
  template double largest_charge_extent(                                    \
    ParameterHandler &, const GasMaterial &, const CoarseMesh<dim> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
