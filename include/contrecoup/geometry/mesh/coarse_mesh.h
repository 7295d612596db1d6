// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes/lanes.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup
{
/// Coordinate system of a mesh.
enum class Geometry
{
  plane,        ///< Cartesian, any dimension
  cylindrical,  ///< 1-D, x is the radius
  spherical,    ///< 1-D, x is the radius
  axisymmetric, ///< 2-D, x is the radius, y the axis
};

/// Power of the radius in the volume element: 0 for plane, 1 for cylindrical
/// and axisymmetric, 2 for spherical.
unsigned int radial_exponent(const Geometry geometry);

/**
 * The coarse mesh of the gas solver, subsection "Domain": a box of equal
 * hexahedra, a cone, one of deal.II's named generators, or a mesh file (Gmsh
 * or another format that deal.II reads).
 */
template <int dim>
class CoarseMesh
{
public:
  /// Declares subsection "Domain".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads subsection "Domain".
  /// @throws InputError for an empty box, a geometry that does not fit the
  /// dimension, a negative radius, or a list of the wrong length
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * Builds the coarse mesh, matches periodic faces and sets boundary ids. In a
   * box, the id of the lower side normal to direction d is 2 d, of the upper
   * side 2 d + 1.
   * @throws InputError for an unreadable file, and for inverted cells; names
   * the first with its centre and Jacobian
   */
  void create(dealii::Triangulation<dim> &triangulation) const;

  /// Whether all cells are axis-aligned boxes, which need no metric terms.
  bool is_axis_aligned() const
  {
    return kind_ == "box";
  }

  Geometry geometry() const
  {
    return geometry_;
  }

  /// Number of uniform refinements at the start [-].
  unsigned int initial_refinement() const
  {
    return initial_refinement_;
  }

  bool is_periodic(const unsigned int direction) const
  {
    return periodic_[direction];
  }

  /// Number of coarse cells; 0 if unknown before create().
  double n_coarse_cells() const;

  /// Number of coarse cells of a box along a direction.
  unsigned int coarse_cells(const unsigned int direction) const
  {
    return subdivisions_[direction];
  }

  /// Index of the coarse cell of a box that contains @p point, which must lie
  /// in the box. Points on shared faces belong to the upper cell.
  unsigned int coarse_cell_at(const dealii::Point<dim> &point) const;

  const dealii::Point<dim> &lower_corner() const
  {
    return lower_;
  }

  const dealii::Point<dim> &upper_corner() const
  {
    return upper_;
  }

private:
  void check_box() const;
  void create_cone(dealii::Triangulation<dim> &triangulation) const;
  void check_cells(const dealii::Triangulation<dim> &triangulation) const;
  void match_periodic_faces(dealii::Triangulation<dim> &triangulation) const;

  std::string kind_;
  Geometry geometry_ = Geometry::plane;
  dealii::Point<dim> lower_;
  dealii::Point<dim> upper_;
  std::vector<unsigned int> subdivisions_;
  std::array<bool, dim> periodic_;
  unsigned int initial_refinement_ = 0;
  double cone_angle_ = 0.; ///< [rad]
  std::string generator_;
  std::string generator_arguments_;
  std::string file_;
};
} // namespace contrecoup
