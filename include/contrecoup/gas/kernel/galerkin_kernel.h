// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/galerkin_nodes.h>
#include <contrecoup/gas/octree/radial_nodes.h>

#include <array>

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
class GalerkinKernel
  : private GalerkinNodes<dim, n, Gas, LeafKernel<dim, Gas, Real>>
{
public:
  using Base = GalerkinNodes<dim, n, Gas, LeafKernel<dim, Gas, Real>>;
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
  using Base::any_blending_;
  using Base::batch_;
  using Base::blending_;
  using Base::conserved_;
  using Base::gas_;
  using Base::layout_;
  using Base::mesh_;
  using Base::n_lines;
  using Base::n_points;
  using Base::nc;
  using Base::primitive_;
  using Base::reference_pressure_;
  using Base::residual_;
  using Base::scheme_;
  using Base::weight_;
  using Line = typename Base::Line;

  void bind_radial();
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

  /// w_j D_ji / w_i: the volume term of the weak form at node i.
  std::array<std::array<double, n>, n> weak_derivative_;

  RadialNodes<Number> radial_;
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
