// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/body/cut_leaves.h>
#include <contrecoup/gas/finite_volume/batch_sweep.h>
#include <contrecoup/gas/finite_volume/state_analysis.h>

namespace contrecoup::gas
{
/**
 * The finite-volume scheme on batches with leaves that a rigid body cuts.
 * Fluxes pass through the open part of each subcell face; the wall in a
 * subcell exerts the pressure of the Riemann problem between the gas in it and
 * its mirror image, along the wall's normal. Differences across closed faces
 * count as zero in the limiter. Points without gas keep their values.
 */
template <int dim, typename Gas, typename Real = double>
class EmbeddedKernel
{
public:
  using Sweep = BatchSweep<dim, Gas, Real>;
  using Number = typename Sweep::Number;
  using Values = typename Sweep::Values;
  using C = Component<dim>;
  using Primitives = PrimitiveField<dim, Gas, Real>;

  /// @param primitives of the state that stages read
  EmbeddedKernel(const OperatorContext<dim> &context,
                 const Gas &gas,
                 Primitives &primitives);

  /// Takes over the shapes of all leaves in cut batches.
  void reinit();

  /// Does @p stage on the leaves of @p batch, without state redistribution;
  /// GasOperator::redistribute() completes the stage.
  void update(const unsigned int batch,
              const BasicStage<Real> &stage,
              const HangingData<dim, Real> &hanging);

  /// Checks and analyses the new state, after its redistribution.
  void conclude(const unsigned int batch, const BasicStage<Real> &stage);

  /// Computes only sensor and signal rate of the state stage.results.state.
  void analyse(const unsigned int batch, const BasicStage<Real> &stage);

private:
  struct OpenFaces;

  static constexpr unsigned int nc = Sweep::nc;
  static constexpr unsigned int width = n_lanes<Real>;

  /// Facets, one in each lane, of any points and leaves of a batch.
  struct WallPack
  {
    std::array<unsigned int, width> point;
    std::array<unsigned int, width> lane;
    /// Where the points' values stand among the primitive ones of the batch.
    std::array<unsigned int, width> offset;
    /// Unit normal of the facet, out of the gas.
    std::array<Number, dim> normal;
    Number area;   ///< over the cell's volume [1/m]; 0: no facet
    Number volume; ///< see CutLeaves::cell_volume()
  };

  /// The shapes of the leaves of a batch.
  struct Openings
  {
    std::vector<WallPack> walls;            ///< of embedded bodies
    Number is_cut = Number(0.);             ///< one in lanes of cut leaves
    dealii::AlignedVector<Number> fraction; ///< per point
    /// Per point, of staircases: see CutLeaves::cell_volume().
    dealii::AlignedVector<Number> volume;
    /// Per direction: [layer][line].
    std::array<dealii::AlignedVector<Number>, dim> face;
    /// Per leaf face: of the faces between the two layers beyond, by line.
    std::array<dealii::AlignedVector<Number>, 2 * dim> beyond;
  };

  /// Copies the shape of a leaf to a lane.
  void
  take(const unsigned int leaf, const unsigned int lane, Openings &to) const;
  /// Packs the facets of a batch, whose openings are known.
  void pack_walls(const unsigned int batch, Openings &openings) const;
  void bind_openings(const unsigned int batch)
  {
    openings_ = &all_openings_[openings_of_batch_[batch]];
  }
  const Number &opening(const unsigned int direction,
                        const unsigned int layer,
                        const unsigned int line) const
  {
    return openings_->face[direction][layer * layout_.n_face_points + line];
  }
  void sweep(const unsigned int direction,
             const HangingData<dim, Real> &hanging);
  /// Opening of the low (side 0) or high face of a point.
  const Number &opening_of(const unsigned int point,
                           const unsigned int direction,
                           const unsigned int side) const;
  void add_walls(const double time);
  void add_embedded_walls(const WallPack &walls, const double time);
  void add_staircase_wall(const unsigned int point, const double time);
  /// Pressure on a wall that the gas moves towards at @p speed.
  /// @param inside primitive values, of which the velocity does not count
  /// @param progress Burn::progress(), where explosive burns
  Number wall_pressure(Values inside,
                       const Number &speed,
                       const Number &progress) const;
  /// Pressure that gas exerts [Pa].
  Number exerted_pressure(const Values &inside, const Number &progress) const;
  Number inverse_size(const unsigned int direction) const
  {
    return Number(layout_.n) / mesh_.template extents<Real>(batch_)[direction];
  }
  void write(const BasicStage<Real> &stage);
  void add_wall_force(const BasicStage<Real> &stage) const;

  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  const CutLeaves<dim> &cut_leaves_;
  RadialWeights radial_;
  Sweep sweep_;
  StateAnalysis<dim, Gas, Real> state_analysis_;
  unsigned int batch_ = 0;
  const Burn *burn_ = nullptr;         ///< see LeafKernel
  std::vector<int> openings_of_batch_; ///< index, or -1
  std::vector<Openings> all_openings_;
  const Openings *openings_ = nullptr; ///< of the bound batch
  std::array<Number, dim> wall_force_; ///< sums by lane [N]
  std::array<Number, dim> wall_area_;  ///< likewise [m^2]
};
} // namespace contrecoup::gas
