// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/mpm/row.h>
#include <contrecoup/mpm/transfer_kernels.h>
#include <contrecoup/numerics/spline_weights.h>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int size = TileGrid::window_size;
  constexpr int edge = TileGrid::window_edge;

  /// Splines of a particle in the window of its tile.
  template <unsigned int degree>
  struct Support
  {
    static constexpr unsigned int n = degree + 1;

    DEAL_II_ALWAYS_INLINE Support(const ParticleBlock &particles,
                                  const std::size_t p,
                                  const WindowPlace &place)
    {
      const double per_cell = 1. / place.cell_size;
      int offset = 0;
      for (int d = 2; d >= 0; --d)
      {
        axis[d] = spline_weights<degree>(
          (particles[column::position + d][p] - place.lower[d]) * per_cell);
        for (double &slope : axis[d].slope)
          slope *= per_cell;
        offset = edge * offset + axis[d].first - TileGrid::window_start;
      }
      first = offset;
      x = Row::load(axis[0].value.data());
      slope_x = Row::load(axis[0].slope.data());
    }

    /// First node of a row.
    DEAL_II_ALWAYS_INLINE unsigned int at(const unsigned int j,
                                          const unsigned int k) const
    {
      return first + edge * (j + edge * k);
    }

    std::array<SplineWeights, 3> axis;
    Row x, slope_x;
    unsigned int first;
  };

  inline DEAL_II_ALWAYS_INLINE void add_to(double *const node, const Row &row)
  {
    Row sum = row;
    sum.add(Row::load(node), 1.);
    sum.store(node);
  }

  /// Calls @p work(row's first node, y and z weights and slopes).
  template <unsigned int degree, typename Work>
  inline DEAL_II_ALWAYS_INLINE void for_each_row(const Support<degree> &support,
                                                 const Work &work)
  {
    for (unsigned int k = 0; k < Support<degree>::n; ++k)
      for (unsigned int j = 0; j < Support<degree>::n; ++j)
      {
        const double y = support.axis[1].value[j], z = support.axis[2].value[k];
        work(support.at(j, k),
             y * z,
             support.axis[1].slope[j] * z,
             y * support.axis[2].slope[k],
             j,
             k);
      }
  }

  /// Momentum of a particle at a node: m (v + C (x_i - x_p)), C perhaps zero.
  struct AffineMomentum
  {
    double constant[3]; ///< at the first node of the support
    double slope[3][3]; ///< per node along x, y, z
  };

  template <unsigned int degree>
  AffineMomentum affine_momentum(const ParticleBlock &particles,
                                 const std::size_t p,
                                 const Support<degree> &support,
                                 const WindowPlace &place)
  {
    AffineMomentum result;
    const double mass = particles[column::mass][p];
    for (unsigned int d = 0; d < 3; ++d)
    {
      double velocity = particles[column::velocity + d][p];
      for (unsigned int e = 0; e < 3; ++e)
      {
        const double c = particles[column::affine + 3 * d + e][p];
        const double first =
          place.lower[e] + place.cell_size * support.axis[e].first;
        velocity += c * (first - particles[column::position + e][p]);
        result.slope[d][e] = mass * c * place.cell_size;
      }
      result.constant[d] = mass * velocity;
    }
    return result;
  }

  template <unsigned int degree>
  void deposit_momentum(const ParticleBlock &particles,
                        const WindowPlace &place,
                        double *const window)
  {
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      const double mass = particles[column::mass][p];
      double momentum[3];
      for (unsigned int d = 0; d < 3; ++d)
        momentum[d] = mass * particles[column::velocity + d][p];
      for_each_row(support,
                   [&](const unsigned int at,
                       const double yz,
                       double,
                       double,
                       unsigned int,
                       unsigned int) {
                     Row weight(0.);
                     weight.add(support.x, yz);
                     Row one(0.);
                     one.add(weight, mass);
                     add_to(window + at, one);
                     for (unsigned int d = 0; d < 3; ++d)
                     {
                       Row part(0.);
                       part.add(weight, momentum[d]);
                       add_to(window + size * (1 + d) + at, part);
                     }
                   });
    }
  }

  template <unsigned int degree>
  void deposit_affine_momentum(const ParticleBlock &particles,
                               const WindowPlace &place,
                               double *const window)
  {
    constexpr std::array<double, 4> steps{{0., 1., 2., 3.}};
    const Row along = Row::load(steps.data());
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      const AffineMomentum m = affine_momentum(particles, p, support, place);
      const double mass = particles[column::mass][p];
      for_each_row(support,
                   [&](const unsigned int at,
                       const double yz,
                       double,
                       double,
                       const unsigned int j,
                       const unsigned int k) {
                     Row weight(0.);
                     weight.add(support.x, yz);
                     Row one(0.);
                     one.add(weight, mass);
                     add_to(window + at, one);
                     for (unsigned int d = 0; d < 3; ++d)
                     {
                       Row value(m.constant[d] + j * m.slope[d][1] +
                                 k * m.slope[d][2]);
                       value.add(along, m.slope[d][0]);
                       Row part(0.);
                       part.add(weight, value);
                       add_to(window + size * (1 + d) + at, part);
                     }
                   });
    }
  }

  /// Minus the stress times volume of a particle: Kirchhoff's stress times the
  /// undeformed volume, and the smoothed pressure times the smoothed volume.
  inline DEAL_II_ALWAYS_INLINE std::array<double, 6>
  minus_stress(const ParticleBlock &particles, const std::size_t p)
  {
    const double volume = particles[column::volume][p];
    std::array<double, 6> result;
    for (unsigned int k = 0; k < 6; ++k)
      result[k] = -volume * particles[column::stress + k][p];
    const double pressure = volume * (1. + particles[column::dilatation][p]) *
                            particles[column::smoothed][p];
    for (unsigned int d = 0; d < 3; ++d)
      result[d] += pressure;
    return result;
  }

  template <unsigned int degree>
  void deposit_force(const ParticleBlock &particles,
                     const WindowPlace &place,
                     double *const window)
  {
    // Rows of the symmetric tensor xx, yy, zz, xy, yz, zx.
    constexpr unsigned int entry[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      const std::array<double, 6> s = minus_stress(particles, p);
      for_each_row(support,
                   [&](const unsigned int at,
                       const double yz,
                       const double slope_y,
                       const double slope_z,
                       unsigned int,
                       unsigned int) {
                     for (unsigned int d = 0; d < 3; ++d)
                     {
                       Row part = Row::load(window + size * d + at);
                       part.add(support.slope_x, s[entry[d][0]] * yz);
                       part.add(support.x,
                                s[entry[d][1]] * slope_y +
                                  s[entry[d][2]] * slope_z +
                                  particles[column::force + d][p] * yz);
                       part.store(window + size * d + at);
                     }
                   });
    }
  }

  /// Gradients of three components, each as sums over rows.
  struct GradientSums
  {
    Row value[3], along_y[3], along_z[3];

    GradientSums()
    {
      for (unsigned int d = 0; d < 3; ++d)
        value[d] = along_y[d] = along_z[d] = Row(0.);
    }

    DEAL_II_ALWAYS_INLINE void add(const double *const nodes,
                                   const double yz,
                                   const double slope_y,
                                   const double slope_z)
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        const Row row = Row::load(nodes + size * d);
        value[d].add(row, yz);
        along_y[d].add(row, slope_y);
        along_z[d].add(row, slope_z);
      }
    }

    template <unsigned int degree>
    DEAL_II_ALWAYS_INLINE void store(const Support<degree> &support,
                                     ParticleBlock &particles,
                                     const unsigned int first,
                                     const std::size_t p) const
    {
      for (unsigned int d = 0; d < 3; ++d)
      {
        particles[first + 3 * d][p] = value[d].dot(support.slope_x);
        particles[first + 3 * d + 1][p] = along_y[d].dot(support.x);
        particles[first + 3 * d + 2][p] = along_z[d].dot(support.x);
      }
    }
  };

  template <unsigned int degree>
  void motion(const double step,
              const double *const window,
              const WindowPlace &place,
              ParticleBlock &particles)
  {
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      Row sums[6];
      for (Row &sum : sums)
        sum = Row(0.);
      GradientSums mean;
      for_each_row(support,
                   [&](const unsigned int at,
                       const double yz,
                       const double slope_y,
                       const double slope_z,
                       unsigned int,
                       unsigned int) {
                     for (unsigned int c = 0; c < 6; ++c)
                       sums[c].add(Row::load(window + size * c + at), yz);
                     mean.add(window + size * 6 + at, yz, slope_y, slope_z);
                   });
      for (unsigned int d = 0; d < 3; ++d)
      {
        particles[column::change + d][p] = step * sums[d].dot(support.x);
        particles[column::way + d][p] = step * sums[3 + d].dot(support.x);
      }
      mean.store(support, particles, column::mean_rate, p);
    }
  }

  template <unsigned int degree>
  void rate(const double *const window,
            const WindowPlace &place,
            ParticleBlock &particles)
  {
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      GradientSums sums;
      for_each_row(
        support,
        [&](const unsigned int at,
            const double yz,
            const double slope_y,
            const double slope_z,
            unsigned int,
            unsigned int) { sums.add(window + at, yz, slope_y, slope_z); });
      sums.store(support, particles, column::rate, p);
    }
  }

  template <unsigned int degree>
  void affine(const double *const window,
              const WindowPlace &place,
              ParticleBlock &particles)
  {
    const double inertia =
      spline_inertia(degree) * place.cell_size * place.cell_size;
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      double moment[9] = {};
      for_each_row(
        support,
        [&](const unsigned int at,
            const double yz,
            double,
            double,
            const unsigned int j,
            const unsigned int k) {
          for (unsigned int i = 0; i <= degree; ++i)
          {
            const double weight = yz * support.axis[0].value[i];
            const unsigned int step[] = {i, j, k};
            for (unsigned int e = 0; e < 3; ++e)
            {
              const double arm =
                place.lower[e] +
                place.cell_size * (support.axis[e].first + double(step[e])) -
                particles[column::position + e][p];
              for (unsigned int d = 0; d < 3; ++d)
                moment[3 * d + e] += weight * arm * window[size * d + at + i];
            }
          }
        });
      for (unsigned int i = 0; i < 9; ++i)
        particles[column::affine + i][p] = moment[i] / inertia;
    }
  }

  template <unsigned int degree>
  void mass_product(const unsigned int n_components,
                    const ParticleBlock &particles,
                    const WindowPlace &place,
                    const double *const from,
                    double *const to)
  {
    for (std::size_t p = 0; p < particles.size(); ++p)
    {
      const Support<degree> support(particles, p, place);
      const double mass = particles[column::mass][p];
      for (unsigned int c = 0; c < n_components; ++c)
      {
        Row sum(0.);
        for_each_row(
          support,
          [&](const unsigned int at,
              const double yz,
              double,
              double,
              unsigned int,
              unsigned int) { sum.add(Row::load(from + size * c + at), yz); });
        const double value = mass * sum.dot(support.x);
        for_each_row(support,
                     [&](const unsigned int at,
                         const double yz,
                         double,
                         double,
                         unsigned int,
                         unsigned int) {
                       double *const node = to + size * c + at;
                       Row part = Row::load(node);
                       part.add(support.x, value * yz);
                       part.store(node);
                     });
      }
    }
  }

  /// Calls @p function with the degree as a constant.
  template <typename Function>
  void with_degree(const unsigned int degree, const Function &function)
  {
    if (degree == 1)
      function(std::integral_constant<unsigned int, 1>());
    else if (degree == 2)
      function(std::integral_constant<unsigned int, 2>());
    else
      function(std::integral_constant<unsigned int, 3>());
  }
} // namespace


