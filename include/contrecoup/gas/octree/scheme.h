// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/precision.h>
#include <contrecoup/numerics/limiters.h>
#include <contrecoup/numerics/multidimensional_limiter.h>
#include <contrecoup/numerics/riemann_flux.h>
#include <contrecoup/numerics/runge_kutta.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace contrecoup::gas
{
/// The numerical method, as subsection "Method" describes it.
class Scheme
{
public:
  enum class Kind
  {
    finite_volume,         ///< n equal subcells a side in each leaf
    discontinuous_galerkin ///< Gauss-Lobatto nodes in each leaf
  };

  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for combinations that do not exist.
  void parse_parameters(dealii::ParameterHandler &prm, const unsigned int dim);

  /// @throws InputError when the scheme does not work on boxes or, unless
  /// @p is_axis_aligned, on meshes of other shapes.
  void check_mesh(const bool is_axis_aligned) const;

  Kind kind = Kind::finite_volume;
  unsigned int n_points = 8; ///< points a side of a leaf
  bool linear = true;        ///< reconstructed in finite volumes
  SlopeLimiter limiter = SlopeLimiter::van_leer;
  /// Of all directions together, on mapped meshes.
  std::optional<GradientLimiter> gradient_limiter;
  RiemannFlux flux = RiemannFlux::hllc;
  RungeKuttaTable time_stepping;
  Precision precision = Precision::double_precision;
  double cfl = 0.5;                ///< CFL number [-]
  bool blending = true;            ///< subcell shock capturing (DG)
  double largest_blending = 1.;    ///< [-]
  double indicator_threshold = 1.; ///< factor of the usual one (DG) [-]
  bool positivity = true;          ///< scaling towards the mean (DG)
  unsigned int largest_retries = 10;

  unsigned int degree() const
  {
    return n_points - 1;
  }

  /// Largest stable step times the signal rate sum_d (|u_d| + c) / h_d of
  /// a leaf, at CFL number 1 [-].
  double stability_limit() const;
};
} // namespace contrecoup::gas
