// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/finite_volume/leaf_kernel.h>
#include <contrecoup/gas/finite_volume/primitive_field.h>
#include <contrecoup/gas/finite_volume/sweep_line.h>
#include <contrecoup/materials/mie_grueneisen.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::gas
{
/**
 * Rates of change of one batch of axis-aligned leaves by the finite-volume
 * scheme: the lines of each direction one after the other, with two layers of
 * subcells of the neighbours, of the boundary's state or of hanging faces'
 * halos at their ends. The geometry of the lines is a policy; see line_faces.h.
 */
template <int dim, typename Gas, typename Real = double>
class BatchSweep
{
public:
  using Leaves = LeafKernel<dim, Gas, Real>;
  using Number = typename Leaves::Number;
  using Values = typename Leaves::Values;
  using C = Component<dim>;
  using Primitives = PrimitiveField<dim, Gas, Real>;
  static constexpr unsigned int nc = Leaves::nc;

  /// @param primitives of the state that bound stages read
  BatchSweep(const OperatorContext<dim> &context,
             const Gas &gas,
             Primitives &primitives);

  /// Prepares for the leaves of @p batch.
  void bind(const unsigned int batch, const BasicStage<Real> &stage);

  /// Adds the rates of the lines along a direction, which is 0 first.
  /// @param faces faces(line) is the geometry of a line, see line_faces.h
  template <typename Faces>
  void sweep(const unsigned int direction,
             const HangingData<dim, Real> &hanging,
             const Faces &faces);

  /// Rate of change of a component at a point [per s].
  Number &rate(const unsigned int component, const unsigned int point)
  {
    return rates_[point * nc + component];
  }

  /// Primitive values of the bound batch; see PrimitiveField::index().
  const Real *primitive() const
  {
    return primitive_;
  }

  /// The bound leaves and what surrounds them.
  Leaves &leaves()
  {
    return leaves_;
  }

private:
  static constexpr unsigned int n_beyond = 2;

  /// The subcells -2 to n + 1 of a line; see Line::subcells.
  Values *subcells(const unsigned int line)
  {
    return &subcells_[line * (layout_.n + 2 * n_beyond) + n_beyond];
  }
  Values &beyond(const unsigned int side,
                 const unsigned int layer,
                 const unsigned int q)
  {
    return subcells(q)[side == 0 ? -1 - int(layer) : int(layout_.n + layer)];
  }
  /// Primitive values of a point in the frame of lines along a direction.
  Values cell(const unsigned int direction, const unsigned int point) const
  {
    Values result;
    for (unsigned int c = 0; c < nc; ++c)
      result[c].load(
        primitive_ +
        Primitives::index(rotated_component<dim>(c, direction), point));
    return result;
  }
  /// Sets the subcells beyond the leaves in all lines along a direction.
  void read_neighbors(const unsigned int direction);
  /// Prefetches what read_neighbors() will read at face point @p q. Without,
  /// read_neighbors() took 8 % of the time of the quickstart's blast, most of
  /// it in waiting for memory.
  void prefetch_neighbors(const unsigned int direction, const unsigned int q);
  void fill_beyond(const unsigned int direction,
                   const HangingData<dim, Real> &hanging);
  void fill_boundary(const SpecialFace &special);
  /// Beyond one side, in lanes where @p is_mirrored or @p is_repeated is one,
  /// the image of the leaf's layers in a wall, or its first layer.
  void fill_images(const unsigned int face,
                   const Number &is_mirrored,
                   const Number &is_repeated);
  void fill_hanging(const SpecialFace &special,
                    const HangingData<dim, Real> &hanging);
  /// Prefetches what the kernels' write() needs of the old and the new state, a
  /// part of it for each line. Without, write() took 7 % instead of 5 % of the
  /// time of gas_scene (tests/benchmark).
  void prefetch_states(const unsigned int line);
  void find_compression();
  void find_compression_beyond(const unsigned int direction,
                               const unsigned int side);
  void fill_line(const unsigned int direction, const unsigned int line);
  template <typename SomeGas, typename Faces>
  void sweep_line_of(const SomeGas &gas,
                     const Faces &faces,
                     const unsigned int direction,
                     const unsigned int line);

  const LeafMesh<dim> &mesh_;
  const LeafLayout layout_;
  const Scheme &scheme_;
  const Gas gas_;
  Primitives &primitives_;
  Leaves leaves_;

  const Real *primitive_ = nullptr;
  std::array<const Real *, 2> states_;     ///< see prefetch_states()
  dealii::AlignedVector<Number> rates_;    ///< see rate()
  dealii::AlignedVector<Values> subcells_; ///< see subcells()
  /// Most negative velocity difference along each direction between a point
  /// and its neighbours on the leaf, [direction][point]; and beyond each side,
  /// the least of those across the line, [side][line].
  dealii::AlignedVector<Number> compression_;
  dealii::AlignedVector<Number> compression_beyond_;
  dealii::AlignedVector<Values> hanging_flux_; ///< [side][line]
  std::array<Number, 2> has_hanging_;          ///< one in lanes that have one
  dealii::AlignedVector<Values> line_half_slopes_; ///< see Line::half_slopes
  dealii::AlignedVector<std::array<Number, 2>> line_end_products_;
  dealii::AlignedVector<Number> line_compression_;
  Line<Number, nc> line_;
  Number largest_density_;  ///< of the line
  Number largest_products_; ///< likewise
};


template <int dim, typename Gas, typename Real>
template <typename Faces>
void BatchSweep<dim, Gas, Real>::sweep(const unsigned int direction,
                                       const HangingData<dim, Real> &hanging,
                                       const Faces &faces)
{
  fill_beyond(direction, hanging);
  for (unsigned int line = 0; line < layout_.n_face_points; ++line)
  {
    fill_line(direction, line);
    if (direction + 1 < dim)
      prefetch_neighbors(direction + 1, line);
    else
      prefetch_states(line);
    if constexpr (Gas::has_products)
    {
      if (gas_.is_air(largest_density_, largest_products_))
      {
        sweep_line_of(gas_.air(), faces(line), direction, line);
        continue;
      }
      if constexpr (dim == 3)
        if (gas_.is_dilute(largest_density_))
        {
          sweep_line_of(gas_.dilute(), faces(line), direction, line);
          continue;
        }
    }
    sweep_line_of(gas_, faces(line), direction, line);
  }
}


template <int dim, typename Gas, typename Real>
template <typename SomeGas, typename Faces>
void BatchSweep<dim, Gas, Real>::sweep_line_of(const SomeGas &gas,
                                               const Faces &faces,
                                               const unsigned int direction,
                                               const unsigned int line)
{
  const unsigned int stride = layout_.stride(direction) * nc;
  const unsigned int first = layout_.face_point(2 * direction, line, 0);
  std::array<Number *, nc> rates;
  for (unsigned int c = 0; c < nc; ++c)
    rates[c] = &rate(rotated_component<dim>(c, direction), first);
  const bool is_first = direction == 0;

  // The case of most leaves in scenes, with loops and scheme known beforehand.
  if constexpr (dim == 3)
    if (FixedScheme::is(scheme_))
    {
      if (layout_.n == 4)
        return sweep_line<4, FixedScheme, dim>(
          gas, line_, faces, rates, stride, is_first);
      if constexpr (!Faces::closes_slopes)
        if (layout_.n == 8)
          return sweep_line<8, FixedScheme, dim>(
            gas, line_, faces, rates, stride, is_first);
    }
  // Other runs need no kernel of their own for dilute mixtures.
  if constexpr (std::is_same_v<SomeGas, DiluteMixture>)
    sweep_line<0, AnyScheme, dim>(gas_, line_, faces, rates, stride, is_first);
  else
    sweep_line<0, AnyScheme, dim>(gas, line_, faces, rates, stride, is_first);
}
} // namespace contrecoup::gas
