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
/// Motion of the mesh.
enum class RezoneKind
{
  none,    ///< Lagrangian: nodes move with the matter
  elastic, ///< inner nodes follow the boundary by elastic smoothing
  back     ///< Eulerian: nodes return to their initial positions
};

/// Rezoning: moves the mesh nodes at intervals and remaps the fields.
/// Subsection "Rezone".
class Rezone
{
public:
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm);

  /// @param step approximate step of the run [s]
  /// @throws InputError for an interval far below the step
  void check_interval(const double step) const;

  /// @param regions each with cells of its own
  /// @throws InputError for kind `back` with several regions, for rezoning
  /// solids alone, and for slip without smoothing
  void check_regions(const std::vector<Region> &regions) const;

  /// @param walls slip walls by boundary id
  /// @param regions by material id, as check_regions() accepts them; solids
  /// are not rezoned
  /// @throws InputError for kind `back` with several regions, and for solids
  /// alone
  void
  reinit(HexSpace &space,
         const AleState &state,
         const std::vector<Region> &regions,
         const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls);

  /**
   * Rezones if due at the time of @p state. If no fraction of the node motion
   * gives valid cells, the mesh stays Lagrangian until the next interval.
   * @return whether the mesh was rezoned
   */
  bool apply(AleState &state, const SlipWalls &walls);

  /// Continues from a checkpoint, with the counts of performed and skipped
  /// rezones.
  void resume(const AleState &state,
              const unsigned int n_rezones,
              const unsigned int n_skipped,
              const SmoothingMemory &memory);

  /// Data for checkpoints; zeros without smoothing.
  SmoothingMemory memory() const;

  unsigned int n_rezones() const
  {
    return n_rezones_;
  }

  /// Number of rezones skipped because no valid mesh was found.
  unsigned int n_skipped() const
  {
    return n_skipped_;
  }

  /// Node positions after the last rezone, for checkpoints.
  dealii::AlignedVector<double> &reference()
  {
    return reference_;
  }

private:
  /// Axis to which a face is normal; -1: none.
  int axis_normal_to(const HexSpace::Face &face) const;

  /// Finds nodes that must follow the matter: on sides that are no flat walls,
  /// in solids, and at interfaces. On flat walls nodes may slide.
  void find_prescribed(
    const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls);
  dealii::AlignedVector<double> smoothed(const AleState &state,
                                         const SlipWalls &walls);

  /// Largest fraction of its volume that a cell loses through its faces on the
  /// way to @p position. Collective.
  double largest_outflow(const AleState &state,
                         const dealii::AlignedVector<double> &position) const;

  /// Remaps in as many substeps as keep the outflow of each cell small.
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
  unsigned int n_skipped_ = 0;
};
} // namespace contrecoup::ale
