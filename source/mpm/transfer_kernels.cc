// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/spline_support.h>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int stride = window_stride;

  /// Three components at the nodes of a support, as rows along x that are
  /// multiplied by the particle's weights along y and z.
  struct VectorRows
  {
    Row plain[3];   ///< weights along y and z
    Row along_y[3]; ///< with the other weights along y
    Row along_z[3]; ///< with the other weights along z
  };

  /// Momentum m (v + C (x_i - x_p)); the other weights are the values times the
  /// index of the node.
  template <unsigned int degree>
  inline DEAL_II_ALWAYS_INLINE void
  set_affine_momentum(const SplineSupports<degree> &support,
                      const std::size_t in_batch,
                      const ParticleBlock &particles,
                      const std::size_t p,
                      const WindowGeometry &geometry,
                      VectorRows &rows)
  {
    constexpr std::array<double, 4> numbers{{0., 1., 2., 3.}};
    const Row along = Row::load(numbers.data()), x = support.x(in_batch);
    const double mass = particles[column::mass][p], h = geometry.cell_size;
    const int edge = TileGrid::window_edge;
    const int first = support.at(in_batch, 0, 0);
    const int node[] = {first % edge, first / edge % edge, first / edge / edge};
    for (unsigned int d = 0; d < 3; ++d)
    {
      double velocity = particles[column::velocity + d][p], slope[3];
      for (unsigned int e = 0; e < 3; ++e)
      {
        const double c = particles[column::affine + 3 * d + e][p];
        const double start =
          geometry.lower[e] + h * (node[e] + TileGrid::window_start);
        velocity += c * (start - particles[column::position + e][p]);
        slope[e] = mass * c * h;
      }
      Row value(mass * velocity);
      value.add(along, slope[0]);
      rows.plain[d] = x * value;
      rows.along_y[d] = x * slope[1];
      rows.along_z[d] = x * slope[2];
    }
  }

  /// Minus stress times volume of a particle (Kirchhoff stress times undeformed
  /// volume, smoothed pressure times smoothed volume), plus the moment of the
  /// external force.
  inline DEAL_II_ALWAYS_INLINE std::array<double, 6>
  minus_stress(const ParticleBlock &particles, const std::size_t p)
  {
    const double volume = particles[column::volume][p];
    std::array<double, 6> result;
    for (unsigned int k = 0; k < 6; ++k)
      result[k] = particles[column::moment + k][p] -
                  volume * particles[column::stress + k][p];
    const double pressure = volume * (1. + particles[column::dilatation][p]) *
                            particles[column::smoothed][p];
    for (unsigned int d = 0; d < 3; ++d)
      result[d] += pressure;
    return result;
  }

  /// Force of stresses and external forces; the other weights are the slopes.
  template <unsigned int degree>
  inline DEAL_II_ALWAYS_INLINE void
  set_force(const SplineSupports<degree> &support,
            const std::size_t in_batch,
            const ParticleBlock &particles,
            const std::size_t p,
            VectorRows &rows)
  {
    // Rows of the symmetric tensor stored as xx, yy, zz, xy, yz, zx.
    constexpr unsigned int entry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    const Row x = support.x(in_batch), slope_x = support.slope_x(in_batch);
    const std::array<double, 6> s = minus_stress(particles, p);
    for (unsigned int d = 0; d < 3; ++d)
    {
      rows.plain[d] = slope_x * s[entry[d][0]];
      rows.plain[d].add(x, particles[column::force + d][p]);
      rows.along_y[d] = x * s[entry[d][1]];
      rows.along_z[d] = x * s[entry[d][2]];
    }
  }

  /// For the rows at one z index.
  inline DEAL_II_ALWAYS_INLINE void at_height(const VectorRows &rows,
                                              const double value,
                                              const double other,
                                              Row (&plain)[3],
                                              Row (&along_y)[3])
  {
    for (unsigned int d = 0; d < 3; ++d)
    {
      plain[d] = rows.plain[d] * value;
      plain[d].add(rows.along_z[d], other);
      along_y[d] = rows.along_y[d] * value;
    }
  }

  template <bool has_momentum, bool has_force, unsigned int degree>
  void deposit_plain(SplineSupports<degree> &supports,
                     const ParticleBlock &particles,
                     const WindowGeometry &geometry,
                     double *const window)
  {
    constexpr unsigned int n = degree + 1;
    double *const forces = window + (has_momentum ? 4 * stride : 0);
    for_each_support(
      particles,
      geometry,
      supports,
      [&](const SplineSupports<degree> &support,
          const std::size_t i,
          const std::size_t p) {
        VectorRows force;
        if constexpr (has_force)
          set_force(support, i, particles, p, force);
        const Row mass_row = support.x(i) * particles[column::mass][p];
        Row velocity[3];
        for (unsigned int d = 0; d < 3; ++d)
          velocity[d] = Row(particles[column::velocity + d][p]);
        for (unsigned int k = 0; k < n; ++k)
        {
          const double z = support.value(2, k, i);
          const Row mass = mass_row * z;
          Row momentum[3], plain[3], along_y[3];
          for (unsigned int d = 0; d < 3; ++d)
            momentum[d] = mass * velocity[d];
          if constexpr (has_force)
            at_height(force, z, support.slope(2, k, i), plain, along_y);
          for (unsigned int j = 0; j < n; ++j)
          {
            const double y = support.value(1, j, i),
                         slope_y = support.slope(1, j, i);
            const std::size_t at = support.at(i, j, k);
            if constexpr (has_momentum)
            {
              add_to(window + at, mass, y);
              for (unsigned int d = 0; d < 3; ++d)
                add_to(window + stride * (1 + d) + at, momentum[d], y);
            }
            if constexpr (has_force)
              for (unsigned int d = 0; d < 3; ++d)
                add_to(
                  forces + stride * d + at, plain[d], y, along_y[d], slope_y);
          }
        }
      });
  }

  template <unsigned int degree>
  void deposit_affine(SplineSupports<degree> &supports,
                      const ParticleBlock &particles,
                      const WindowGeometry &geometry,
                      double *const window)
  {
    constexpr unsigned int n = degree + 1;
    for_each_support(
      particles,
      geometry,
      supports,
      [&](const SplineSupports<degree> &support,
          const std::size_t i,
          const std::size_t p) {
        VectorRows momentum;
        set_affine_momentum(support, i, particles, p, geometry, momentum);
        const Row mass_row = support.x(i) * particles[column::mass][p];
        for (unsigned int k = 0; k < n; ++k)
        {
          const double z = support.value(2, k, i);
          const Row mass = mass_row * z;
          Row plain[3], along_y[3];
          at_height(momentum, z, k * z, plain, along_y);
          for (unsigned int j = 0; j < n; ++j)
          {
            const double y = support.value(1, j, i);
            const std::size_t at = support.at(i, j, k);
            add_to(window + at, mass, y);
            for (unsigned int d = 0; d < 3; ++d)
              add_to(
                window + stride * (1 + d) + at, plain[d], y, along_y[d], j * y);
          }
        }
      });
  }

  template <unsigned int degree>
  void mass_product(SplineSupports<degree> &supports,
                    const unsigned int n_components,
                    const ParticleBlock &particles,
                    const WindowGeometry &geometry,
                    const double *const from,
                    double *const to)
  {
    constexpr unsigned int n = degree + 1;
    for_each_support(
      particles,
      geometry,
      supports,
      [&](const SplineSupports<degree> &support,
          const std::size_t i,
          const std::size_t p) {
        const Row x = support.x(i);
        const double mass = particles[column::mass][p];
        for (unsigned int c = 0; c < n_components; ++c)
        {
          Row sum(0.);
          for (unsigned int k = 0; k < n; ++k)
          {
            Row plane(0.);
            for (unsigned int j = 0; j < n; ++j)
              plane.add(Row::load(from + stride * c + support.at(i, j, k)),
                        support.value(1, j, i));
            sum.add(plane, support.value(2, k, i));
          }
          const Row product = x * (mass * sum.dot(x));
          for (unsigned int k = 0; k < n; ++k)
          {
            const Row plane = product * support.value(2, k, i);
            for (unsigned int j = 0; j < n; ++j)
              add_to(to + stride * c + support.at(i, j, k),
                     plane,
                     support.value(1, j, i));
          }
        }
      });
  }
} // namespace


