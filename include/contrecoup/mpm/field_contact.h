// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/particles.h>
#include <contrecoup/mpm/transfer_kernels.h>

#include <array>
#include <string>
#include <vector>

namespace contrecoup::mpm
{
/// How two velocity fields meet.
enum class FieldInterface
{
  slip,    ///< no motion apart or together, free along each other
  contact, ///< may part; not together once their surfaces touch; friction
};

/// Their words in parameter files, in the order of the enumeration.
const std::vector<std::string> &field_interface_names();

/// @throws InputError with the nearest word
FieldInterface find_field_interface(const std::string &name);

/**
 * Impulses between velocity fields at nodes where more than one has mass, along
 * the normal that the gradients of their masses give; equal and opposite, so
 * that momentum is kept. Bardenhagen and others, Comput. Methods Appl. Mech.
 * Eng. 187 (2000). Whether surfaces touch is asked of the particles themselves:
 * the gap is that of the particles' faces along the normal, so that contact
 * does not begin as far away as splines reach.
 */
class FieldContact
{
public:
  /**
   * @param field_of_material by material
   * @param half_spacing from a particle of a full box to its face [m]
   * @param box_volume of such a particle [m^3]
   * @param friction Coulomb's coefficient of FieldInterface::contact [-]
   */
  FieldContact(const unsigned int degree = 3,
               const std::vector<unsigned int> &field_of_material = {},
               const FieldInterface kind = FieldInterface::slip,
               const double half_spacing = 0.,
               const double box_volume = 1.,
               const double friction = 0.);

  unsigned int n_fields() const
  {
    return n_fields_;
  }

  /// Finds the nodes that fields share, normals there and, for contact, gaps.
  /// @param masses at the nodes, by field. Collective.
  void find_interfaces(
    const TileGrid &grid,
    Particles &particles,
    const std::vector<const dealii::AlignedVector<double> *> &masses);

  /**
   * Changes velocities of own nodes.
   * @param velocities by field, three components from @p first on
   * @return the sum of the impulses' magnitudes [N s]
   */
  double apply(const std::vector<NodeValues *> &velocities,
               const unsigned int first,
               const std::size_t n_locally_owned_nodes) const;

private:
  /// Two fields that may meet.
  struct Pair
  {
    std::array<unsigned int, 2> fields;
    NodeValues normals{3}; ///< from the first to the second; zero: no meeting
    NodeValues gaps{1};    ///< between their surfaces [m]
  };

  /// Finds the tiles of this rank that reach nodes which fields share.
  void find_tiles(const TileGrid &grid);
  void find_gradients(const TileGrid &grid, Particles &particles);
  void find_normals(const TileGrid &grid, Pair &pair) const;
  void find_gap(const TileGrid &grid, Particles &particles, Pair &pair) const;
  /// Of the particles of a tile of a level. @param source its own window, or
  /// that of level 0 there
  void update_extents_of(const TileGrid &grid,
                         const TileGrid::Source &source,
                         const unsigned int level,
                         const Particles::TileBlocks &blocks,
                         const Pair &pair,
                         NodeValues &extents) const;
  double apply_impulse(const Pair &pair,
                       const std::uint32_t node,
                       NodeValues &a,
                       NodeValues &b,
                       const unsigned int first) const;

  unsigned int degree_;
  std::vector<unsigned int> field_of_material_;
  FieldInterface kind_;
  double half_spacing_;
  double box_volume_;
  double friction_;
  unsigned int n_fields_ = 0;
  std::vector<bool>
    has_shared_nodes_; ///< whether fields do in a tile, by source
  std::vector<NodeValues> gradients_;                 ///< of mass, by field
  std::vector<dealii::AlignedVector<double>> masses_; ///< own nodes, by field
  std::vector<Pair> pairs_;
};
} // namespace contrecoup::mpm
