// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/kernel/galerkin_nodes.h>
#include <contrecoup/gas/kernel/lobatto_metric.h>
#include <contrecoup/gas/kernel/mapped_leaf_kernel.h>

namespace contrecoup::gas
{
/**
 * One stage of the discontinuous Galerkin scheme of degree n - 1 on one
 * batch of leaves of any shape: that of GalerkinKernel with the metric terms
 * of LobattoMetric at the nodes (Kopriva 2006). In troubled leaves it is
 * blended with finite volumes on the nodes' subcells, between whose faces
 * both schemes see the same areas, so that uniform flow stays in either.
 *
 * Without hanging faces.
 */
template <int dim, int n, typename Gas>
class MappedGalerkinKernel
  : private GalerkinNodes<dim, n, Gas, MappedLeafKernel<dim, Gas>>
{
public:
  using Base = GalerkinNodes<dim, n, Gas, MappedLeafKernel<dim, Gas>>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;
  using C = Component<dim>;

  MappedGalerkinKernel(const LeafMesh<dim> &mesh,
                       const LeafLayout &layout,
                       const Scheme &scheme,
                       const Gas &gas,
                       const Boundary<dim> &boundary);

  /// Does @p stage on the leaves of @p batch.
  void update(const unsigned int batch,
              const Stage &stage,
              const HangingData<dim> &hanging);

  /// Computes only sensor and signal rate of the state stage.out.
  void analyse(const unsigned int batch, const Stage &stage);

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
  using Line = typename Base::Line;

  void bind_metric(const unsigned int batch);
  void sweep(const unsigned int direction);
  void load_line(const unsigned int direction, const unsigned int line);
  void end_fluxes(const unsigned int direction, const unsigned int line);
  void volume_terms(const unsigned int direction, const unsigned int line);
  void subcell_terms(const unsigned int direction, const unsigned int line);
  /// Flux through a subcell face, integrated over it; the momentum's along
  /// the coordinate axes and less the force of the reference pressure. See
  /// MappedLeafKernel::face_flux().
  Values flux_through(const unsigned int direction,
                      const unsigned int layer,
                      const unsigned int line,
                      const std::array<Values, 2> &traces,
                      const std::array<Values, 2> &points) const;
  void store_sensors(const Stage &stage);
  Number largest_signal_rate() const;

  LobattoMetric<dim> metric_;
  /// w_j D_ji: what node j adds to the residual's integral at node i.
  std::array<std::array<double, n>, n> stiffness_;
  Line line_;          ///< primitive
  Line line_residual_; ///< integrals over the nodes' subcells
  Values low_flux_;
  Values high_flux_;
};
} // namespace contrecoup::gas