WindowGeometry window_geometry(const TileGrid &grid,
                               const TileGrid::Source &tile)
{
  WindowGeometry result;
  result.cell_size = grid.box().cell_size;
  for (unsigned int d = 0; d < 3; ++d)
    result.lower[d] = grid.box().lower[d] + result.cell_size * tile.origin[d];
  return result;
}


void deposit(const unsigned int degree,
             const Deposit what,
             const bool has_affine,
             const ParticleBlock &particles,
             const WindowGeometry &geometry,
             double *const window)
{
  with_supports(degree, [&](auto &supports) {
    if (what == Deposit::force)
      deposit_plain<false, true>(supports, particles, geometry, window);
    else if (!has_affine && what == Deposit::momentum_force)
      deposit_plain<true, true>(supports, particles, geometry, window);
    else if (!has_affine)
      deposit_plain<true, false>(supports, particles, geometry, window);
    else
    {
      deposit_affine(supports, particles, geometry, window);
      if (what == Deposit::momentum_force)
        deposit_plain<false, true>(
          supports, particles, geometry, window + 4 * stride);
    }
  });
}


void multiply_mass(const unsigned int degree,
                   const unsigned int n_vectors,
                   const ParticleBlock &particles,
                   const WindowGeometry &geometry,
                   const double *const from,
                   double *const to)
{
  with_supports(degree, [&](auto &supports) {
    mass_product(supports, 3 * n_vectors, particles, geometry, from, to);
  });
}


void deposit_scalar(const ParticleBlock &particles,
                    const double *const weight,
                    const double *const value,
                    const WindowGeometry &geometry,
                    double *const window)
{
  static thread_local SplineSupports<1> supports;
  for_each_support(
    particles,
    geometry,
    supports,
    [&](const SplineSupports<1> &support,
        const std::size_t in_batch,
        const std::size_t p) {
      for_each_corner(
        support, in_batch, [&](const std::size_t at, const double share) {
          window[at] += share * weight[p];
          window[stride + at] += share * weight[p] * value[p];
        });
    });
}
} // namespace contrecoup::mpm
