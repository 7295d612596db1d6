// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/geometry/mesh/coarse_mesh.h>

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup::gas
{
/**
 * Charge: shape of a piece of explosive, and where and when it is ignited. The
 * available shapes depend on the geometry of the mesh: spheres in 3-D,
 * axisymmetric and spherical meshes; cylinders in 3-D, axisymmetric (along the
 * axis), plane 2-D (seen along the axis) and cylindrical meshes; boxes in
 * plane meshes of any dimension. Lengths are in m.
 */
template <int dim>
class Charge
{
public:
  enum class Shape
  {
    sphere,
    cylinder,
    box
  };

  /// Declares the entries of one charge in the current subsection.
  static void declare_parameters(ParameterHandler &prm);

  /**
   * Reads the entries of declare_parameters().
   *
   * @param density density of the explosive [kg/m^3], which converts mass to
   * size
   * @throws InputError, naming @p where, for a shape or position that the
   * geometry does not have, and for ignition times that do not match the
   * ignition points.
   */
  Charge(const ParameterHandler &prm,
         const Geometry geometry,
         const double density,
         const std::string &where);

  /// Volume of the whole charge [m^3; m^2 or m where directions are not
  /// resolved, per m of each].
  double volume() const;

  /// Signed distance from the surface [m], negative inside.
  double signed_distance(const dealii::Point<dim> &point) const;

  /// Smallest diameter [m].
  double smallest_size() const;

  /// Lower and upper corner of the bounding box [m].
  std::pair<dealii::Point<dim>, dealii::Point<dim>> bounds() const;

  /// Lower and upper corner [m] if the charge is a box in the coordinates of
  /// the mesh.
  std::optional<std::pair<dealii::Point<dim>, dealii::Point<dim>>>
  as_box() const;

  /**
   * Fraction of the charge's volume inside the box @p mesh: 1, halved for each
   * side that is a plane of symmetry of the charge. Nothing is returned where
   * the domain cuts the charge otherwise, or for a mesh that is not a box.
   */
  std::optional<double> fraction_within(const CoarseMesh<dim> &mesh) const;

  /// Time [s] when a detonation front of speed @p speed [m/s] comes within @p
  /// lead [m] of a point.
  double arrival(const dealii::Point<dim> &point,
                 const double speed,
                 const double lead) const;

private:
  double half_extent(const unsigned int direction) const;
  bool is_mirrored(const unsigned int direction) const;
  void read_ignition(const ParameterHandler &prm, const std::string &where);
  void scale(const double factor);
  void check(const std::string &where) const;

  Geometry geometry_;
  Shape shape_;
  dealii::Point<dim> center_;
  dealii::Tensor<1, dim> axis_;  ///< of a cylinder in 3-D
  dealii::Tensor<1, dim> edges_; ///< of a box
  double radius_;
  double length_; ///< of a cylinder
  std::vector<dealii::Point<dim>> ignition_points_;
  std::vector<double> ignition_times_; ///< one per ignition point [s]
};
} // namespace contrecoup::gas
