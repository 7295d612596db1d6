// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/galerkin/galerkin_faces.h>
#include <contrecoup/gas/octree/radial_nodes.h>
#include <contrecoup/gas/state/quiet_leaves.h>
#include <contrecoup/numerics/scheme/trouble_indicator.h>

namespace contrecoup::gas
{
/**
 * One stage of the discontinuous Galerkin scheme on a batch of leaves, from
 * the fluxes through their faces: the weak form with deal.II's FEEvaluation
 * (collocation at Gauss-Lobatto nodes on boxes: Kopriva 2009, section 8), in
 * troubled leaves blended with a finite-volume scheme on the subcells around
 * the nodes (Hennemann, Rueda-Ramirez, Hindenlang and Gassner 2021), and
 * scaled towards the mean where a node would lose positivity.
 *
 * A node stands for the integral of its shape function; the subcells' inner
 * faces have the areas with which finite volumes and the weak form agree about
 * uniform flow.
 *
 * In curvilinear coordinates volumes and areas grow with the radius. Leaves at
 * the axis, where a node's volume would vanish, use finite volumes along the
 * radius.
 */
template <int dim, typename Gas, typename Real>
class GalerkinLeaves
{
public:
  using Number = Lanes<Real>;
  static constexpr unsigned int width = n_lanes<Real>;
  static constexpr unsigned int nc = n_conserved<dim, Gas>;
  using Values = std::array<Number, nc>;
  using C = Component<dim>;
  using Space = GalerkinSpace<dim, Real>;
  using Faces = GalerkinFaces<dim, Gas, Real>;
  using Vector = dealii::Tensor<1, dim, Number>;

  GalerkinLeaves(const Space &space,
                 const Faces &faces,
                 const OperatorContext<dim> &context,
                 const Gas &gas);

  /// Renews what depends on the mesh, after that of space and faces.
  void reinit();

  /// Does @p stage on the leaves of a batch of cells, except quiet leaves.
  void update(const unsigned int cell_batch,
              const BasicStage<Real> &stage,
              const QuietLeaves<dim> &quiet_leaves);

  /// Computes only sensor and signal rate of the state stage.results.state.
  void analyse(const unsigned int cell_batch, const BasicStage<Real> &stage);

private:
  using CellBatch = typename Space::CellBatch;
  using Evaluation = NodalEvaluation<dim, int(nc), Real, false>;
  using Line = dealii::AlignedVector<Values>;

  void bind(const unsigned int cell_batch);
  void load(const Real *state);
  void set_volumes();
  void set_blending(const Real *sensors);
  unsigned int neighbor(const unsigned int face, const unsigned int lane) const;

  void volume_terms();
  void evaluate_state();
  void submit_flux(const unsigned int q, const Values &u, const Values &p);
  void add_face_fluxes();
  void divide_by_mass();
  /// Area towards larger radii of face @p f between nodes of a line along the
  /// radius.
  Number radial_area(const unsigned int line, const unsigned int f) const;
  void add_radial_pressure();

  bool needs_subcells() const
  {
    return any_blending_ || radial_.any_near_axis();
  }
  void add_subcell_terms(const Real *state);
  void set_subcell_areas();
  void subcell_line(const unsigned int direction,
                    const unsigned int line,
                    const Real *state);
  void load_line(const unsigned int direction,
                 const unsigned int line,
                 const Real *state);
  void find_neighbors();
  Values beyond(const unsigned int face,
                const unsigned int line,
                const Real *state) const;
  void set_slopes();
  Values subcell_flux(const unsigned int direction,
                      const unsigned int line,
                      const unsigned int f) const;
  Number compression(const unsigned int direction,
                     const unsigned int point) const;
  /// Face @p f between subcells of a line, towards increasing index.
  FaceAxes<dim, Number> subcell_face(const unsigned int direction,
                                     const unsigned int line,
                                     const unsigned int f) const;
  bool is_boundary(const SpecialFace &special,
                   const typename Boundary<dim>::Kind kind) const
  {
    return special.kind == SpecialFace::Kind::boundary &&
           boundary_.kind(special.index) == kind;
  }
  bool is_open(const unsigned int leaf) const;

  void advance(const BasicStage<Real> &stage);
  void store(const BasicStage<Real> &stage,
             const QuietLeaves<dim> &quiet_leaves) const;
  void store_sensors(const BasicStage<Real> &stage,
                     const QuietLeaves<dim> *quiet_leaves);
  Number largest_signal_rate() const;

  Values node(const dealii::AlignedVector<Number> &values,
              const unsigned int q) const
  {
    Values result;
    for (unsigned int c = 0; c < nc; ++c)
      result[c] = values[c * n_points_ + q];
    return result;
  }

  /// Leaves of equal size next to a face of the batch's leaves.
  struct FaceNeighbors
  {
    NeighborReader<Real> reader;
    std::array<unsigned int, width> leaf;
    std::array<FaceMatch, width> match; ///< the same in all lanes on boxes
    Number is_absent;                   ///< one where there is none, else zero
    Number sign; ///< of the normal velocity beyond: -1 behind a wall
    bool any_absent;
  };

  const LeafMesh<dim> &mesh_;
  const Space &space_;
  const Faces &faces_;
  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  const Boundary<dim> &boundary_;
  const LobattoSubcells subcells_;
  const TroubleIndicator<dim> indicator_;
  RadialNodes<Number> radial_;
  const unsigned int n_points_;
  std::unique_ptr<Evaluation> phi_;
  std::unique_ptr<NodalEvaluation<dim, dim, Real, false>> metric_;
  dealii::AlignedVector<Number> volumes_; ///< of all nodes; not on boxes

  const CellBatch *batch_ = nullptr;
  unsigned int index_ = 0;
  NeighborReader<Real> reader_;
  std::array<Number, dim> extents_; ///< of boxes [m]
  /// Factor from the volume of a node to its area on a face of the leaf,
  /// positive on upper faces, negative on lower ones [1/m].
  std::array<Number, 2 * dim> to_area_;
  dealii::AlignedVector<Number> conserved_; ///< [component][node]
  dealii::AlignedVector<Number> primitive_;
  dealii::AlignedVector<Number> rate_; ///< of change
  dealii::AlignedVector<Number> subcell_rate_;
  dealii::AlignedVector<Number> volume_;
  dealii::AlignedVector<Number> outflow_; ///< [face][component][face point]
  dealii::AlignedVector<Number> signal_;  ///< what the indicator looks at
  std::array<dealii::AlignedVector<Number>, dim> area_; ///< [component][node]
  Number reference_pressure_;
  Number blending_;
  bool any_blending_ = false;
  std::array<FaceNeighbors, 2 * dim> beside_;
  Line line_; ///< primitive, with one node beyond each end
  Line slope_;
  Line flux_;
};
} // namespace contrecoup::gas
