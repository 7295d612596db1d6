// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/mesh_layer.h>
#include <contrecoup/ale/mesh/symmetry_planes.h>
#include <contrecoup/geometry/layered_ball.h>
#include <contrecoup/numerics/hex8_wedge.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace contrecoup::ale
{
/**
 * A head of ellipsoids, one in the other: brain, cerebrospinal fluid (CSF),
 * skull, and scalp if it has a thickness. Entries of subsection "Mesh".
 */
class LayeredHead
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError when entries do not go together
  void parse_parameters(dealii::ParameterHandler &prm);

  /// Material ids count the layers, boundary ids are those of
  /// make_layered_ball().
  void create(dealii::Triangulation<3> &mesh) const
  {
    make_layered_ball(ball_, mesh);
  }

  /// From inside.
  const MeshLayers &layers() const
  {
    return layers_;
  }

  /// Part of the head that is computed; 1 without one [-].
  double part() const;

  /// The wedge that is computed; without a slope: none.
  HexWedge wedge() const
  {
    return ball_.wedge_axis > 2 ? HexWedge()
                                : HexWedge{ball_.wedge_axis, ball_.wedge_slope};
  }

  /// Of the outer surfaces of the layers [m].
  const std::vector<std::array<double, 3>> &semi_axes() const
  {
    return ball_.semi_axes;
  }

  /// Axes to which planes of symmetry are normal.
  const std::array<bool, 3> &is_halved() const
  {
    return ball_.is_halved;
  }

  double n_cells() const;

  /// Those of the mesh without symmetry.
  double n_cells_of_whole() const;

  /// Those of a wedge, of one half of it between the poles if it is halved.
  double n_cells_of_wedge(const bool is_halved) const;

  /// About the shortest edge of a cell [m].
  double cell_size() const;

private:
  /// @throws InputError for a head that is not round about it
  void find_wedge(dealii::ParameterHandler &prm);
  /// All layers, from the inner cube outwards.
  double n_cells_across() const;
  void add_layer(const std::string &name,
                 const double thickness,
                 const unsigned int cells);

  LayeredBall ball_;
  MeshLayers layers_;
};
} // namespace contrecoup::ale