void deposit(const unsigned int degree,
             const Deposit what,
             const bool has_affine,
             const ParticleBlock &particles,
             const WindowPlace &place,
             double *const window)
{
  with_degree(degree, [&](const auto constant) {
    constexpr unsigned int n = decltype(constant)::value;
    if (what != Deposit::force && has_affine)
      deposit_affine_momentum<n>(particles, place, window);
    else if (what != Deposit::force)
      deposit_momentum<n>(particles, place, window);
    if (what != Deposit::momentum)
      deposit_force<n>(
        particles, place, window + (what == Deposit::force ? 0 : 4 * size));
  });
}


void collect_motion(const unsigned int degree,
                    const double step,
                    const double *const window,
                    const WindowPlace &place,
                    ParticleBlock &particles)
{
  with_degree(degree, [&](const auto constant) {
    motion<decltype(constant)::value>(step, window, place, particles);
  });
}


void collect_rate(const unsigned int degree,
                  const double *const window,
                  const WindowPlace &place,
                  ParticleBlock &particles)
{
  with_degree(degree, [&](const auto constant) {
    rate<decltype(constant)::value>(window, place, particles);
  });
}


void collect_affine(const unsigned int degree,
                    const double *const window,
                    const WindowPlace &place,
                    ParticleBlock &particles)
{
  with_degree(degree, [&](const auto constant) {
    affine<decltype(constant)::value>(window, place, particles);
  });
}


