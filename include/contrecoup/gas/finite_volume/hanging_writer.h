// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/octree/hanging_group.h>
#include <contrecoup/gas/stage/stage.h>

#include <deal.II/base/aligned_vector.h>

#include <array>
#include <vector>

namespace contrecoup::gas
{
/// Takes fluxes and halo values of a group of hanging faces from the lanes and
/// writes them to the place of each face in HangingData.
template <int dim, typename Real, unsigned int n_components>
class HangingWriter
{
public:
  using Number = Lanes<Real>;
  /// By face point.
  using Values = dealii::AlignedVector<std::array<Number, n_components>>;

  explicit HangingWriter(const unsigned int n_face_points)
    : component_(n_face_points)
    , nowhere_(n_face_points)
  {}

  /// @param slot see HangingData
  /// @param point_at point_at(q) is the face point of that side that is meant
  /// by face point q of @p flux and @p halo
  template <typename PointAt>
  void write(const HangingGroup<dim> &group,
             const unsigned int slot,
             const Values &flux,
             const Values &halo,
             const PointAt &point_at,
             HangingData<dim, Real> &hanging)
  {
    for (unsigned int c = 0; c < n_components; ++c)
    {
      write_component(group, flux, c, point_at, [&](const unsigned int face) {
        return hanging.flux(face, slot, c);
      });
      write_component(group, halo, c, point_at, [&](const unsigned int face) {
        return hanging.halo(face, slot, c);
      });
    }
  }

private:
  template <typename PointAt, typename PlaceOf>
  void write_component(const HangingGroup<dim> &group,
                       const Values &values,
                       const unsigned int component,
                       const PointAt &point_at,
                       const PlaceOf &place_of)
  {
    std::array<Real *, n_lanes<Real>> places;
    for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
      places[lane] =
        lane < group.n_filled ? place_of(group.face[lane]) : nowhere_.data();
    for (unsigned int q = 0; q < component_.size(); ++q)
      component_[point_at(q)] = values[q][component];
    dealii::vectorized_transpose_and_store(
      false, component_.size(), component_.data(), places);
  }

  dealii::AlignedVector<Number> component_; ///< of one side, by face point
  std::vector<Real> nowhere_;               ///< written in lanes without a face
};
} // namespace contrecoup::gas
