// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/galerkin/galerkin_space.h>
#include <contrecoup/gas/galerkin/lobatto_subcells.h>
#include <contrecoup/gas/galerkin/nodal_evaluation.h>
#include <contrecoup/gas/octree/leaf_box.h>
#include <contrecoup/gas/octree/neighbor_reader.h>
#include <contrecoup/gas/octree/radial_nodes.h>
#include <contrecoup/gas/stage/face_axes.h>
#include <contrecoup/gas/stage/operator_context.h>
#include <contrecoup/gas/stage/stage.h>
#include <contrecoup/gas/state/primitive.h>
#include <contrecoup/numerics/scheme/lobatto_basis.h>

namespace contrecoup::gas
{
/**
 * Numerical fluxes between leaves for the discontinuous Galerkin scheme,
 * computed once for both sides; see GalerkinSpace for what is stored.
 *
 * On hanging faces, and on all faces of a mesh with mapped leaves, both traces
 * are interpolated to the quadrature points; on other faces the points are the
 * face nodes. Next to troubled leaves, on faces that do not hang, there are
 * fluxes at the face nodes in any case, and on mapped leaves both kinds are
 * blended. At the nodes the traces change, as far as the leaves are troubled,
 * to those of the subcells' finite volumes, which share these fluxes
 * (Hennemann, Rueda-Ramirez, Hindenlang and Gassner 2021).
 */
template <int dim, typename Gas, typename Real>
class GalerkinFaces
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int width = n_lanes<Real>;
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  using C = Component<dim>;
  using Space = GalerkinSpace<dim, Real>;
  using Vector = dealii::Tensor<1, dim, Number>;

  GalerkinFaces(const Space &space,
                const OperatorContext<dim> &context,
                const Gas &gas);

  /// Renews what depends on the mesh, after that of the space.
  void reinit();

  /// Fills the records of a batch of faces.
  void compute(const unsigned int face_batch, const BasicStage<Real> &stage);

  /// Prefetches into the cache the values of @p state at the nodes of a batch
  /// of faces.
  void prefetch(const unsigned int face_batch, const Real *state) const;

  /// The records of the fluxes [component][face point][lane].
  const Real *fluxes() const
  {
    return fluxes_.data();
  }
  /// Records of the area vectors out of each leaf, integrated with the test
  /// functions; empty on boxes.
  const Real *areas() const
  {
    return areas_.data();
  }

private:
  using FaceBatch = typename Space::FaceBatch;
  using Evaluation = NodalEvaluation<dim, int(nc), Real, true>;
  using Trace = dealii::AlignedVector<Values>;

  void measure_areas();
  void measure_hanging_areas(const unsigned int face_batch);
  void bind(const unsigned int face_batch, const BasicStage<Real> &stage);
  Values conserved(const unsigned int side, const unsigned int point) const;
  /// Component that stands at place @p c along the axes of boxes' faces.
  unsigned int component(const unsigned int c) const
  {
    return rotated_component<dim>(c, batch_->face[0] / 2);
  }
  Values along_axes(const unsigned int q, const Values &values) const;
  Values from_axes(const unsigned int q, const Values &values) const;
  void set_nodal_axes();

  void nodal_fluxes();
  void load_nodes(const unsigned int side);
  void mirror_nodes();
  /// Values of a node, see near_, along the axes of the face.
  Values node_along_axes(const unsigned int q, const Values &values) const
  {
    return space_.is_collocated() ? values : axes_[q].to(values);
  }
  Values subcell_trace(const unsigned int side, const unsigned int q) const;
  using Places = dealii::Point<dim, Number>;
  Places node_places(const unsigned int q) const;
  /// The state outside at a node or, on mapped leaves, a quadrature point.
  Values beyond_boundary(const unsigned int q,
                         const Values &inside,
                         const bool is_node) const;
  Values given_state(const unsigned int q,
                     const Values &inside,
                     const bool is_node) const;
  Number shear_factor_at(const unsigned int q, const Number &speed) const;
  Number compression(const unsigned int side, const unsigned int q) const;
  void store_flux();
  void blend_nodal(const unsigned int side);

  void interpolated_fluxes();
  void interpolate(const unsigned int side);
  void integrate(const unsigned int side);
  /// Primitive values of @p u, or of @p mean where @p u is not admissible. The
  /// mean of admissible nodes is.
  Values admissible_primitive(Values u, const Values &mean) const;
  /// The numerical flux between two traces, along the axes of the face.
  Values flux(const Values &left, const Values &right) const;

