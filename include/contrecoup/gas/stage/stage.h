// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/leaf_layout.h>
#include <contrecoup/gas/state/burn.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/// Output of a Runge-Kutta stage; the arrays are laid out as LeafLayout says.
template <typename Real>
struct StageResults
{
  Real *state = nullptr; ///< conserved values of the new state
  /// Per owned leaf, of the new state, as BasicStage::sensor; may be null.
  Real *sensor = nullptr;
  /// Per owned leaf: largest sum_d (|u_d| + c) / h_d, h_d the leaf's edge
  /// lengths [1/s], of the new state; may be null.
  Real *signal_rate = nullptr;
  /// The gas's force on a body's wall [N; in 2-D per metre of depth] and the
  /// wall's area vector [m^2] in the leaves that are computed, times
  /// BasicStage::weight, are added. May be null.
  std::array<double, 6> *wall_force = nullptr;
  /// Set to the number of a leaf whose new state is not physical.
  unsigned int *unphysical_leaf = nullptr;
};


/**
 * Input of a Runge-Kutta stage in Shu-Osher form,
 * results.state = a start + (1 - a) (in + step L(in)).
 * The arrays are laid out as LeafLayout says; those of @p in and @p sensor have
 * their ghost leaves filled.
 */
template <typename Real>
struct BasicStage
{
  const Real *start = nullptr;
  const Real *in = nullptr;
  double a = 0.;
  double step = 0.;     ///< [s]
  double time = 0.;     ///< of the state @p in [s]
  double end_time = 0.; ///< of the state whose signal rate is asked for [s]
  /// Explosive that is still to burn; null: none. Finite volumes only.
  const Burn *burn = nullptr;
  /// Per stored leaf, from the previous stage: the blending factor (DG) or
  /// one where a shock stands (finite volume) [-].
  const Real *sensor = nullptr;
  /// Whether finite volumes bound their velocity slopes by the internal energy
  /// of each subcell. Set after a step without the bound has failed; in cold
  /// gas the scheme is then of first order.
  bool bound_velocity_slopes = false;
  /// Fraction of this stage's rate of change in that of the step [-].
  double weight = 1.;
  StageResults<Real> results;
};

using Stage = BasicStage<double>;

/// Fluxes and halo values of the hanging faces, computed once for both
/// sides. Slot 0 of a face is the coarse side's, 1 + part the fine ones'.
template <int dim, typename Real = double>
class HangingData
{
public:
  static constexpr unsigned int n_slots = 1 + HangingFace<dim>::n_fine;

  void resize(const unsigned int n_faces, const LeafLayout &layout)
  {
    n_face_points_ = layout.n_face_points;
    n_components_ = layout.n_components;
    flux_.resize(std::size_t(n_faces) * n_slots * n_components_ *
                 n_face_points_);
    halo_.resize(flux_.size());
  }

  /// Numerical flux towards positive coordinates per area, or, on leaves of
  /// any shape, as MappedHanging says; in the numbering of the face points of
  /// that side. Consecutive values belong to consecutive face points.
  Real *flux(const unsigned int face,
             const unsigned int slot,
             const unsigned int component)
  {
    return flux_.data() + position(face, slot, component);
  }
  const Real *flux(const unsigned int face,
                   const unsigned int slot,
                   const unsigned int component) const
  {
    return flux_.data() + position(face, slot, component);
  }

  /// Primitive value of a cell of that side's size beyond the face.
  Real *halo(const unsigned int face,
             const unsigned int slot,
             const unsigned int component)
  {
    return halo_.data() + position(face, slot, component);
  }
  const Real *halo(const unsigned int face,
                   const unsigned int slot,
                   const unsigned int component) const
  {
    return halo_.data() + position(face, slot, component);
  }

private:
  std::size_t position(const unsigned int face,
                       const unsigned int slot,
                       const unsigned int component) const
  {
    return ((std::size_t(face) * n_slots + slot) * n_components_ + component) *
           n_face_points_;
  }

  unsigned int n_face_points_ = 1;
  unsigned int n_components_ = 1;
  std::vector<Real> flux_;
  std::vector<Real> halo_;
};
} // namespace contrecoup::gas
