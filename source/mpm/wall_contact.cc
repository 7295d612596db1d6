// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/text.h>
#include <contrecoup/mpm/wall_contact.h>

#include <deal.II/base/mpi.h>
#include <deal.II/physics/transformations.h>

#include <cmath>
#include <limits>

namespace contrecoup::mpm
{
namespace
{
  /// Lines per spacing of particles, along each direction across the normal.
  constexpr unsigned int lines_per_spacing = 3;

  /// A unit vector across another.
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

  /// Range of the box of a grid along a direction from a point.
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

  /// The particle of a tile and its material that is nearest to a place.
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

  /// Adds a piece of the surface to a particle: its area, and area times way.
  void
  add_piece(const Nearest &at, const dealii::Point<3> &place, const double area)
  {
    ParticleBlock &block = *at.block;
    block[column::area][at.particle] += area;
    for (unsigned int d = 0; d < 3; ++d)
      block[column::surface + d][at.particle] +=
        area * (place[d] - block[column::position + d][at.particle]);
  }
} // namespace


void WallContact::find_surface(const ParticleSource &source,
                               const TileGrid &grid,
                               Particles &particles) const
{
  const GridBox &box = grid.box();
  const double spacing =
    box.cell_size /
    std::max({source.per_cell[0], source.per_cell[1], source.per_cell[2]});
  const double width = spacing / lines_per_spacing;
  for (const RigidPlane &plane : planes_)
  {
    const auto first = across(plane.normal);
    const auto second = dealii::cross_product_3d(plane.normal, first);
    const auto range = extent(box, plane.point, plane.normal),
               range_1 = extent(box, plane.point, first),
               range_2 = extent(box, plane.point, second);
    for (double b = range_2.first + 0.5 * width; b < range_2.second; b += width)
      for (double a = range_1.first + 0.5 * width; a < range_1.second;
           a += width)
      {
        const auto at = [&](const double height) {
          return plane.point + a * first + b * second + height * plane.normal;
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
        if (height < -1e-6 * box.cell_size)
          throw InputError("Plane " + plane.name +
                           ": it cuts the matter at the start, which reaches " +
                           brief(-height) +
                           " m behind it; move Point, or turn Normal to the "
                           "side of the matter");
        const auto inside = at(height + 1e-3 * spacing);
        const auto cell = grid.cell_at(inside);
        if (!grid.is_inside(cell))
          continue;
        const auto tile = particles.tiles().find(grid.tile_of(cell));
        if (tile == particles.tiles().end())
          continue;
        Nearest nearest;
        nearest.look(tile->second, at(height));
        if (nearest.block != nullptr)
          add_piece(nearest, at(height), width * width);
      }
  }
  particles.for_each_block([](unsigned int, ParticleBlock &block) {
    for (std::size_t p = 0; p < block.size(); ++p)
      if (const double area = block[column::area][p]; area > 0.)
        for (unsigned int d = 0; d < 3; ++d)
          block[column::surface + d][p] /= area;
  });
}


void WallContact::add_forces(const ParticleMaterial &material,
                             const double cell_size,
                             ParticleBlock &particles)
{
  const SolidMaterial *const solid = material.solid();
  const double speed = solid != nullptr
                         ? solid->dilatational_speed()
                         : largest_sound_speed(material, particles);
  const double stiffness =
    material.density() * speed * speed / (thickness_ * cell_size);
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    const double area = particles[column::area][p];
    if (!(area > 0.))
      continue;
    dealii::Point<3> place;
    dealii::Tensor<1, 3> velocity;
    for (unsigned int d = 0; d < 3; ++d)
    {
      place[d] =
        particles[column::position + d][p] + particles[column::surface + d][p];
      for (unsigned int e = 0; e < 3; ++e)
        place[d] += particles[column::gradient + 3 * d + e][p] *
                    particles[column::surface + e][p];
      velocity[d] = particles[column::velocity + d][p];
    }
    for (const RigidPlane &plane : planes_)
    {
      const double depth = (plane.point - place) * plane.normal;
      if (!(depth > 0.))
        continue;
      const double press = stiffness * depth * area;
      auto along = velocity - (velocity * plane.normal) * plane.normal;
      // Rest is not turned into motion the other way.
      const double slowest = 1e-3 * speed * depth / cell_size + 1e-12;
      const auto force =
        press * plane.normal -
        plane.friction * press / std::max(along.norm(), slowest) * along;
      for (unsigned int d = 0; d < 3; ++d)
        particles[column::force + d][p] += force[d];
      measures_.force += press;
      measures_.area += area;
    }
  }
}
} // namespace contrecoup::mpm