  void hanging_fluxes();
  /// Fills @p trace with the difference of each node of a side's face from the
  /// first node; returns the values of the first node and the mean.
  std::array<Values, 2> load_face(const unsigned int side, Trace &trace) const;
  void interpolate_coarse_side();
  void project_onto_coarse_side();
  /// For the lower and the upper half of an edge.
  using MatrixOfHalf = std::array<const dealii::FullMatrix<double> *, 2>;
  /// Applies, along each direction of the face, the matrix of that half which
  /// the batch's quarter lies in.
  void apply_along_face(const MatrixOfHalf &matrix_of_half, Trace &trace);
  void bind_radius();

  void mapped_hanging_fluxes();
  void interpolate_hanging(const unsigned int side);
  void integrate_hanging(const unsigned int side);
  /// Matrices of a side in to_gauss_ or from_gauss_.
  static MatrixOfHalf
  matrix_of(const std::array<dealii::FullMatrix<double>, 3> &matrices,
            const unsigned int side)
  {
    return side == 0 ? MatrixOfHalf{{&matrices[0], &matrices[0]}}
                     : MatrixOfHalf{{&matrices[1], &matrices[2]}};
  }
  Vector &hanging_area(const unsigned int face_batch, const unsigned int q)
  {
    return hanging_areas_[(face_batch - first_hanging_) * n_points_ + q];
  }
  /// Number of a point of a hanging face on a side's own face.
  unsigned int hanging_point(const unsigned int side,
                             const unsigned int point) const
  {
    return side == 1 || dim == 1 ? point
                                 : matched_face_point(batch_->match.orientation,
                                                      point % layout_.n,
                                                      point / layout_.n,
                                                      layout_.n);
  }

  /// Outflow of a leaf through a face, per area, along the coordinate
  /// axes; pressures are relative to reference_pressure_.
  Values outflow(const unsigned int side, const unsigned int q) const;
  Evaluation &evaluation(const unsigned int side)
  {
    return side == batch_->interior ? *interior_ : *exterior_;
  }
  Real *record(const unsigned int side)
  {
    return fluxes_.data() + std::size_t(batch_->record[side]) * nc * n_points_;
  }

  const Space &space_;
  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  const Boundary<dim> &boundary_;
  const LobattoSubcells subcells_;
  const LobattoBasis basis_;
  const unsigned int n_points_; ///< of a face
  std::unique_ptr<Evaluation> interior_;
  std::unique_ptr<Evaluation> exterior_;
  dealii::AlignedVector<Real> fluxes_;
  dealii::AlignedVector<Real> areas_;
  /// Area vectors of hanging faces of mapped leaves, from the fine to the
  /// coarse leaf, times quadrature weights at their points [batch][point], and
  /// the number of the first such batch.
  dealii::AlignedVector<Vector> hanging_areas_;
  unsigned int first_hanging_ = 0;
  /// From nodes to Gauss points, of a fine leaf and of the lower and the upper
  /// half of a coarse one, and their transposes.
  std::array<dealii::FullMatrix<double>, 3> to_gauss_;
  std::array<dealii::FullMatrix<double>, 3> from_gauss_;

  unsigned int index_ = 0; ///< of batch_
  const FaceBatch *batch_ = nullptr;
  const BasicStage<Real> *stage_ = nullptr;
  std::array<NeighborReader<Real>, 2> reader_;
  std::array<Number, 2> reference_pressure_; ///< at node 0 of the leaf
  Number share_;                             ///< of the finite volumes
  bool any_share_ = false;
  bool needs_shear_factor_ = false;
  /// At each point, the normal from side 0 to side 1; not on boxes.
  dealii::AlignedVector<FaceAxes<dim, Number>> axes_;
  /// Primitive values of the first nodes, or of quadrature points, along the
  /// axes of the face, but of nodes of mapped leaves along the coordinate axes:
  /// what is limited must not depend on which side is the interior one.
  std::array<Trace, 2> near_;
  std::array<Trace, 2> far_; ///< second nodes
  Trace opposite_;           ///< last nodes, at boundaries
  Trace flux_;               ///< from side 0 to side 1, along the axes
  Trace line_;
  /// Nodes of hanging faces along the radius.
  RadialNodes<Number> fine_radius_;
  RadialNodes<Number> coarse_radius_;
};
} // namespace contrecoup::gas
