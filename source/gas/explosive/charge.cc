// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/bounds.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/gas/explosive/charge.h>
#include <contrecoup/gas/state/state_parameters.h>

#include <boost/math/constants/constants.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::gas
{
namespace
{
  using boost::math::double_constants::pi;

  void declare_size(ParameterHandler &prm)
  {
    declare_double(prm,
                   "Mass",
                   "0",
                   0.,
                   bounds::mass,
                   "kg",
                   "If above 0: mass of the whole charge (plane 2-D and "
                   "cylindrical meshes: per m, plane 1-D: per m^2); the sizes "
                   "below then only set its proportions.");
    declare_double(
      prm,
      "Radius",
      "0.05",
      bounds::smallest_length,
      bounds::length,
      "m",
      used_with("Shape = sphere, cylinder", "Radius of a sphere or cylinder."));
    declare_double(
      prm,
      "Length",
      "0.1",
      bounds::smallest_length,
      bounds::length,
      "m",
      used_with("Shape = cylinder",
                "Length of a cylinder where the mesh resolves it."));
    declare_list(
      prm,
      "Edges",
      "0.1, 0.1, 0.1",
      1,
      3,
      bounds::smallest_length,
      bounds::length,
      "m",
      used_with("Shape = box",
                "Edge lengths of a box, along the axes of the mesh."));
  }

  /// Signed distance from a box; @p beyond holds, per direction, the distance
  /// from the centre minus half the edge [m].
  template <typename Offsets>
  double box_distance(const Offsets &beyond)
  {
    double deepest = -std::numeric_limits<double>::infinity();
    double square = 0.;
    for (const double b : beyond)
    {
      deepest = std::max(deepest, b);
      square += std::max(b, 0.) * std::max(b, 0.);
    }
    return deepest < 0. ? deepest : std::sqrt(square);
  }
} // namespace


template <int dim>
void Charge<dim>::declare_parameters(ParameterHandler &prm)
{
  declare_selection(prm,
                    "Shape",
                    "sphere",
                    {"sphere", "cylinder", "box"},
                    "Sphere (3-D, axisymmetric, spherical), cylinder (3-D, "
                    "axisymmetric, cylindrical; in plane 2-D seen end on) or "
                    "box (plane).");
  declare_list(prm,
               "Center",
               "0, 0, 0",
               1,
               3,
               -bounds::length,
               bounds::length,
               "m",
               "Centre in the coordinates of the mesh; missing ones are zero.");
  declare_size(prm);
  declare_list(
    prm,
    "Axis",
    "0, 0, 1",
    3,
    3,
    -bounds::direction,
    bounds::direction,
    "-",
    used_with("Shape = cylinder",
              "Direction of a cylinder's axis in 3-D, of any length."));
  declare_points(prm,
                 "Ignition points",
                 "",
                 "m",
                 "Ignition points; none: the centre of the charge. From a "
                 "point outside of the charge the detonation propagates as if "
                 "explosive filled the distance.");
  declare_list(prm,
               "Ignition times",
               "",
               0,
               1000,
               0.,
               bounds::time,
               "s",
               "Ignition time of each point; none: zero.");
}


template <int dim>
Charge<dim>::Charge(const ParameterHandler &prm,
                    const Geometry geometry,
                    const double density,
                    const std::string &where)
  : geometry_(geometry)
  , center_(read_vector<dim>(prm, "Center", where))
  , radius_(read_double(prm, "Radius"))
  , length_(read_double(prm, "Length"))
{
  const std::string shape = prm.get("Shape");
  shape_ = shape == "sphere" ? Shape::sphere
                             : (shape == "box" ? Shape::box : Shape::cylinder);
  const auto edges = read_list(prm, "Edges");
  if (shape_ == Shape::box && edges.size() < dim)
    throw InputError(where + ": Edges = " + prm.get("Edges") + " needs " +
                     std::to_string(dim) + " numbers");
  for (unsigned int d = 0; d < dim && d < edges.size(); ++d)
    edges_[d] = edges[d];
  if constexpr (dim == 3)
    axis_ = read_direction<dim>(prm, "Axis", where);
  check(where);

  const double mass = read_double(prm, "Mass");
  if (mass > 0.)
  {
    // Scales all directions that the shape has in this mesh equally.
    const double n = shape_ == Shape::box ? dim
                     : shape_ == Shape::sphere ||
                         geometry_ == Geometry::axisymmetric || dim == 3
                       ? 3.
                       : 2.;
    scale(std::pow(mass / (density * volume()), 1. / n));
  }
  read_ignition(prm, where);
}


template <int dim>
void Charge<dim>::check(const std::string &where) const
{
  const unsigned int m = radial_exponent(geometry_);
  const bool allowed = shape_ == Shape::sphere     ? dim + m == 3
                       : shape_ == Shape::cylinder ? m != 2 && dim + m != 1
                                                   : m == 0;
  if (!allowed)
    throw InputError(where + ": this Shape does not go with the geometry of "
                             "the mesh; spheres need 3-D, axisymmetric or "
                             "spherical, cylinders 3-D, axisymmetric, "
                             "cylindrical or plane 2-D, boxes plane meshes");
  if (m > 0 && center_[0] != 0.)
    throw InputError(where + ": Center must lie at radius 0 in this geometry");
}


template <int dim>
void Charge<dim>::read_ignition(const ParameterHandler &prm,
                                const std::string &where)
{
  ignition_points_ = read_points<dim>(prm, "Ignition points");
  if (ignition_points_.empty())
    ignition_points_.push_back(center_);
  ignition_times_ = read_list(prm, "Ignition times");
  if (ignition_times_.empty())
    ignition_times_.assign(ignition_points_.size(), 0.);
  if (ignition_times_.size() != ignition_points_.size())
    throw InputError(
      where + ": there are " + std::to_string(ignition_times_.size()) +
      " Ignition times for " + std::to_string(ignition_points_.size()) +
      " Ignition points; give as many, or none");
}


template <int dim>
void Charge<dim>::scale(const double factor)
{
  radius_ *= factor;
  length_ *= factor;
  edges_ *= factor;
}


template <int dim>
double Charge<dim>::volume() const
{
  if (shape_ == Shape::sphere)
    return 4. / 3. * pi * radius_ * radius_ * radius_;
  if (shape_ == Shape::cylinder)
  {
    const bool is_finite = dim == 3 || geometry_ == Geometry::axisymmetric;
    return pi * radius_ * radius_ * (is_finite ? length_ : 1.);
  }
  double result = 1.;
  for (unsigned int d = 0; d < dim; ++d)
    result *= edges_[d];
  return result;
}


template <int dim>
double Charge<dim>::signed_distance(const dealii::Point<dim> &point) const
{
  if (const auto corners = as_box())
  {
    std::array<double, dim> beyond;
    for (unsigned int d = 0; d < dim; ++d)
      beyond[d] =
        std::max(corners->first[d] - point[d], point[d] - corners->second[d]);
    return box_distance(beyond);
  }
  const dealii::Tensor<1, dim> offset = point - center_;
  if (shape_ == Shape::sphere || dim == 2)
    return offset.norm() - radius_;
  const double along = offset * axis_;
  const double across = (offset - along * axis_).norm();
  return box_distance(
    std::array<double, 2>{{across - radius_, std::abs(along) - 0.5 * length_}});
}


template <int dim>
double Charge<dim>::smallest_size() const
{
  double smallest = 2. * radius_;
  if (shape_ == Shape::cylinder &&
      (dim == 3 || geometry_ == Geometry::axisymmetric))
    smallest = std::min(smallest, length_);
  if (shape_ == Shape::box)
  {
    smallest = edges_[0];
    for (unsigned int d = 1; d < dim; ++d)
      smallest = std::min(smallest, edges_[d]);
  }
  return smallest;
}


template <int dim>
std::optional<std::pair<dealii::Point<dim>, dealii::Point<dim>>>
Charge<dim>::as_box() const
{
  const bool is_box =
    shape_ == Shape::box || dim == 1 ||
    (shape_ == Shape::cylinder && geometry_ == Geometry::axisymmetric);
  if (!is_box)
    return {};
  return bounds();
}


template <int dim>
std::pair<dealii::Point<dim>, dealii::Point<dim>> Charge<dim>::bounds() const
{
  dealii::Tensor<1, dim> half;
  for (unsigned int d = 0; d < dim; ++d)
    half[d] = half_extent(d);
  return {center_ - half, center_ + half};
}


template <int dim>
double Charge<dim>::half_extent(const unsigned int direction) const
{
  if (shape_ == Shape::box)
    return 0.5 * edges_[direction];
  if (shape_ == Shape::cylinder && geometry_ == Geometry::axisymmetric)
    return direction == 0 ? radius_ : 0.5 * length_;
  if (shape_ == Shape::cylinder && dim == 3)
  {
    const double along = std::abs(axis_[direction]);
    return along * 0.5 * length_ +
           std::sqrt(std::max(0., 1. - along * along)) * radius_;
  }
  return radius_;
}


template <int dim>
bool Charge<dim>::is_mirrored(const unsigned int direction) const
{
  if (shape_ != Shape::cylinder || dim != 3)
    return true;
  const double along = std::abs(axis_[direction]);
  return along < 1e-12 || along > 1. - 1e-12;
}


template <int dim>
std::optional<double>
Charge<dim>::fraction_within(const CoarseMesh<dim> &mesh) const
{
  if (!mesh.is_axis_aligned())
    return {};
  double fraction = 1.;
  unsigned int n_cuts = 0;
  bool mirrored = true;
  for (unsigned int d = 0; d < dim; ++d)
    for (unsigned int side = 0; side < 2; ++side)
    {
      const double plane =
        side == 0 ? mesh.lower_corner()[d] : mesh.upper_corner()[d];
      if (d == 0 && side == 0 && plane == 0. && geometry_ != Geometry::plane)
        continue; // the axis or centre is no cut
      const double half = half_extent(d);
      const double depth = side == 0 ? center_[d] - plane : plane - center_[d];
      if (depth >= half * (1. - 1e-12))
        continue;
      if (std::abs(depth) > half * 1e-12)
        return {};
      fraction *= 0.5;
      ++n_cuts;
      mirrored = mirrored && is_mirrored(d);
    }
  // A single plane through the centre halves each shape.
  if (n_cuts > 1 && !mirrored)
    return {};
  return fraction;
}


template <int dim>
double Charge<dim>::arrival(const dealii::Point<dim> &point,
                            const double speed,
                            const double lead) const
{
  double first = std::numeric_limits<double>::max();
  for (unsigned int i = 0; i < ignition_points_.size(); ++i)
  {
    const double way = point.distance(ignition_points_[i]) - lead;
    first = std::min(first, ignition_times_[i] + std::max(way, 0.) / speed);
  }
  return first;
}


template class Charge<1>;
template class Charge<2>;
template class Charge<3>;
} // namespace contrecoup::gas
