// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/ale_state.h>
#include <contrecoup/ale/mesh/hex_space.h>
#include <contrecoup/ale/mesh/mesh_layer.h>
#include <contrecoup/ale/mesh/region_material.h>
#include <contrecoup/base/parameters/expression.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <vector>

namespace contrecoup::ale
{
/// Initial contents of the mesh: subsections "Region *" with location,
/// material and state. Where regions overlap, the last one in the file applies.
class RegionDescriptions
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for unphysical constants
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for a metal, which needs particles
  void refuse_metals() const;

  /// Sets the material ids of cells to region numbers.
  /// @param layers by the present material ids; may be empty
  /// @throws InputError for a cell in no region, or a region without cells
  void set_regions(dealii::Triangulation<3> &mesh,
                   const MeshLayers &layers) const;

  /// Sets mass, energy and products of each cell and the velocity of each node
  /// from the positions in @p state; nodes that regions share get the mean
  /// velocity by mass. Relaxed strains are zero.
  /// @throws InputError for an unphysical state
  void fill(const HexSpace &space, AleState &state) const;

  std::vector<Region> regions() const;

  /// Largest initial signal speed at cell centres [m/s].
  /// @throws InputError for an unphysical state
  double largest_speed(const dealii::Triangulation<3> &mesh) const;

  /// Initial velocity of the fastest region [m/s]; evaluated at the origin
  /// where velocity depends on the place.
  dealii::Tensor<1, 3> fastest_velocity() const;

  /// Largest magnitude of each component of the initial velocities of all
  /// regions [m/s]; evaluated at the origin where velocity depends on the
  /// place.
  dealii::Tensor<1, 3> largest_components() const;

  /// Whether location or state of any region depends on the place.
  bool depends_on_place() const;

  /// The region at a point of a layer. @throws InputError for no region
  const Region &region_at(const dealii::Point<3> &place,
                          const MeshLayer &layer) const;
  /// Number of the region at a point, or -1.
  int find_region(const dealii::Point<3> &place, const MeshLayer &layer) const;
  /// Density at a point of a layer [kg/m^3]. @throws InputError for no region,
  /// and for an unphysical state
  double density_at(const dealii::Point<3> &place,
                    const MeshLayer &layer) const;

  /// Initial state of a region at a point. @throws InputError for an
  /// unphysical state
  InitialMatter matter_at(const dealii::Point<3> &place,
                          const unsigned int region) const
  {
    return check_state(descriptions_[region], place);
  }
  dealii::Tensor<1, 3> velocity_at(const dealii::Point<3> &place,
                                   const unsigned int region) const;

  /// Whether any region has a pressure at the start.
  bool has_pressure() const;

  /// Whether the velocity of any region depends on the place.
  bool velocity_depends_on_place() const;

  /// @param counts of what each region selects
  /// @param object what is counted, in the singular, for the message
  /// @throws InputError for a region that selects nothing
  void require_some(const std::vector<std::uint64_t> &counts,
                    const std::string &object) const;

  /// @throws InputError for a region that names an unknown layer
  void check_layers(const MeshLayers &layers) const;

private:
  struct Description
  {
    Region region;
    Expression where;
    Expression density, pressure, products;
    std::array<Expression, 3> velocity;
  };

  /// The description at a point of a layer. @throws InputError for none
  const Description &find(const dealii::Point<3> &place,
                          const MeshLayer &layer) const;
  const Description &at(const HexSpace &space, const std::size_t cell) const
  {
    return descriptions_[space.region(cell)];
  }
  /// @throws InputError for an unphysical state
  InitialMatter check_state(const Description &description,
                            const dealii::Point<3> &centre) const;
  void fill_cell(const HexSpace &space,
                 const std::size_t cell,
                 AleState &state) const;

  std::vector<Description> descriptions_;
};
} // namespace contrecoup::ale