void multiply_mass(const unsigned int degree,
                   const unsigned int n_vectors,
                   const ParticleBlock &particles,
                   const WindowPlace &place,
                   const double *const from,
                   double *const to)
{
  with_degree(degree, [&](const auto constant) {
    mass_product<decltype(constant)::value>(
      3 * n_vectors, particles, place, from, to);
  });
}


void deposit_scalar(const ParticleBlock &particles,
                    const double *const weight,
                    const double *const value,
                    const WindowPlace &place,
                    double *const window)
{
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    const Support<1> support(particles, p, place);
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int i = 0; i < 2; ++i)
        {
          const double part = support.axis[0].value[i] *
                              support.axis[1].value[j] *
                              support.axis[2].value[k] * weight[p];
          window[support.at(j, k) + i] += part;
          window[size + support.at(j, k) + i] += part * value[p];
        }
  }
}


void collect_scalar(const double *const window,
                    const WindowPlace &place,
                    const ParticleBlock &particles,
                    double *const value)
{
  for (std::size_t p = 0; p < particles.size(); ++p)
  {
    const Support<1> support(particles, p, place);
    double sum = 0.;
    for (unsigned int k = 0; k < 2; ++k)
      for (unsigned int j = 0; j < 2; ++j)
        for (unsigned int i = 0; i < 2; ++i)
          sum += support.axis[0].value[i] * support.axis[1].value[j] *
                 support.axis[2].value[k] * window[support.at(j, k) + i];
    value[p] = sum;
  }
}
} // namespace contrecoup::mpm
