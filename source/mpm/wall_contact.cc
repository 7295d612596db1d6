// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/mpm/wall_contact.h>

#include <deal.II/base/mpi.h>
#include <deal.II/physics/transformations.h>

#include <cmath>
#include <limits>

namespace contrecoup::mpm
{
namespace
{
  /// Number of lines per particle spacing, along each direction normal to the
  /// wall's normal.
  constexpr unsigned int lines_per_spacing = 3;

  /// A unit vector normal to another one.
  dealii::Tensor<1, 3> across(const dealii::Tensor<1, 3> &normal)
  {
    unsigned int smallest = 0;
    for (unsigned int d = 1; d < 3; ++d)
      if (std::abs(normal[d]) < std::abs(normal[smallest]))
        smallest = d;
    dealii::Tensor<1, 3> axis;
    axis[smallest] = 1.;
    const auto result = dealii::cross_product_3d(normal, axis);
    return result / result.norm();
  }

  /// Range of the coordinate along a direction, relative to a point, within the
  /// box of a grid.
  std::pair<double, double> extent(const GridBox &box,
                                   const dealii::Point<3> &point,
                                   const dealii::Tensor<1, 3> &direction)
  {
    std::pair<double, double> range(std::numeric_limits<double>::max(),
                                    -std::numeric_limits<double>::max());
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      dealii::Point<3> place = box.lower;
      for (unsigned int d = 0; d < 3; ++d)
        if ((corner >> d & 1) != 0)
          place[d] += box.n_cells[d] * box.cell_size;
      const double along = (place - point) * direction;
      range.first = std::min(range.first, along);
      range.second = std::max(range.second, along);
    }
    return range;
  }

  bool is_matter(const ParticleSource &source,
                 const TileGrid &grid,
                 const dealii::Point<3> &place)
  {
    return grid.is_inside(grid.cell_at(place)) &&
           source.material_at(place) != ParticleSource::none;
  }

  /// Finds the particle of a tile, and its material, that is nearest to a
  /// position.
  struct Nearest
  {
    double square = std::numeric_limits<double>::max();
    ParticleBlock *block = nullptr;
    std::size_t particle = 0;

    void look(Particles::TileBlocks &blocks, const dealii::Point<3> &place)
    {
      for (ParticleBlock &one : blocks)
        for (std::size_t p = 0; p < one.size(); ++p)
        {
          double distance = 0.;
          for (unsigned int d = 0; d < 3; ++d)
            distance += std::pow(one[column::position + d][p] - place[d], 2);
          if (distance < square)
          {
            square = distance;
            block = &one;
            particle = p;
          }
        }
    }
  };

  /// Adds a surface element to the nearest particle.
  void add_piece(const dealii::Point<3> &place,
                 const dealii::Point<3> &inside,
                 const double area,
                 const TileGrid &grid,
                 Particles &particles)
  {
    if (!grid.is_inside(grid.cell_at(inside)))
      return;
    const auto tile = particles.tiles().find(grid.tile_at(inside));
    if (tile == particles.tiles().end())
      return;
    Nearest nearest;
    nearest.look(tile->second, place);
    if (nearest.block == nullptr)
      return;
    ParticleBlock &block = *nearest.block;
    block[column::area][nearest.particle] += area;
    for (unsigned int d = 0; d < 3; ++d)
      block[column::surface + d][nearest.particle] +=
        area * (place[d] - block[column::position + d][nearest.particle]);
  }

  double spacing_of(const ParticleSource &source, const TileGrid &grid)
  {
    return grid.box().cell_size /
           std::max(
             {source.per_cell[0], source.per_cell[1], source.per_cell[2]});
  }
} // namespace


void WallContact::find_at_plane(const RigidWall &wall,
                                const ParticleSource &source,
                                const TileGrid &grid,
                                Particles &particles) const
{
  const GridBox &box = grid.box();
  const double spacing = spacing_of(source, grid);
  const double width = spacing / lines_per_spacing;
  const auto first = across(wall.normal);
  const auto second = dealii::cross_product_3d(wall.normal, first);
  const auto range = extent(box, wall.point, wall.normal),
             range_1 = extent(box, wall.point, first),
             range_2 = extent(box, wall.point, second);
  double lowest = 0.;
  for (double b = range_2.first + 0.5 * width; b < range_2.second; b += width)
    for (double a = range_1.first + 0.5 * width; a < range_1.second; a += width)
    {
      const auto at = [&](const double height) {
        return wall.point + a * first + b * second + height * wall.normal;
      };
      double height = range.first, step = 0.5 * spacing;
      while (height < range.second && !is_matter(source, grid, at(height)))
        height += step;
      if (height >= range.second)
        continue;
      for (unsigned int i = 0; i < 30; ++i)
      {
        step *= 0.5;
        height += is_matter(source, grid, at(height)) ? -step : step;
      }
      lowest = std::min(lowest, height);
      add_piece(at(height),
                at(height + 1e-3 * spacing),
                width * width,
                grid,
                particles);
    }
  if (lowest < -1e-6 * box.cell_size)
    throw InputError("Plane " + wall.name +
                     ": it cuts the matter at the start, which reaches " +
                     brief(-lowest) +
                     " m behind it; move Point, or turn Normal to the side of "
                     "the matter");
}


