// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/head/impact_scene.h>
#include <contrecoup/mpm/field_contact.h>
#include <contrecoup/mpm/seeding.h>
#include <contrecoup/mpm/transfer_scheme.h>
#include <contrecoup/mpm/wall_contact.h>

#include <deal.II/base/parameter_handler.h>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace contrecoup::ale
{
/**
 * A scene for the material point method: mesh description, regions and planes
 * of a moving mesh, filled with particles, and the entries of subsection
 * "MPM".
 */
class ParticleScene
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);

  /// Reads subsection "MPM". @throws InputError
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for features that particles do not support
  void reinit(const ImpactScene &impact);

  const mpm::GridBox &box() const
  {
    return box_;
  }
  const mpm::TransferScheme &scheme() const
  {
    return scheme_;
  }
  const std::vector<mpm::ParticleMaterial> &materials() const
  {
    return materials_;
  }
  const mpm::ParticleSource &source() const
  {
    return source_;
  }
  /// Planes, and the sphere around a half ball.
  const std::vector<mpm::RigidWall> &walls() const
  {
    return walls_;
  }
  /// Largest number of particles of a material in a cell, beyond which they are
  /// merged.
  unsigned int largest_per_cell() const
  {
    return largest_per_cell_;
  }

  /// Contact between the velocity fields of the materials.
  mpm::FieldContact field_contact() const;

  /// Whether regions may separate after contact.
  bool regions_part() const;

  /// Half the particle spacing in full cells, along the shortest direction
  /// [m].
  double half_spacing() const;

  /// Size of grid cells [m].
  double cell_size() const
  {
    return cell_size_;
  }

  /// Calls @p work(place, material) at those points of a lattice over the box
  /// where there is matter.
  /// @param n points along each direction
  /// @param across axis along which there is one point, at 0; 3: none
  void sample_matter(
    const unsigned int n,
    const std::function<void(const dealii::Point<3> &, const int)> &work,
    const unsigned int across = 3) const;

  /// Number of sample points in each material; 0 where a lattice finer than the
  /// particles finds none.
  std::vector<std::uint64_t> count_matter() const;

  /// Position of matter with the least coordinate along a normal, to 1e-6 of a
  /// sample's size for convex bodies; nothing without matter [m].
  std::optional<dealii::Point<3>>
  lowest_matter(const dealii::Tensor<1, 3> &normal) const;

  /// Whether there is matter within half a particle spacing.
  bool is_near_matter(const dealii::Point<3> &place) const;

  /// Approximate number of particles [-].
  double n_particles() const;

private:
  /// Number of materials in a box that has a particle of each, see mpm::seed().
  /// @param lower corner [m]
  unsigned int n_materials_in(const dealii::Point<3> &lower) const;
  void make_materials(const RegionDescriptions &regions);
  void make_source(const MeshDescription &mesh,
                   const RegionDescriptions &regions);
  void make_box(const MeshDescription &mesh,
                const double largest_speed,
                const double end_time);

  double cell_size_ = 0.;
  mpm::TransferScheme scheme_;
  std::string smoothing_;
  std::string fields_;
  double friction_ = 0.;
  unsigned int largest_per_cell_ = 0;
  mpm::GridBox box_;
  std::vector<mpm::ParticleMaterial> materials_;
  mpm::ParticleSource source_;
  std::vector<mpm::RigidWall> walls_;
};
} // namespace contrecoup::ale
