// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/cell_stencil.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/point.h>

namespace contrecoup::ale
{
/// Bounds on reconstructed and remapped values.
enum class RemapLimiter
{
  keep_smooth_extrema, ///< smooth extrema may exceed neighbouring values
  strict               ///< all values stay within those of neighbours
};

/**
 * Piecewise linear reconstruction of cell means for several fields. Gradients
 * are least squares fits over the neighbouring cells. They are limited such
 * that values at interior corners of a region and at face centres stay within
 * those of the cells around the corner or face (Kuzmin 2010; Barth and
 * Jespersen 1989). Towards a boundary or another region, corner values are
 * bounded by the cell and its extrapolation from the opposite neighbour. The
 * limiter leaves smooth extrema, where second differences of neighbouring
 * cells agree, unless it is strict. Linear functions are reproduced exactly.
 */
class Reconstruction
{
public:
  /// @param n_fields numbers per cell
  /// @param is_left_out whether a region is not reconstructed, by material id;
  /// may be empty
  void reinit(const HexSpace &space,
              const unsigned int n_fields,
              const std::vector<bool> &is_left_out = {},
              const RemapLimiter limiter = RemapLimiter::keep_smooth_extrema);

  /**
   * Computes the gradients.
   * @param position of the nodes, node_width numbers each [m]
   * @param fields of all cells, including ghost copies
   */
  void compute(const dealii::AlignedVector<double> &position,
               const dealii::AlignedVector<double> &fields);

  /// Gradient of a field in a cell (owned or ghost), three numbers.
  const double *gradient(const std::size_t cell, const unsigned int field) const
  {
    return &gradients_[3 * (n_fields_ * cell + field)];
  }

  /// Volume of a cell [m^3].
  double volume(const std::size_t cell) const
  {
    return volumes_[cell];
  }

  const dealii::Point<3> &centre(const std::size_t cell) const
  {
    return centres_[cell];
  }

private:
  /// Finds nodes whose reconstructed cells are of one region.
  void find_slots(const std::vector<bool> &is_left_out);
  void find_extrema(const dealii::AlignedVector<double> &fields);
  /// Extends smallest_ and largest_ by the values around a node of cells in the
  /// region of @p cell.
  void extend_bounds(const dealii::AlignedVector<double> &fields,
                     const std::size_t cell,
                     const std::uint32_t node);
  void find_centres(const dealii::AlignedVector<double> &position);
  void find_gradients(const dealii::AlignedVector<double> &fields,
                      const std::size_t cell);
  void find_curvatures(const dealii::AlignedVector<double> &fields,
                       const std::size_t cell);
  void limit_inside(const dealii::AlignedVector<double> &fields,
                    const std::size_t cell);
  void limit_towards_walls(const dealii::AlignedVector<double> &fields,
                           const std::size_t cell);
  void limit_at(const dealii::AlignedVector<double> &fields,
                const std::size_t cell,
                const dealii::ArrayView<const std::uint32_t> &nodes);
  void apply_factors(const std::size_t cell);
  bool is_smooth(const std::size_t cell, const unsigned int field) const;
  double change(const std::size_t cell,
                const unsigned int field,
                const dealii::Tensor<1, 3> &way) const;
  dealii::Point<3> place(const std::size_t node) const;

  const HexSpace *space_ = nullptr;
  unsigned int n_fields_ = 0;
  RemapLimiter limiter_ = RemapLimiter::keep_smooth_extrema;
  FieldExchange gradient_exchange_, curvature_exchange_;
  dealii::AlignedVector<double> gradients_;
  dealii::AlignedVector<double> curvatures_; ///< second differences
  std::vector<double> volumes_;
  std::vector<dealii::Point<3>> centres_;
  const dealii::AlignedVector<double> *position_ = nullptr;
  CellStencil stencil_;
  std::vector<std::uint32_t> cells_;     ///< owned cells with a reconstruction
  std::vector<std::uint32_t> all_cells_; ///< with ghost copies
  /// Index in extrema_ of nodes with one common range of values, or no_slot.
  static constexpr std::uint32_t no_slot = -1;
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> slot_nodes_;
  std::vector<bool> is_left_out_; ///< by region; may be empty
  /// minimum and maximum, by slot and field
  dealii::AlignedVector<double> extrema_;
  /// Bounds of one cell, by field, and factor on the gradient.
  std::vector<double> smallest_, largest_, factor_;
};
} // namespace contrecoup::ale