void WallContact::find_at_sphere(const RigidWall &wall,
                                 const ParticleSource &source,
                                 const TileGrid &grid,
                                 Particles &particles) const
{
  const double spacing = spacing_of(source, grid);
  const double width = spacing / lines_per_spacing;
  const double pi = dealii::numbers::PI;
  const unsigned int n_rings = std::ceil(pi * wall.radius / width);
  for (unsigned int i = 0; i < n_rings; ++i)
  {
    const double lower = std::cos(pi * (i + 1) / n_rings),
                 upper = std::cos(pi * i / n_rings);
    const double height = 0.5 * (lower + upper);
    const double ring = std::sqrt(1. - height * height);
    const unsigned int n =
      4 * std::max(1., std::ceil(0.5 * pi * ring * wall.radius / width));
    for (unsigned int j = 0; j < n; ++j)
    {
      const double angle = 2. * pi * (j + 0.5) / n;
      const dealii::Tensor<1, 3> direction(
        {ring * std::cos(angle), ring * std::sin(angle), height});
      add_piece(wall.point + wall.radius * direction,
                wall.point + (wall.radius - 0.25 * spacing) * direction,
                2. * pi / n * (upper - lower) * wall.radius * wall.radius,
                grid,
                particles);
    }
  }
}


void WallContact::find_surface(const ParticleSource &source,
                               const TileGrid &grid,
                               Particles &particles) const
{
  for (const RigidWall &wall : walls_)
    if (wall.radius > 0.)
      find_at_sphere(wall, source, grid, particles);
    else
      find_at_plane(wall, source, grid, particles);
  particles.for_each_block([&](unsigned int, ParticleBlock &block) {
    for (std::size_t p = 0; p < block.size(); ++p)
      if (const double area = block[column::area][p]; area > 0.)
      {
        dealii::Point<3> place;
        for (unsigned int d = 0; d < 3; ++d)
          place[d] = block[column::position + d][p] +
                     (block[column::surface + d][p] /= area);
        // The centroid of an element of a sphere is not on the sphere.
        for (const RigidWall &wall : walls_)
          if (wall.is_adhesive)
            for (unsigned int d = 0; d < 3; ++d)
              block[column::surface + d][p] +=
                wall.depth(place) * wall.normal_at(place)[d];
      }
  });
}


void WallContact::apply_force(const RigidWall &wall,
                              const double stiffness,
                              const std::size_t particle,
                              ParticleBlock &particles)
{
  dealii::Point<3> place;
  dealii::Tensor<1, 3> velocity;
  for (unsigned int d = 0; d < 3; ++d)
  {
    place[d] = particles[column::position + d][particle] +
               particles[column::surface + d][particle];
    for (unsigned int e = 0; e < 3; ++e)
      place[d] += particles[column::gradient + 3 * d + e][particle] *
                  particles[column::surface + e][particle];
    velocity[d] = particles[column::velocity + d][particle];
  }
  const double depth = wall.depth(place);
  if (!(depth > 0. || wall.is_adhesive))
    return;
  const double area = particles[column::area][particle];
  const double press = stiffness * depth * area;
  const auto normal = wall.normal_at(place);
  const auto along = velocity - (velocity * normal) * normal;
  // Friction stops motion but does not reverse it.
  constexpr double slowest = 1e-6;
  const auto friction =
    -wall.friction * press / std::max(along.norm(), slowest) * along;
  const auto force = press * normal + friction;
  // The moment arises because the force acts at the surface, not at the
  // particle.
  dealii::Tensor<1, 3> arm;
  for (unsigned int d = 0; d < 3; ++d)
  {
    particles[column::force + d][particle] += force[d];
    arm[d] = place[d] - particles[column::position + d][particle];
  }
  for (unsigned int k = 0; k < 6; ++k)
  {
    const unsigned int i = k % 3, j = k < 3 ? i : (i + 1) % 3;
    particles[column::moment + k][particle] +=
      0.5 * (force[i] * arm[j] + force[j] * arm[i]);
  }
  measures_.force += press;
  measures_.friction_power += friction * velocity;
  // Uses the grid velocity, without the deviation of particle velocities from
  // it.
  dealii::Tensor<1, 3> slide;
  for (unsigned int d = 0; d < 3; ++d)
    slide[d] = particles[column::position_change + d][particle];
  slide -= (slide * normal) * normal;
  measures_.sliding += press * slide.norm();
  measures_.area += area;
}


void WallContact::add_forces(const ParticleMaterial &material,
                             const TileGrid &grid,
                             ParticleBlock &particles)
{
  const SolidMaterial *const solid = material.solid();
  const double speed = solid != nullptr
                         ? solid->dilatational_speed()
                         : largest_sound_speed(material, particles);
  for (unsigned int k = 0; k < 6; ++k)
    std::fill_n(particles[column::moment + k], particles.size(), 0.);
  for (std::size_t p = 0; p < particles.size(); ++p)
    if (particles[column::area][p] > 0.)
    {
      const double stiffness = material.density() * speed * speed /
                               (thickness_ * grid.box().cell_size);
      for (const RigidWall &wall : walls_)
        apply_force(wall, stiffness, p, particles);
    }
}
} // namespace contrecoup::mpm
