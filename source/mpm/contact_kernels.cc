// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/contact_kernels.h>
#include <contrecoup/mpm/spline_support.h>

#include <algorithm>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int size = window_stride;
  constexpr int edge = TileGrid::window_edge;

  SplineWeights weights(const unsigned int degree, const double geometry)
  {
    return degree == 1   ? spline_weights<1>(geometry)
           : degree == 2 ? spline_weights<2>(geometry)
                         : spline_weights<3>(geometry);
  }

  /// Calls @p work(node of the window, its indices in the support) for all
  /// nodes in the spline support of a particle.
  template <typename Work>
  void for_each_node(const unsigned int degree,
                     const std::array<SplineWeights, 3> &axis,
                     const Work &work)
  {
    for (unsigned int k = 0; k <= degree; ++k)
      for (unsigned int j = 0; j <= degree; ++j)
        for (unsigned int i = 0; i <= degree; ++i)
        {
          const unsigned int index[] = {i, j, k};
          int at = 0;
          for (int d = 2; d >= 0; --d)
            at = edge * at + axis[d].first + int(index[d]) -
                 TileGrid::window_start;
          work(static_cast<unsigned int>(at), index);
        }
  }

  std::array<SplineWeights, 3> splines(const unsigned int degree,
                                       const ParticleBlock &particles,
                                       const std::size_t p,
                                       const WindowGeometry &geometry)
  {
    std::array<SplineWeights, 3> axis;
    // Round-off may put particles on the tile's lower sides outside.
    for (unsigned int d = 0; d < 3; ++d)
      axis[d] = weights(
        degree,
        std::max(0.,
                 (particles[column::position + d][p] - geometry.lower[d]) /
                   geometry.cell_size));
    return axis;
  }

  template <unsigned int degree>
  void add_gradients(SplineSupports<degree> &supports,
                     const ParticleBlock &particles,
                     const WindowGeometry &geometry,
                     double *const window)
  {
    for_each_support(
      particles,
      geometry,
      supports,
      [&](const SplineSupports<degree> &support,
          const std::size_t i,
          const std::size_t p) {
        const double mass = particles[column::mass][p];
        const Row x = support.x(i) * mass, slope_x = support.slope_x(i) * mass;
        for (unsigned int k = 0; k <= degree; ++k)
        {
          const double z = support.value(2, k, i);
          const Row along_x = slope_x * z, along_y = x * z,
                    along_z = x * support.slope(2, k, i);
          for (unsigned int j = 0; j <= degree; ++j)
          {
            double *const nodes = window + support.at(i, j, k);
            const double y = support.value(1, j, i);
            add_to(nodes, along_x, y);
            add_to(nodes + size, along_y, support.slope(1, j, i));
            add_to(nodes + 2 * size, along_z, y);
          }
        }
      });
  }
} // namespace


void add_mass_gradient(const unsigned int degree,
                       const ParticleBlock &particles,
                       const WindowGeometry &geometry,
                       double *const window)
{
  with_supports(degree, [&](auto &supports) {
    add_gradients(supports, particles, geometry, window);
  });
}


void update_extents(const unsigned int degree,
                    const ParticleBlock &particles,
                    const WindowGeometry &geometry,
                    const double sign,
                    const ParticleExtent &half,
                    const double *const normals,
                    double *const extents)
{
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    const auto axis = splines(degree, particles, p, geometry);
    const double face =
      half.spacing *
      std::min(1., particles[column::volume][p] / half.box_volume);
    for_each_node(
      degree, axis, [&](const unsigned int at, const unsigned int(&index)[3]) {
        double along = 0., norm = 0., weight = 1.;
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double node =
            geometry.lower[d] +
            geometry.cell_size * (axis[d].first + double(index[d]));
          const double normal = normals[size * d + at];
          along += normal * (particles[column::position + d][p] - node);
          norm += normal * normal;
          weight *= axis[d].value[index[d]];
        }
        if (norm > 0. && weight > 0.)
          extents[at] = std::max(extents[at], sign * along + face);
      });
  }
}
} // namespace contrecoup::mpm
