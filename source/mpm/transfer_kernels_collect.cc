// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/spline_support.h>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int stride = window_stride;

  /// Sums over the rows of a support: n components with the values as weights,
  /// and the last three components also with other weights along y and z.
  template <unsigned int n_components>
  struct Sums
  {
    static constexpr unsigned int first_vector = n_components - 3;
    Row value[n_components], along_y[3], along_z[3];

    /// @param other_y,other_z other weights, by node
    template <unsigned int degree, typename OtherY, typename OtherZ>
    DEAL_II_ALWAYS_INLINE Sums(const SplineSupports<degree> &support,
                               const std::size_t i,
                               const double *const window,
                               const OtherY &other_y,
                               const OtherZ &other_z)
    {
      for (Row &row : value)
        row = Row(0.);
      for (unsigned int d = 0; d < 3; ++d)
        along_y[d] = along_z[d] = Row(0.);
      for (unsigned int k = 0; k <= degree; ++k)
      {
        Row plane[n_components], plane_y[3];
        for (Row &row : plane)
          row = Row(0.);
        for (Row &row : plane_y)
          row = Row(0.);
        for (unsigned int j = 0; j <= degree; ++j)
        {
          const double *const nodes = window + support.at(i, j, k);
          const double y = support.value(1, j, i), other = other_y(j);
          for (unsigned int c = 0; c < n_components; ++c)
          {
            const Row row = Row::load(nodes + stride * c);
            plane[c].add(row, y);
            if (c >= first_vector)
              plane_y[c - first_vector].add(row, other);
          }
        }
        const double z = support.value(2, k, i), other = other_z(k);
        for (unsigned int c = 0; c < n_components; ++c)
          value[c].add(plane[c], z);
        for (unsigned int d = 0; d < 3; ++d)
        {
          along_y[d].add(plane_y[d], z);
          along_z[d].add(plane[first_vector + d], other);
        }
      }
    }

    /// Stores a tensor by rows. @param x,other_x weights along x
    DEAL_II_ALWAYS_INLINE void store_tensor(const Row &x,
                                            const Row &other_x,
                                            ParticleBlock &particles,
                                            const unsigned int first,
                                            const std::size_t p) const
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        particles[first + 3 * d][p] = value[first_vector + d].dot(other_x);
        particles[first + 3 * d + 1][p] = along_y[d].dot(x);
        particles[first + 3 * d + 2][p] = along_z[d].dot(x);
      }
    }
  };

  /// Sums with the slopes as the other weights.
  template <unsigned int n_components, unsigned int degree>
  inline DEAL_II_ALWAYS_INLINE Sums<n_components>
  slope_sums(const SplineSupports<degree> &support,
             const std::size_t i,
             const double *const window)
  {
    return {support,
            i,
            window,
            [&](const unsigned int j) { return support.slope(1, j, i); },
            [&](const unsigned int k) { return support.slope(2, k, i); }};
  }

  template <unsigned int degree>
  void motion(SplineSupports<degree> &supports,
              const double step,
              const double *const window,
              const WindowGeometry &geometry,
              ParticleBlock &particles)
  {
    for_each_support(
      particles,
      geometry,
      supports,
      [&](const SplineSupports<degree> &support,
          const std::size_t i,
          const std::size_t p) {
        const auto sums = slope_sums<6>(support, i, window);
        const Row x = support.x(i);
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double change = step * sums.value[d].dot(x);
          particles[column::velocity_change + d][p] = change;
          particles[column::position_change + d][p] =
            step * (sums.value[3 + d].dot(x) + 0.5 * change);
        }
        sums.store_tensor(
          x, support.slope_x(i), particles, column::mean_rate, p);
      });
  }

  template <unsigned int degree>
  void rate(SplineSupports<degree> &supports,
            const double *const window,
            const WindowGeometry &geometry,
            ParticleBlock &particles)
  {
    for_each_support(particles,
                     geometry,
                     supports,
                     [&](const SplineSupports<degree> &support,
                         const std::size_t i,
                         const std::size_t p) {
                       slope_sums<3>(support, i, window)
                         .store_tensor(support.x(i),
                                       support.slope_x(i),
                                       particles,
                                       column::velocity_gradient,
                                       p);
                     });
  }

  template <unsigned int degree>
  void affine(SplineSupports<degree> &supports,
              const double *const window,
              const WindowGeometry &geometry,
              ParticleBlock &particles)
  {
    const double h = geometry.cell_size,
                 per_inertia = 1. / (spline_inertia(degree) * h * h);
    const int edge = TileGrid::window_edge;
    for_each_support(
      particles,
      geometry,
      supports,
      [&](const SplineSupports<degree> &support,
          const std::size_t i,
          const std::size_t p) {
        const int first = support.at(i, 0, 0);
        const int node[] = {
          first % edge, first / edge % edge, first / edge / edge};
        // Distance to a node over the moment of inertia, times the weight of
        // the node.
        const auto arm = [&](const unsigned int d, const unsigned int j) {
          return support.value(d, j, i) * per_inertia *
                 (geometry.lower[d] +
                  h * (node[d] + TileGrid::window_start + int(j)) -
                  particles[column::position + d][p]);
        };
        const std::array<double, 4> x_arms{
          {arm(0, 0), arm(0, 1), arm(0, 2), arm(0, 3)}};
        const Sums<3> sums(
          support,
          i,
          window,
          [&](const unsigned int j) { return arm(1, j); },
          [&](const unsigned int k) { return arm(2, k); });
        sums.store_tensor(
          support.x(i), Row::load(x_arms.data()), particles, column::affine, p);
      });
  }
} // namespace


void collect_motion(const unsigned int degree,
                    const double step,
                    const double *const window,
                    const WindowGeometry &geometry,
                    ParticleBlock &particles)
{
  with_supports(degree, [&](auto &supports) {
    motion(supports, step, window, geometry, particles);
  });
}


void collect_rate(const unsigned int degree,
                  const double *const window,
                  const WindowGeometry &geometry,
                  ParticleBlock &particles)
{
  with_supports(degree, [&](auto &supports) {
    rate(supports, window, geometry, particles);
  });
}


void collect_affine(const unsigned int degree,
                    const double *const window,
                    const WindowGeometry &geometry,
                    ParticleBlock &particles)
{
  with_supports(degree, [&](auto &supports) {
    affine(supports, window, geometry, particles);
  });
}


void collect_scalar(const double *const window,
                    const WindowGeometry &geometry,
                    const ParticleBlock &particles,
                    double *const value)
{
  static thread_local SplineSupports<1> supports;
  for_each_support(
    particles,
    geometry,
    supports,
    [&](const SplineSupports<1> &support,
        const std::size_t in_batch,
        const std::size_t p) {
      double sum = 0.;
      for_each_corner(
        support, in_batch, [&](const std::size_t at, const double share) {
          sum += share * window[at];
        });
      value[p] = sum;
    });
}
} // namespace contrecoup::mpm
