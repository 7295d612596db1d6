// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/base/system/names.h>
#include <contrecoup/mpm/node_values.h>
#include <contrecoup/mpm/particles.h>
#include <contrecoup/mpm/transfer_kernels.h>

#include <array>
#include <vector>

namespace contrecoup::mpm
{
/// Interaction of two velocity fields at an interface.
enum class FieldInterface
{
  slip,
  contact
};

/// All interfaces, for entry and help text.
inline constexpr std::array<NamedChoice<FieldInterface>, 2> field_interfaces{
  {{FieldInterface::slip,
    "slip",
    "allows tangential motion alone, without friction"},
   {FieldInterface::contact,
    "contact",
    "allows separation as well, and friction in contact"}}};

/**
 * Contact between velocity fields. At nodes where more than one field has mass,
 * equal and opposite impulses act along the normal that follows from the mass
 * gradients; momentum is conserved. Bardenhagen and others, Comput. Methods
 * Appl. Mech. Eng. 187 (2000). The gap is measured between the faces of the
 * particles along the normal, not between the spline supports; otherwise
 * contact would begin as soon as supports overlap.
 */
class FieldContact
{
public:
  /**
   * @param field_of_material by material
   * @param half_spacing distance from a particle to its face if it fills its
   * box [m]
   * @param box_volume volume of such a particle [m^3]
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

  /// Finds the nodes that fields share, their normals and, for contact, the
  /// gaps.
  /// @param masses nodal masses by field [kg]. Collective.
  void find_interfaces(
    const TileGrid &grid,
    Particles &particles,
    const std::vector<const dealii::AlignedVector<double> *> &masses);

  /**
   * Applies the contact impulses to the velocities of owned nodes.
   * @param velocities by field; the components @p first to @p first + 2 are
   * used
   * @return sum of the magnitudes of the impulses on this rank [N s]
   */
  double apply(const std::vector<NodeValues *> &velocities,
               const unsigned int first,
               const std::size_t n_locally_owned_nodes) const;

private:
  /// Two fields that may be in contact.
  struct Pair
  {
    std::array<unsigned int, 2> fields;
    NodeValues normals{
      3}; ///< from the first field to the second; zero: no contact at this node
    NodeValues gaps{1}; ///< between the surfaces; contact if not positive [m]
  };

  /// Finds the tiles of this rank whose windows contain nodes shared by fields.
  void find_tiles(const TileGrid &grid);
  void find_gradients(const TileGrid &grid, Particles &particles);
  void find_normals(const TileGrid &grid, Pair &pair) const;
  void find_gap(const TileGrid &grid, Particles &particles, Pair &pair) const;
  /// Updates the extents with the particles of a tile.
  void update_extents_of(const TileGrid &grid,
                         const TileGrid::Source &source,
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
  std::vector<bool> has_shared_nodes_; ///< by source: whether the tile has
                                       ///< nodes shared by fields
  std::vector<NodeValues> gradients_;  ///< mass gradients, by field
  /// Masses of owned nodes, by field [kg].
  std::vector<dealii::AlignedVector<double>> masses_;
  std::vector<Pair> pairs_;
};
} // namespace contrecoup::mpm
