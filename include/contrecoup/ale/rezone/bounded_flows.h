// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/ale/mesh/cell_stencil.h>

#include <deal.II/base/aligned_vector.h>

namespace contrecoup::ale
{
/**
 * What faces carry from cell to cell when a mesh moves, cut so that no cell
 * gets a density, or another field, beyond what it and the cells around it in
 * its region had. Each flow is that of the donor's mean, which keeps the bounds
 * as long as no cell loses more than its volume, and as much of the rest as the
 * cells have room for (Zalesak 1979); masses first, then what goes with them.
 */
class BoundedFlows
{
public:
  /// @param n_fields numbers at each cell: density, and others per mass
  void reinit(const HexSpace &space, const unsigned int n_fields);

  void clear();

  /**
   * @param volume that the inner cell of @p face gains [m^3]
   * @param donor which cell loses it
   * @param carried what the inner cell gains: mass, and of the other fields
   *   their values times mass
   */
  void add(const HexSpace::Face &face,
           const double volume,
           const std::uint32_t donor,
           const double *carried);

  /**
   * Cuts all flows. Collective.
   * @param fields of all cells before, copies included
   * @param masses of the cells before [kg]
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

  /// Adds what a flow carries to the own ones of its cells.
  void add_to_cells(const Flow &flow,
                    const double *carried,
                    const unsigned int width,
                    std::vector<double> &contents) const;

  /**
   * Sets the room that own cells have: from their contents @p low up to their
   * size times the largest value around, and down to the least.
   * @param sizes volumes or masses afterwards
   * @param first field of those in @p low
   */
  void find_room(const dealii::AlignedVector<double> &fields,
                 const unsigned int first,
                 const unsigned int width,
                 const std::vector<double> &sizes,
                 const std::vector<double> &low);

  /// Cuts @p rest, @p width numbers for each flow, to the room of the cells.
  /// Collective.
  void cut(const FieldExchange &exchange,
           const unsigned int width,
           std::vector<double> &rest);

  const HexSpace *space_ = nullptr;
  unsigned int n_fields_ = 0;
  CellStencil stencil_;
  FieldExchange mass_exchange_, other_exchange_;
  std::vector<Flow> flows_;
  std::vector<double> carried_;
  std::vector<double> room_; ///< of own cells, by field: up, down
};
} // namespace contrecoup::ale
