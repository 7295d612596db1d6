// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/contact_kernels.h>
#include <contrecoup/mpm/field_contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int size = window_stride;

  /// Fraction of the nodal mass above which a field takes part in contact
  /// there.
  constexpr double smallest_fraction = 1e-8;

  /// Whether the window of a tile contains a marked node.
  bool reaches(const TileGrid::Source &source,
               const dealii::AlignedVector<double> &marks)
  {
    return std::any_of(
      source.nodes.begin(), source.nodes.end(), [&](const std::uint32_t node) {
        return node != TileGrid::no_node && marks[node] > 0.;
      });
  }

  /// Number of sweeps over the pairs at nodes with three fields: the impulses
  /// of one pair disturb the others, and a single sweep can add energy.
  constexpr unsigned int n_sweeps = 4;

  bool is_shared(const double mass_a, const double mass_b)
  {
    return std::min(mass_a, mass_b) > smallest_fraction * (mass_a + mass_b);
  }
} // namespace


FieldContact::FieldContact(const unsigned int degree,
                           const std::vector<unsigned int> &field_of_material,
                           const FieldInterface kind,
                           const double half_spacing,
                           const double box_volume,
                           const double friction)
  : degree_(degree)
  , field_of_material_(field_of_material)
  , kind_(kind)
  , half_spacing_(half_spacing)
  , box_volume_(box_volume)
  , friction_(friction)
{
  for (const unsigned int field : field_of_material)
    n_fields_ = std::max(n_fields_, field + 1);
  gradients_.assign(n_fields_, NodeValues(3));
  for (unsigned int a = 0; a < n_fields_; ++a)
    for (unsigned int b = a + 1; b < n_fields_; ++b)
    {
      pairs_.emplace_back();
      pairs_.back().fields = {{a, b}};
    }
}


