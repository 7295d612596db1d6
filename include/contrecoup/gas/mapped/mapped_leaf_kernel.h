// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/leaf_kernel.h>
#include <contrecoup/gas/octree/face_frame.h>
#include <contrecoup/gas/octree/kernel_metric.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Adds leaves of any shape to LeafKernel: the gas beyond the leaf faces, with
 * neighbours in any orientation or beyond hanging faces, and Riemann fluxes in
 * the frames of subcell faces. Velocities are along the coordinate axes unless
 * said otherwise.
 */
template <int dim, typename Gas, typename Real = double>
class MappedLeafKernel : protected LeafKernel<dim, Gas, Real>
{
public:
  using Base = LeafKernel<dim, Gas, Real>;
  using Number = typename Base::Number;
  using Values = typename Base::Values;
  using C = Component<dim>;

protected:
  using Metric = KernelMetric<dim, Real>;
  using Vector = typename Metric::Vector;
  using Base::batch_;
  using Base::boundary_;
  using Base::gas_;
  using Base::in_;
  using Base::layout_;
  using Base::mesh_;
  using Base::nc;
  using Base::neighbor_sensor_;
  using Base::scheme_;
  using Base::sensor_;
  using Base::time_;
  static constexpr int n_beyond = 2;

  /// @param metric of the leaves that are bound; must outlive this object
  MappedLeafKernel(const OperatorContext<dim> &context,
                   const Gas &gas,
                   const Metric &metric);

  /// Reads the neighbours and evaluates the boundaries of the bound leaves.
  /// @param primitive their own values, [component][point], read by
  /// face_flux() too
  /// @param hanging halos are what lies beyond hanging faces
  void fill_beyond(const Number *primitive,
                   const HangingData<dim, Real> &hanging);

  /// Primitive state beyond a leaf face, in the layer at @p depth.
  Values &beyond(const unsigned int face,
                 const unsigned int line,
                 const unsigned int depth)
  {
    return beyond_[(face * n_beyond + depth) * layout_.n_face_points + line];
  }
  const Values &beyond(const unsigned int face,
                       const unsigned int line,
                       const unsigned int depth) const
  {
    return beyond_[(face * n_beyond + depth) * layout_.n_face_points + line];
  }

  bool is_wall(const SpecialFace &special) const
  {
    return special.kind == SpecialFace::Kind::boundary &&
           boundary_.kind(special.index) == Boundary<dim>::Kind::wall;
  }

  /// Primitive values with the velocity along the axes of @p frame.
  static Values in_frame(const FaceFrame<dim, Number> &frame,
                         const Values &values)
  {
    Values result = values;
    for (unsigned int d = 0; d < dim; ++d)
    {
      result[C::velocity + d] = values[C::velocity] * frame.axes[d][0];
      for (unsigned int e = 1; e < dim; ++e)
        result[C::velocity + d] += values[C::velocity + e] * frame.axes[d][e];
    }
    return result;
  }

  /**
   * Numerical flux through a subcell face per area, in its frame. Where
   * explosive burns, call fill_progress() for the line before.
   *
   * @param traces left and right state at the face
   * @param points the values at the points on both sides
   * @param inner_shock positive where the flux may be made shock stable, at
   * faces inside the leaf
   */
  Values face_flux(const unsigned int direction,
                   const unsigned int layer,
                   const unsigned int line,
                   const FaceFrame<dim, Number> &frame,
                   const std::array<Values, 2> &traces,
                   const std::array<Values, 2> &points,
                   const Number &inner_shock) const;

private:
  void fill_neighbors(const unsigned int face);
  void fill_boundary_lane(const SpecialFace &special);
  void fill_hanging_lane(const SpecialFace &special,
                         const HangingData<dim, Real> &hanging);
  GasState<dim> primitive_lane(const unsigned int point,
                               const unsigned int lane) const;
  void mirror_at_walls(const unsigned int direction,
                       const unsigned int layer,
                       Values &left,
                       Values &right) const;
  Number compression(const unsigned int direction,
                     const unsigned int layer,
                     const unsigned int line) const;
  /// Velocity component of point i, -1 to n, of a line.
  const Number &velocity(const unsigned int direction,
                         const unsigned int line,
                         const int i,
                         const unsigned int component) const;

  const Metric &leaf_metric_;
  const Number *primitive_ = nullptr;
  std::array<Number, 2 * dim> wall_;     ///< one in lanes with a wall
  dealii::AlignedVector<Values> beyond_; ///< see beyond()
};
} // namespace contrecoup::gas
