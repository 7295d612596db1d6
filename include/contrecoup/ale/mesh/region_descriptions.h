// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/ale/mesh/mesh_layer.h>
#include <contrecoup/ale/mesh/region_material.h>
#include <contrecoup/base/expression.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <vector>

namespace contrecoup::ale
{
/**
 * What fills the mesh at the start: subsections "Region *", each with where it
 * is, its material and its state. Later ones win.
 */
class RegionDescriptions
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for constants without a physical meaning
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a metal, which only particles can be
  void refuse_metals() const;

  /// Sets the material ids of the cells.
  /// @param layers by the material ids that they have now; may be empty
  /// @throws InputError for a cell in no region, or a region without cells
  void set_regions(dealii::Triangulation<3> &mesh,
                   const MeshLayers &layers) const;

  /// Masses, energies and velocities at the present positions.
  /// @throws InputError for a state without a physical meaning
  void fill(const HexSpace &space, AleState &state) const;

  std::vector<Region> regions() const;

  /// The fastest signal at the start, in the centres of the cells [m/s].
  /// @throws InputError for a state without a physical meaning
  double largest_speed(const dealii::Triangulation<3> &mesh) const;

  /// Velocity of the fastest matter at the start, at the origin if velocities
  /// depend on the place [m/s].
  dealii::Tensor<1, 3> fastest_velocity() const;

  /// The largest of each component of the velocities at the start, at the
  /// origin if they depend on the place [m/s].
  dealii::Tensor<1, 3> largest_components() const;

  /// Whether where anything is, or its state, depends on the place.
  bool depends_on_place() const;

  /// The region at a place of a layer, and the density of what is there
  /// [kg/m^3]. @throws InputError where there is none, and for a state without
  /// a
  ///   physical meaning
  const Region &region_at(const dealii::Point<3> &place,
                          const MeshLayer &layer) const;
  /// Its number, or -1 where there is none.
  int find_region(const dealii::Point<3> &place, const MeshLayer &layer) const;
  double density_at(const dealii::Point<3> &place,
                    const MeshLayer &layer) const;

  /// What a region has at a place at the start. @throws InputError for a state
  /// without a physical meaning
  InitialMatter matter_at(const dealii::Point<3> &place,
                          const unsigned int region) const
  {
    return check_state(descriptions_[region], place);
  }
  dealii::Tensor<1, 3> velocity_at(const dealii::Point<3> &place,
                                   const unsigned int region) const;

  /// @throws InputError for a region of a layer that is none of these
  void check_layers(const MeshLayers &layers) const;

private:
  struct Description
  {
    Region region;
    std::string layer;
    Expression where;
    Expression density, pressure, products;
    std::array<Expression, 3> velocity;
  };

  /// That at a place of a layer. @throws InputError for none
  const Description &find(const dealii::Point<3> &place,
                          const MeshLayer &layer) const;
  const Description &at(const HexSpace &space, const std::size_t cell) const
  {
    return descriptions_[space.region(cell)];
  }
  /// @throws InputError for a state without a physical meaning
  InitialMatter check_state(const Description &description,
                            const dealii::Point<3> &centre) const;
  void fill_cell(const HexSpace &space,
                 const std::size_t cell,
                 AleState &state) const;

  std::vector<Description> descriptions_;
};
} // namespace contrecoup::ale
