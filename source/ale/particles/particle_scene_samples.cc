// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/particles/particle_scene.h>

#include <algorithm>
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


double ParticleScene::n_particles() const
{
  double count = 0.;
  sample_matter(coarse_samples, [&](const dealii::Point<3> &place, const int) {
    count += std::pow(cell_size_ / cell_size_at(place), 3);
  });
  double particles = count / std::pow(coarse_samples, 3);
  for (unsigned int d = 0; d < 3; ++d)
    particles *= 1. * box_.n_cells[d] * source_.per_cell[d];
  return particles;
}
} // namespace contrecoup::ale