void FieldContact::find_tiles(const TileGrid &grid)
{
  NodeValues shared(1);
  shared.clear(grid);
  for (const Pair &pair : pairs_)
  {
    const auto &mass_a = masses_[pair.fields[0]],
               &mass_b = masses_[pair.fields[1]];
    for (std::uint32_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
      if (is_shared(mass_a[n], mass_b[n]))
        shared[0][n] = 1.;
  }
  shared.update_ghost_values(grid);
  has_shared_nodes_.clear();
  for (const TileGrid::Source &source : grid.sources())
    has_shared_nodes_.push_back(reaches(source, shared[0]));
}


void FieldContact::find_gradients(const TileGrid &grid, Particles &particles)
{
  for (NodeValues &gradient : gradients_)
    gradient.clear(grid);
  Window window(3 * size);
  auto source = grid.sources().begin();
  auto meets = has_shared_nodes_.begin();
  for (auto &tile : particles.tiles())
  {
    for (unsigned int field = 0; field < n_fields_ && *meets; ++field)
    {
      window.fill(0.);
      bool any = false;
      for (unsigned int m = 0; m < field_of_material_.size(); ++m)
        if (field_of_material_[m] == field && tile.second[m].size() > 0)
        {
          any = true;
          add_mass_gradient(degree_,
                            tile.second[m],
                            window_geometry(grid, *source),
                            window.data());
        }
      if (any)
        add_window(
          *source, window.data(), 0, gradient_parity, gradients_[field]);
    }
    ++source;
    ++meets;
  }
  for (NodeValues &gradient : gradients_)
  {
    gradient.compress_add(grid);
    // The mirror image cancels the component normal to the side.
    for (unsigned int d = 0; d < 3; ++d)
      for (const std::uint32_t n : grid.plane_nodes()[d])
        gradient[d][n] = 0.;
  }
}


void FieldContact::find_normals(const TileGrid &grid, Pair &pair) const
{
  pair.normals.clear(grid);
  const auto &mass_a = masses_[pair.fields[0]],
             &mass_b = masses_[pair.fields[1]];
  const NodeValues &gradient_a = gradients_[pair.fields[0]],
                   &gradient_b = gradients_[pair.fields[1]];
  for (std::uint32_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
  {
    const double a = mass_a[n], b = mass_b[n];
    if (!is_shared(a, b))
      continue;
    dealii::Tensor<1, 3> normal;
    // Sums of mass times slope of the nodal spline point out of the matter.
    for (unsigned int d = 0; d < 3; ++d)
      normal[d] = gradient_a[d][n] / a - gradient_b[d][n] / b;
    const double norm = normal.norm();
    for (unsigned int d = 0; d < 3 && norm > 0.; ++d)
      pair.normals[d][n] = normal[d] / norm;
  }
}


void FieldContact::update_extents_of(const TileGrid &grid,
                                     const TileGrid::Source &source,
                                     const Particles::TileBlocks &blocks,
                                     const Pair &pair,
                                     NodeValues &extents) const
{
  constexpr double none = -std::numeric_limits<double>::max();
  const ParticleExtent half{half_spacing_, box_volume_};
  Window normals(3 * size), window(size);
  read_window(source, pair.normals, 0, gradient_parity, normals.data());
  for (unsigned int side = 0; side < 2; ++side)
  {
    window.fill(none);
    for (unsigned int m = 0; m < field_of_material_.size(); ++m)
      if (field_of_material_[m] == pair.fields[side])
        update_extents(degree_,
                       blocks[m],
                       window_geometry(grid, source),
                       side == 0 ? 1. : -1.,
                       half,
                       normals.data(),
                       window.data());
    raise_nodes(source, window.data(), extents[side]);
  }
}


void FieldContact::find_gap(const TileGrid &grid,
                            Particles &particles,
                            Pair &pair) const
{
  pair.normals.update_ghost_values(grid);
  NodeValues extents(2);
  extents.clear(grid);
  for (unsigned int side = 0; side < 2; ++side)
    extents[side].fill(-std::numeric_limits<double>::max());
  auto source = grid.sources().begin();
  auto meets = has_shared_nodes_.begin();
  for (auto &tile : particles.tiles())
  {
    if (*meets)
      update_extents_of(grid, *source, tile.second, pair, extents);
    ++source;
    ++meets;
  }
  extents.compress_max(grid);
  pair.gaps.clear(grid);
  for (std::uint32_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
    pair.gaps[0][n] = -extents[0][n] - extents[1][n];
}


void FieldContact::find_interfaces(
  const TileGrid &grid,
  Particles &particles,
  const std::vector<const dealii::AlignedVector<double> *> &masses)
{
  if (n_fields_ < 2)
    return;
  masses_.clear();
  for (const auto *const mass : masses)
    masses_.push_back(*mass);
  find_tiles(grid);
  find_gradients(grid, particles);
  for (Pair &pair : pairs_)
  {
    find_normals(grid, pair);
    if (kind_ == FieldInterface::contact)
      find_gap(grid, particles, pair);
  }
}


double FieldContact::apply_impulse(const Pair &pair,
                                   const std::uint32_t node,
                                   NodeValues &a,
                                   NodeValues &b,
                                   const unsigned int first) const
{
  dealii::Tensor<1, 3> normal,
    relative_velocity; // of the first field relative to the second
  for (unsigned int d = 0; d < 3; ++d)
  {
    normal[d] = pair.normals[d][node];
    relative_velocity[d] = a[first + d][node] - b[first + d][node];
  }
  const double closing = relative_velocity * normal;
  if (!(normal.norm_square() > 0.) ||
      (kind_ == FieldInterface::contact &&
       (closing <= 0. || pair.gaps[0][node] > 0.)))
    return 0.;
  const auto along = relative_velocity - closing * normal;
  dealii::Tensor<1, 3> change = closing * normal;
  if (kind_ == FieldInterface::contact && along.norm() > 0.)
    change += std::min(1., friction_ * closing / along.norm()) * along;
  const double mass_a = masses_[pair.fields[0]][node],
               mass_b = masses_[pair.fields[1]][node];
  const double reduced = mass_a * mass_b / (mass_a + mass_b);
  for (unsigned int d = 0; d < 3; ++d)
  {
    a[first + d][node] -= reduced * change[d] / mass_a;
    b[first + d][node] += reduced * change[d] / mass_b;
  }
  return reduced * change.norm();
}


double FieldContact::apply(const std::vector<NodeValues *> &velocities,
                           const unsigned int first,
                           const std::size_t n_locally_owned_nodes) const
{
  double sum = 0.;
  for (std::uint32_t n = 0; n < n_locally_owned_nodes; ++n)
  {
    const auto n_met =
      std::count_if(pairs_.begin(), pairs_.end(), [&](const Pair &pair) {
        return pair.normals[0][n] != 0. || pair.normals[1][n] != 0. ||
               pair.normals[2][n] != 0.;
      });
    if (n_met == 0)
      continue;
    for (unsigned int sweep = 0; sweep < (n_met > 1 ? n_sweeps : 1); ++sweep)
      for (const Pair &pair : pairs_)
        sum += apply_impulse(pair,
                             n,
                             *velocities[pair.fields[0]],
                             *velocities[pair.fields[1]],
                             first);
  }
  return sum;
}
} // namespace contrecoup::mpm
