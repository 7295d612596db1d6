// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_scene.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Number of sample points along each direction.
  constexpr unsigned int coarse_samples = 48, most_samples = 400;

  /// Bound of the moves in lowest_matter().
  constexpr unsigned int most_moves = 2000;
} // namespace


void ParticleScene::sample_matter(
  const unsigned int n,
  const std::function<void(const dealii::Point<3> &, const int)> &work,
  const unsigned int across) const
{
  std::array<unsigned int, 3> size{{n, n, n}};
  if (across < 3)
    size[across] = 1;
  dealii::Point<3> place;
  for (unsigned int k = 0; k < size[2]; ++k)
    for (unsigned int j = 0; j < size[1]; ++j)
      for (unsigned int i = 0; i < size[0]; ++i)
      {
        const std::array<unsigned int, 3> at{{i, j, k}};
        for (unsigned int d = 0; d < 3; ++d)
          place[d] = d == across
                       ? 0.
                       : box_.lower[d] +
                           (at[d] + 0.5) / n * box_.n_cells[d] * box_.cell_size;
        const int material = source_.material_at(place);
        if (material != mpm::ParticleSource::none)
          work(place, material);
      }
}


std::vector<std::uint64_t> ParticleScene::count_matter() const
{
  std::vector<std::uint64_t> counts(materials_.size(), 0);
  const auto count = [&](const dealii::Point<3> &, const int material) {
    ++counts[material];
  };
  sample_matter(coarse_samples, count);
  if (std::find(counts.begin(), counts.end(), 0u) == counts.end())
    return counts;
  // Looks for thin regions with several points for each particle.
  double n = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    n = std::max(n, 4. * box_.n_cells[d] * source_.per_cell[d]);
  sample_matter(static_cast<unsigned int>(std::min<double>(n, most_samples)),
                count);
  return counts;
}


std::optional<dealii::Point<3>>
ParticleScene::lowest_matter(const dealii::Tensor<1, 3> &normal) const
{
  std::optional<dealii::Point<3>> lowest;
  const auto take = [&](const dealii::Point<3> &place, const int) {
    if (!lowest || (place - *lowest) * normal < 0.)
      lowest = place;
  };
  sample_matter(coarse_samples, take);
  double step = 0.;
  for (unsigned int d = 0; d < 3; ++d)
    step = std::max(step, box_.n_cells[d] * box_.cell_size / coarse_samples);
  // Descends along the surface from there, ever less steeply.
  const double least = 1e-7 * step;
  for (unsigned int n = 0; lowest && step > least && n < most_moves; ++n)
  {
    const dealii::Point<3> centre = *lowest;
    for (unsigned int i = 0; i < 27; ++i)
      for (double fall = step; fall > 1e-6 * step; fall *= 0.25)
      {
        dealii::Tensor<1, 3> way(
          {step * (i % 3 - 1.), step * (i / 3 % 3 - 1.), step * (i / 9 - 1.)});
        way -= (way * normal + fall) * normal;
        if (source_.material_at(centre + way) != mpm::ParticleSource::none)
          take(centre + way, 0);
      }
    if (*lowest == centre)
      step *= 0.5;
  }
  return lowest;
}


bool ParticleScene::is_near_matter(const dealii::Point<3> &place) const
{
  const double step = half_spacing();
  for (unsigned int i = 0; i < 27; ++i)
  {
    const dealii::Tensor<1, 3> way(
      {step * (i % 3 - 1.), step * (i / 3 % 3 - 1.), step * (i / 9 - 1.)});
    if (source_.material_at(place + way) != mpm::ParticleSource::none)
      return true;
  }
  return false;
}


unsigned int ParticleScene::n_materials_in(const dealii::Point<3> &lower) const
{
  // As far inside as the outermost samples of mpm::seed().
  constexpr std::array<double, 3> at = {{1. / 16., 15. / 16., 0.5}};
  std::vector<int> found;
  const auto look = [&](const double x, const double y, const double z) {
    dealii::Point<3> place = lower;
    const std::array<double, 3> parts{{x, y, z}};
    for (unsigned int d = 0; d < 3; ++d)
      place[d] += parts[d] * cell_size_ / source_.per_cell[d];
    const int material = source_.material_at(place);
    if (material != mpm::ParticleSource::none &&
        std::find(found.begin(), found.end(), material) == found.end())
      found.push_back(material);
  };
  for (unsigned int corner = 0; corner < 8; ++corner)
    look(at[corner & 1U], at[corner >> 1U & 1U], at[corner >> 2U & 1U]);
  look(at[2], at[2], at[2]);
  return static_cast<unsigned int>(found.size());
}


double ParticleScene::n_particles() const
{
  // Boxes with a particle of each material: all of them, or those at the points
  // of a lattice.
  std::array<unsigned int, 3> n{};
  double boxes_a_point = 1.;
  for (unsigned int d = 0; d < 3; ++d)
  {
    const double n_boxes = 1. * box_.n_cells[d] * source_.per_cell[d];
    n[d] = static_cast<unsigned int>(std::min(n_boxes, 1. * coarse_samples));
    boxes_a_point *= n_boxes / n[d];
  }
  double count = 0.;
  for (unsigned int k = 0; k < n[2]; ++k)
    for (unsigned int j = 0; j < n[1]; ++j)
      for (unsigned int i = 0; i < n[0]; ++i)
      {
        const std::array<unsigned int, 3> at{{i, j, k}};
        dealii::Point<3> place;
        for (unsigned int d = 0; d < 3; ++d)
          place[d] = box_.lower[d] +
                     (at[d] + 0.5) / n[d] * box_.n_cells[d] * box_.cell_size;
        dealii::Point<3> lower;
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double edge = cell_size_ / source_.per_cell[d];
          lower[d] =
            box_.lower[d] +
            edge * std::floor((place[d] - box_.lower[d]) / edge + 1e-9);
        }
        count += n_materials_in(lower);
      }
  return count * boxes_a_point;
}
} // namespace contrecoup::ale
