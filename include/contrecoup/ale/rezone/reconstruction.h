// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/cell_stencil.h>

#include <deal.II/base/aligned_vector.h>
#include <deal.II/base/point.h>

namespace contrecoup::ale
{
/// What the values of a reconstruction, and of a remap, may be.
enum class RemapLimiter
{
  keep_smooth_extrema, ///< beyond those around where an extremum is smooth
  strict               ///< none beyond those of the cells around
};

/**
 * Linear functions in the cells, of several fields that are given by their
 * means: gradients by least squares over the cells around, limited so that at
 * the corners inside of a region, and at the centres of the faces, no value is
 * beyond those of the cells around the corner or face (Kuzmin 2010; Barth and
 * Jespersen 1989). Towards a boundary or another region, no corner is beyond
 * what the cell and that across the opposite face say of it. Extrema whose
 * second differences are alike in the cells around are smooth and not limited,
 * unless the limiter is strict.
 * Linear functions are found exactly.
 */
class Reconstruction
{
public:
  /// @param n_fields numbers at each cell
  /// @param is_left_out whether cells of a region get no functions; may be
  ///   empty
  void reinit(const HexSpace &space,
              const unsigned int n_fields,
              const std::vector<bool> &is_left_out = {},
              const RemapLimiter limiter = RemapLimiter::keep_smooth_extrema);

  /**
   * @param position of the nodes, AleState::width numbers each
   * @param fields of all cells, copies included
   */
  void compute(const dealii::AlignedVector<double> &position,
               const dealii::AlignedVector<double> &fields);

  /// Three numbers for each field of a cell, copies included.
  const double *gradient(const std::size_t cell, const unsigned int field) const
  {
    return &gradients_[3 * (n_fields_ * cell + field)];
  }

  /// [m^3]
  double volume(const std::size_t cell) const
  {
    return volumes_[cell];
  }

  const dealii::Point<3> &centre(const std::size_t cell) const
  {
    return centres_[cell];
  }

private:
  /// Finds the nodes whose cells that get functions are of one region.
  void find_slots(const std::vector<bool> &is_left_out);
  void find_extrema(const dealii::AlignedVector<double> &fields);
  /// Widens least_ and most_ by what cells of the region of @p cell around a
  /// node have.
  void widen(const dealii::AlignedVector<double> &fields,
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
  std::vector<std::uint32_t> cells_;     ///< own ones that get functions
  std::vector<std::uint32_t> all_cells_; ///< the same, and copies
  /// Nodes whose bounds all their cells share: where in extrema_, or no_slot.
  static constexpr std::uint32_t no_slot = -1;
  std::vector<std::uint32_t> slots_;
  std::vector<std::uint32_t> slot_nodes_;
  std::vector<bool> is_left_out_;         ///< by region; may be empty
  dealii::AlignedVector<double> extrema_; ///< least and most, by slot and field
  /// Of one cell, by field: bounds, and by what its gradient is multiplied.
  std::vector<double> least_, most_, factor_;
};
} // namespace contrecoup::ale
