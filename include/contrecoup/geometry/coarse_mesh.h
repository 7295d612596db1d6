// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/lanes.h>

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/point.h>
#include <deal.II/grid/tria.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup
{
/// How space is measured: the coordinates of a mesh.
enum class Geometry
{
  plane,        ///< Cartesian coordinates, any dimension
  cylindrical,  ///< 1-D, coordinate 0 is the radius
  spherical,    ///< 1-D, coordinate 0 is the radius
  axisymmetric, ///< 2-D, coordinate 0 is the radius, 1 the axis
};

/// Power of the radius in the volume element: 0 plane, 1 cylindrical and
/// axisymmetric, 2 spherical.
unsigned int radial_exponent(const Geometry geometry);

/**
 * The domain before any refinement, as subsection "Domain" describes it: a
 * box of equal hexahedra, a cone, one of deal.II's named generators, or a mesh
 * file (Gmsh and every other format that deal.II reads).
 */
template <int dim>
class CoarseMesh
{
public:
  /// Declares subsection "Domain".
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads subsection "Domain".
  /// @throws InputError for an empty box, a geometry that does not fit the
  /// dimension, a negative radius, a list of the wrong length.
  void parse_parameters(dealii::ParameterHandler &prm);

  /**
   * Builds the coarse mesh, with periodic faces matched and boundary ids
   * set: for a box 2 d at the low end of direction d and 2 d + 1 at its
   * high end.
   * @throws InputError for an unreadable file and for inverted cells (the
   * first is named with its centre and Jacobian).
   */
  void create(dealii::Triangulation<dim> &triangulation) const;

  /// Whether every cell is a box along the axes, so that no metric terms
  /// are needed.
  bool is_axis_aligned() const
  {
    return kind_ == "box";
  }

  Geometry geometry() const
  {
    return geometry_;
  }

  /// Uniform refinements of the coarse mesh at the start [-].
  unsigned int initial_refinement() const
  {
    return initial_refinement_;
  }

  bool is_periodic(const unsigned int direction) const
  {
    return periodic_[direction];
  }

  /// Coarse cells; 0 when only creating the mesh can tell.
  double n_coarse_cells() const;

  /// Coarse cells of a box along a direction.
  unsigned int coarse_cells(const unsigned int direction) const
  {
    return subdivisions_[direction];
  }

  /// Number of the coarse cell of a box that holds @p point, which must be
  /// in the box; shared faces belong to the upper cell.
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
