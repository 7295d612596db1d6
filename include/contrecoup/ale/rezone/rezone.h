// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/region.h>
#include <contrecoup/ale/rezone/elastic_smoothing.h>
#include <contrecoup/ale/rezone/remap.h>

#include <deal.II/base/parameter_handler.h>

#include <map>

namespace contrecoup::ale
{
/// What the mesh does besides going with the matter.
enum class RezoneKind
{
  none,    ///< nothing: Lagrange
  elastic, ///< nodes inside follow the boundary as if the mesh were elastic
  back     ///< all nodes go back to where they began: Euler
};

/**
 * Moves the nodes of the mesh now and then, and carries the matter over:
 * subsection "Rezone".
 */
class Rezone
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @param step about that of the run [s]
  /// @throws InputError for an interval that is far below it
  void check_interval(const double step) const;

  /// @param walls sides along which matter slides, by boundary id
  /// @param regions by material id; solids are not rezoned
  /// @throws InputError for kind `back` with several regions, and for solids
  /// alone
  void
  reinit(HexSpace &space,
         const AleState &state,
         const std::vector<Region> &regions,
         const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls);

  /**
   * Rezones if it is due at the time of @p state, unless no part of the motion
   * gives valid cells: then the mesh goes on with the matter until it is due
   * again.
   * @return whether it did
   */
  bool apply(AleState &state, const SlipWalls &walls);

  /// Goes on from the state of a checkpoint, before which there were so many
  /// rezones, done and left out.
  void resume(const AleState &state,
              const unsigned int n_rezones,
              const unsigned int n_left_out,
              const SmoothingMemory &memory);

  /// For checkpoints; zeros where nothing is smoothed.
  SmoothingMemory memory() const;

  unsigned int n_rezones() const
  {
    return n_rezones_;
  }

  /// Those that were due and had no valid mesh.
  unsigned int n_left_out() const
  {
    return n_left_out_;
  }

  /// Where the mesh was after the last rezone, for checkpoints.
  dealii::AlignedVector<double> &reference()
  {
    return reference_;
  }

private:
  /// Whether regions meet anywhere.
  bool has_interfaces() const;

  /// The axis that a face is normal to; -1: none.
  int axis_normal_to(const HexSpace::Face &face) const;

  /// Along flat walls nodes may slide; at other sides, in solids, and where
  /// regions meet, they go with the matter.
  void find_prescribed(
    const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls);
  dealii::AlignedVector<double> smoothed(const AleState &state,
                                         const SlipWalls &walls);

  /// The largest part of its volume that a cell loses through all its faces, on
  /// the way to @p position. Collective.
  double largest_outflow(const AleState &state,
                         const dealii::AlignedVector<double> &position) const;

  /// Carries over in as many steps as no cell loses too much in.
  void carry_over(AleState &state,
                  const SlipWalls &walls,
                  const dealii::AlignedVector<double> &position);
  bool is_valid(const dealii::AlignedVector<double> &position) const;

  RezoneKind kind_ = RezoneKind::none;
  double interval_ = 0.; ///< 0: every step [s]
  ElasticOptions options_;
  RemapLimiter limiter_ = RemapLimiter::keep_smooth_extrema;

  HexSpace *space_ = nullptr;
  std::vector<bool> is_solid_; ///< by region
  Remap remap_;
  ElasticSmoothing smoothing_;
  PrescribedNodes prescribed_;
  dealii::AlignedVector<double> start_, reference_;
  double due_ = 0.;
  unsigned int n_rezones_ = 0;
  unsigned int n_left_out_ = 0;
};
} // namespace contrecoup::ale
