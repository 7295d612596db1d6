// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/mesh_layer.h>
#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/geometry/body/layered_ball.h>
#include <contrecoup/numerics/element/hex8_wedge.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/// A head of nested ellipsoids: brain, cerebrospinal fluid (CSF), skull, and
/// scalp if its thickness is positive. Entries of subsection "Mesh".
class LayeredHead
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for contradictory entries
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Builds the mesh. Material ids are layer numbers, boundary ids are those
  /// of make_layered_ball().
  void create(dealii::Triangulation<3> &mesh) const
  {
    make_layered_ball(ball_, mesh);
  }

  /// Layers from the inside outwards.
  const MeshLayers &layers() const
  {
    return layers_;
  }

  /// Computed part of the head; 1 without symmetry [-].
  double computed_fraction() const;

  /// The computed wedge; without a slope: none.
  HexWedge wedge() const
  {
    return ball_.wedge_axis > 2 ? HexWedge()
                                : HexWedge{ball_.wedge_axis, ball_.wedge_slope};
  }

  /// Semi-axes of the outer surfaces of the layers [m].
  const std::vector<std::array<double, 3>> &semi_axes() const
  {
    return ball_.semi_axes;
  }

  /// Number of cells across each layer, from the inside outwards.
  const std::vector<unsigned int> &cells_across() const
  {
    return ball_.cells_across;
  }

  /// Whether a symmetry plane is normal to each axis.
  const std::array<bool, 3> &is_halved() const
  {
    return ball_.is_halved;
  }

  double n_cells() const;

  /// Number of cells of the mesh without symmetry.
  double n_cells_of_whole() const;

  /// Number of cells of a wedge. @param is_halved whether a symmetry plane
  /// halves the wedge between its poles
  double n_cells_of_wedge(const bool is_halved) const;

  /// Approximate shortest edge of a cell [m].
  double cell_size() const;

private:
  /// @throws InputError for a head that is not axisymmetric about the wedge
  /// axis
  void find_wedge(dealii::ParameterHandler &prm);
  /// Number of cells along a radius: inner cube and all layers.
  double n_cells_across() const;
  void add_layer(const std::string &name,
                 const double thickness,
                 const unsigned int cells);

  LayeredBall ball_;
  MeshLayers layers_;
};
} // namespace contrecoup::ale
