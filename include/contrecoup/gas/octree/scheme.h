// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/precision.h>
#include <contrecoup/numerics/scheme/limiters.h>
#include <contrecoup/numerics/scheme/multidimensional_limiter.h>
#include <contrecoup/numerics/scheme/riemann_flux.h>
#include <contrecoup/numerics/scheme/runge_kutta.h>

#include <deal.II/base/parameter_handler.h>

#include <optional>
#include <string>

namespace contrecoup::gas
{
/// Numerical method, read from subsection "Method".
class Scheme
{
public:
  enum class Kind
  {
    finite_volume,         ///< each leaf has n^dim equal subcells
    discontinuous_galerkin ///< each leaf has n^dim Gauss-Lobatto nodes
  };

  static void declare_parameters(dealii::ParameterHandler &prm);

  /// @throws InputError for combinations that do not exist.
  void parse_parameters(dealii::ParameterHandler &prm, const unsigned int dim);

  /// @throws InputError for options that the mesh does not allow: a gradient
  /// limiter on axis-aligned boxes or with the Galerkin scheme.
  void check_mesh(const bool is_axis_aligned) const;

  Kind kind = Kind::finite_volume;
  unsigned int n_points = 8;         ///< points per direction of a leaf
  bool linear_reconstruction = true; ///< finite volume: linear reconstruction
  SlopeLimiter limiter = SlopeLimiter::mc;
  /// Multidimensional limiter, for mapped meshes only.
  std::optional<GradientLimiter> gradient_limiter;
  RiemannFlux flux = RiemannFlux::hllc_shock_stable;
  RungeKuttaTable time_stepping;
  Precision precision = Precision::double_precision;
  double cfl = 0.4; ///< CFL number [-]
  /// Polynomial degree of leaves on curved manifolds (DG).
  unsigned int cell_degree = 1;
  bool blending = true; ///< subcell shock capturing (DG)
  /// Factor on the default threshold (DG) [-]
  double indicator_threshold = 1.;
  /// Positivity limiter: scaling towards the mean (DG).
  bool positivity = true;
  unsigned int largest_retries = 10;

  unsigned int degree() const
  {
    return n_points - 1;
  }

  /// Largest stable time step times the signal rate sum_d (|u_d| + c) / h_d,
  /// h_d the edge lengths of the leaf, at CFL number 1 [-].
  double stability_limit() const;

  /// Largest polynomial degree of curved leaves [-] that keeps uniform flow:
  /// the Gauss points, as many along each direction as nodes, integrate area
  /// vectors times test functions exactly. Area vectors of leaves of degree k
  /// have degree 2 k - 1 in three dimensions; in two, degree + 1 is exact and
  /// places walls as accurately as the gas.
  static unsigned int largest_cell_degree(const unsigned int degree,
                                          const unsigned int dim)
  {
    return dim == 3 ? degree / 2 + 1 : degree + 1;
  }
};
} // namespace contrecoup::gas
