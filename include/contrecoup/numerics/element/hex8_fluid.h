// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/numerics/element/compression.h>
#include <contrecoup/numerics/element/hex8_one_point.h>
#include <contrecoup/numerics/element/hex8_wedge.h>

/**
 * @file
 * Hexahedron of a fluid in the present configuration. One integration point
 * for pressure and artificial viscosity, and viscous hourglass control. All
 * forces are corner forces, so that their work equals the change of internal
 * energy (Caramana, Burton, Shashkov and Whalen 1998).
 */

namespace contrecoup
{
/// Coefficients of artificial viscosity and hourglass control [-].
struct FluidViscosity
{
  double linear = 0.5;    ///< times rho l c
  double quadratic = 2.;  ///< times rho l^2 |compression rate|
  double hourglass = 0.1; ///< of viscous hourglass control
};

/// State of a fluid element, and results of fluid_forces().
template <typename Number>
struct FluidElement
{
  Number mass;     ///< [kg]
  Number energy;   ///< internal [J]
  Number products; ///< mass fraction of explosive products [-]

  Number volume;      ///< [m^3]
  Number pressure;    ///< [Pa]
  Number signal_rate; ///< inverse of the stable step [1/s]
};

/**
 * Artificial viscous stress mu e with the symmetric velocity gradient e, for
 * an element that is compressed in some direction s. The viscosity is mu = rho
 * l (q_2 l |s e s| + q_1 c), with the element length l along s: Dobrev, Kolev
 * and Rieben (2012), equations 6.12 to 6.15, without their vorticity measure.
 * Zero in expansion.
 * @param x modes of the corners [m]
 * @param gradient of the velocity [1/s]
 * @param viscosity result: mu [Pa s]
 */
template <typename Number>
inline DEAL_II_ALWAYS_INLINE Matrix3<Number>
viscous_stress(const FluidViscosity &coefficients,
               const HexVectors<Number> &x,
               const Matrix3<Number> &gradient,
               const Number &density,
               const Number &sound_speed,
               Number &viscosity)
{
  using std::max;
  using std::min;
  using std::sqrt;
  const Compression<Number> compression = find_compression(gradient);
  // The inverse of the mean edges gives lengths: l = 1 / |A^-1 s|.
  Matrix3<Number> edges;
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int e = 0; e < 3; ++e)
      edges[i][e] = Number(0.25) * x[e + 1][i];
  const Matrix3<Number> c = cofactor(edges);
  const Number determinant =
    edges[0][0] * c[0][0] + edges[0][1] * c[0][1] + edges[0][2] * c[0][2];
  Number square{};
  for (unsigned int i = 0; i < 3; ++i)
    for (unsigned int j = 0; j < 3; ++j)
      square += compression.direction[i][j] *
                (c[i][0] * c[j][0] + c[i][1] * c[j][1] + c[i][2] * c[j][2]);
  // Bound the length by the root of the sum of squared edges; for needle-like
  // elements an inaccurate projector could exceed it.
  Number edge_square{};
  for (unsigned int i = 0; i < 3; ++i)
    edge_square += dot(edges[i], edges[i]);
  const Number length =
    determinant / sqrt(max(square, determinant * determinant / edge_square));
  const Number rate = Number() - compression.smallest_eigenvalue;
  // Phase the viscosity in, since round-off of eigenvalue or velocities in
  // matter at rest must not count as compression.
  const Number part =
    min(Number(1.),
        rate / (Number(0.01) * compression.norm +
                Number(1e-8) * sound_speed / length + Number(1e-200)));
  const Number mu = part * density * length *
                    (rate * length * coefficients.quadratic +
                     sound_speed * coefficients.linear);
  viscosity = select_less(rate, Number(), Number(), mu);
  Matrix3<Number> stress = compression.rate;
  for (auto &row : stress)
    for (Number &value : row)
      value *= viscosity;
  return stress;
}

/**
 * Corner forces of an element [N].
 * @param law equation of state, see IdealGas
 * @param x_corners present positions [m]
 * @param v_corners velocities [m/s]
 * @param element state as input, receives the results
 * @param wedge to which the element belongs, if its slope is positive
 */
template <typename Law, typename Number>
inline DEAL_II_ALWAYS_INLINE HexVectors<Number>
fluid_forces(const Law &law,
             const FluidViscosity &coefficients,
             const HexVectors<Number> &x_corners,
             const HexVectors<Number> &v_corners,
             FluidElement<Number> &element,
             const HexWedge &wedge = {})
{
  using std::max;
  using std::sqrt;
  const HexVectors<Number> x = to_modes(x_corners), v = to_modes(v_corners);
  HexGeometry<Number> g = hex_geometry(x);
  wedge.restrict_lengths(g);
  const Matrix3<Number> gradient = mean_gradient(g, v);
  const Number density = element.mass * g.inverse_volume;
  Number square;
  law.pressure_and_sound_speed(density,
                               element.energy * g.inverse_volume,
                               element.products,
                               element.pressure,
                               square);
  const Number sound_speed = sqrt(max(square, Number()));
  Number viscosity;
  Matrix3<Number> stress =
    viscous_stress(coefficients, x, gradient, density, sound_speed, viscosity);
  for (unsigned int i = 0; i < 3; ++i)
    stress[i][i] -= element.pressure;

  std::array<Vector3<Number>, 4> damping = hourglass_modes(g, v, gradient);
  wedge.restrict_modes(damping);
  const Number damper =
    density * sound_speed * g.damping_area() * (coefficients.hourglass / 8.);
  for (auto &mode : damping)
    for (Number &value : mode)
      value *= damper * Number(1. / 8.);

  const Number length = g.wave_length();
  element.volume = g.volume;
  element.signal_rate =
    (sound_speed + Number(2.) * viscosity / (density * length)) / length;
  return to_corners(mode_forces(g, stress, damping));
}
} // namespace contrecoup
