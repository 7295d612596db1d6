// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/parameters.h>
#include <contrecoup/geometry/coarse_mesh.h>

#include <deal.II/base/point.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace contrecoup::gas
{
/**
 * A piece of explosive: its shape, and where and when it is lit. Which shapes
 * there are depends on the geometry of the mesh: spheres in 3-D, axisymmetric
 * and spherical meshes; cylinders in 3-D, axisymmetric (along the axis),
 * plane 2-D (seen end on) and cylindrical ones; boxes in plane ones of any
 * dimension. Lengths are in m.
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
   * Reads them.
   * @param density of the explosive [kg/m^3], which makes a size of a mass
   * @throws InputError, naming @p where, for a shape or place that the
   * geometry does not have, and for times that do not go with the points.
   */
  Charge(const ParameterHandler &prm,
         const Geometry geometry,
         const double density,
         const std::string &where);

  /// Volume of the whole charge [m^3; m^2 or m where the directions that the
  /// mesh does not resolve count per m].
  double volume() const;

  /// Distance from the surface [m], negative inside.
  double signed_distance(const dealii::Point<dim> &point) const;

  /// Smallest diameter [m].
  double smallest_size() const;

  /// Opposite corners of the box around the charge.
  std::pair<dealii::Point<dim>, dealii::Point<dim>> bounds() const;

  /// The opposite corners of a charge that is a box in the coordinates of the
  /// mesh.
  std::optional<std::pair<dealii::Point<dim>, dealii::Point<dim>>>
  as_box() const;

  /**
   * The part of the volume that lies in the box @p mesh: 1, or a half for
   * each of its sides that is a plane of symmetry of the charge. Nothing is
   * known where the domain cuts the charge otherwise, and about meshes that
   * are no boxes.
   */
  std::optional<double> share_within(const CoarseMesh<dim> &mesh) const;

  /// When a detonation of this speed [m/s] has come to within @p lead [m] of
  /// a point [s].
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
  std::vector<double> ignition_times_; ///< of each point [s]
};
} // namespace contrecoup::gas
