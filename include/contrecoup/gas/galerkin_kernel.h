// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/leaf_kernel.h>
#include <contrecoup/gas/radial_nodes.h>
#include <contrecoup/numerics/lobatto_basis.h>
#include <contrecoup/numerics/trouble_indicator.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/**
 * One stage of the discontinuous Galerkin scheme of degree n - 1 on one
 * batch of axis-aligned leaves: collocation at Gauss-Lobatto nodes (Kopriva
 * 2009, section 8), in troubled leaves blended with a finite-volume scheme
 * on the subcells that the quadrature weights define (Hennemann,
 * Rueda-Ramirez, Hindenlang and Gassner 2021), and scaled towards the mean
 * where a node would lose positivity (Zhang and Shu 2010). Both schemes
 * share the flux at leaf faces, so that the mean is conservative; beside
 * troubled leaves it comes from the subcells' reconstruction too.
 *
 * In curvilinear geometry nodes stand for the volumes of radial_jacobian(),
 * and along the radius leaves next to the axis are finite volumes alone.
 */
template <int dim, int n, typename Gas, typename Real = double>
class GalerkinKernel : private LeafKernel<dim, Gas, Real>
{
public:
  using Base = LeafKernel<dim, Gas, Real>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;
  using C = Component<dim>;

  GalerkinKernel(const LeafMesh<dim> &mesh,
                 const LeafLayout &layout,
                 const Scheme &scheme,
                 const Gas &gas,
                 const Boundary<dim> &boundary);

  /// Does @p stage on the leaves of @p batch.
  void update(const unsigned int batch,
              const BasicStage<Real> &stage,
              const HangingData<dim, Real> &hanging);

  /// Computes only sensor and signal rate of the state stage.out.
  void analyse(const unsigned int batch, const BasicStage<Real> &stage);

private:
  using Base::batch_;
  using Base::gas_;
  using Base::layout_;
  using Base::mesh_;
  using Base::nc;
  using Base::scheme_;
  static constexpr unsigned int n_points = dealii::Utilities::pow(n, dim);
  static constexpr unsigned int n_lines = n_points / n;
  using Line = std::array<Values, n>;

  void load(const Real *state);
  void set_blending();
  void sweep(const unsigned int direction,
             const HangingData<dim, Real> &hanging);
  void load_line(const unsigned int direction, const unsigned int line);
  void end_fluxes(const unsigned int direction,
                  const unsigned int line,
                  const HangingData<dim, Real> &hanging);
  void fill_boundary_lane(const SpecialFace &special, const unsigned int line);
  Values end_flux(const unsigned int direction,
                  const unsigned int line,
                  const bool high);
  void volume_terms();
  void radial_volume_terms();
  void subcell_terms(const unsigned int direction, const unsigned int line);
  void radial_subcell_terms(const std::array<Values, n + 1> &flux);
  void find_slopes(const unsigned int direction);
  void reconstruct_end(const unsigned int direction,
                       const unsigned int line,
                       const bool high);
  Number compression(const unsigned int direction,
                     const unsigned int point) const;
  void add_line(const unsigned int direction, const unsigned int line);
  void finish(const BasicStage<Real> &stage);
  void restore_positivity(const BasicStage<Real> &stage);
  void bound_products();
  Values mean() const;
  Values radial_mean() const;
  void scale_to_mean(const Values &mean,
                     const Number &theta,
                     const bool densities_only);
  Number blending_factor() const;

  const LobattoBasis basis_;
  const TroubleIndicator<dim, n> indicator_;
  /// w_j D_ji / w_i: the volume term of the weak form at node i.
  std::array<std::array<double, n>, n> weak_derivative_;
  std::array<double, n> weight_;
  std::array<double, n + 1> subface_;
  /// Middle of each subcell, for which its nodal value stands there.
  std::array<double, n> center_;
  /// From the middle before to that of subcell i, likewise behind the last.
  std::array<double, n + 1> inverse_distance_;
  std::vector<SlopeWeights> slope_weights_;

  RadialNodes<Number> radial_;
  bool any_blending_ = false;
  Number blending_;
  Number reference_pressure_;

  std::array<std::array<Number, n_points>, nc> conserved_;
  std::array<std::array<Number, n_points>, nc> primitive_;
  std::array<std::array<Number, n_points>, nc> residual_;
  Line line_; ///< primitive
  Line line_conserved_;
  Line line_residual_;
  Line slope_; ///< of the primitive state in the subcells
  /// The neighbours' nodes at both ends of the line, primitive.
  std::array<Values, 2> beyond_;
  /// States on both sides of the leaf faces at the ends of the line.
  std::array<Values, 2> inside_;
  std::array<Values, 2> outside_;
  Values low_flux_;
  Values high_flux_;
};
} // namespace contrecoup::gas
