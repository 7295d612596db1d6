// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/cell_stencil.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::ale
{
/**
 * Flux-corrected transport for the remap of a moving mesh: limits the flows
 * through faces such that density and the other fields of a cell stay within
 * the range of the cell and its neighbours in the same region. The low-order
 * flow carries the donor's mean, which is bounded as long as no cell loses
 * more than its volume. The correction is limited by the capacity of both cells
 * (Zalesak 1979), first for mass, then for the other fields.
 */
class BoundedFlows
{
public:
  /// @param n_fields numbers per cell: density, then quantities per mass
  void reinit(const HexSpace &space, const unsigned int n_fields);

  void clear();

  /**
   * Adds a flow through a face.
   * @param volume gained by the inner cell of @p face [m^3]
   * @param donor the cell that loses this volume
   * @param carried gain of the inner cell: mass, and mass times each other
   * field
   */
  void add(const HexSpace::Face &face,
           const double volume,
           const std::uint32_t donor,
           const double *carried);

  /**
   * Limits all flows, as donor() and carried() then give them, in the order of
   * add(). Collective.
   * @param fields of all cells before the remap, including ghost copies
   * @param masses of the cells before the remap [kg]
   */
  void limit(const dealii::AlignedVector<double> &fields,
             const dealii::AlignedVector<double> &masses);

  std::size_t size() const
  {
    return flows_.size();
  }
  const HexSpace::Face &face(const std::size_t flow) const
  {
    return *flows_[flow].face;
  }
  std::uint32_t donor(const std::size_t flow) const
  {
    return flows_[flow].donor;
  }
  const double *carried(const std::size_t flow) const
  {
    return &carried_[n_fields_ * flow];
  }

private:
  struct Flow
  {
    const HexSpace::Face *face;
    double volume;
    std::uint32_t donor;
  };

  void limit_masses(const dealii::AlignedVector<double> &fields,
                    const dealii::AlignedVector<double> &masses);
  void limit_others(const dealii::AlignedVector<double> &fields,
                    const dealii::AlignedVector<double> &masses);

  /// Adds a flow to the contents of those of its cells that are owned.
  void add_to_cells(const Flow &flow,
                    const double *carried,
                    const unsigned int width,
                    std::vector<double> &contents) const;

  /**
   * Computes the capacity of owned cells: how much each may still gain, and
   * lose, beyond its low-order contents @p low before its value leaves the
   * range of itself and its neighbours.
   * @param sizes volumes or masses after the remap
   * @param first field of the first number in @p low
   */
  void find_capacity(const dealii::AlignedVector<double> &fields,
                     const unsigned int first,
                     const unsigned int width,
                     const std::vector<double> &sizes,
                     const std::vector<double> &low);

  /// Limits the corrections @p corrections, @p width numbers per flow, to the
  /// capacity of the cells. Collective.
  void limit_corrections(const FieldExchange &exchange,
                         const unsigned int width,
                         std::vector<double> &corrections);

  const HexSpace *space_ = nullptr;
  unsigned int n_fields_ = 0;
  CellStencil stencil_;
  FieldExchange mass_exchange_, other_exchange_;
  std::vector<Flow> flows_;
  std::vector<double> carried_;
  /// Capacity of owned cells, by field: upwards, downwards.
  std::vector<double> capacity_;
};
} // namespace contrecoup::ale
