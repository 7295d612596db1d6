// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/blast_maps.h>
#include <contrecoup/gas/gas_field.h>
#include <contrecoup/gas/leaf_transfer.h>

#include <deal.II/base/parameter_handler.h>

#include <functional>

namespace contrecoup::gas
{
/// Which leaves are halved or merged, as subsection "Adaptation" says.
struct AdaptationParameters
{
  static void declare_parameters(dealii::ParameterHandler &prm);
  /// @throws InputError when smallest and largest contradict each other.
  void parse_parameters(dealii::ParameterHandler &prm,
                        const unsigned int dim,
                        const unsigned int initial_refinement,
                        const unsigned int n_points,
                        const bool is_finite_volume,
                        const bool is_axis_aligned);

  bool active = false;
  unsigned int interval = 5;    ///< steps between adaptations
  unsigned int least_level = 0; ///< refinements of the coarse mesh
  unsigned int most_level = 0;
  double refine = 0.3;        ///< sensor above which leaves are halved
  double coarsen = 0.1;       ///< sensor below which they are merged
  bool pressure_only = false; ///< sensor blind to contacts
  double noise = 0.02;        ///< relative jump that counts as noise
  unsigned int buffer = 1;    ///< layers of leaves around marked ones
  /// A box whose leaves stay at this level at least; level 0: none.
  unsigned int fine_level = 0;
  std::vector<double> fine_lower; ///< [m]
  std::vector<double> fine_upper; ///< [m]

private:
  void check(const unsigned int dim,
             const unsigned int n_points,
             const bool is_finite_volume,
             const bool is_axis_aligned) const;
};

/**
 * Adapts the octree to the gas: marks leaves by the ratio of second to
 * first differences of density and pressure (Loehner 1987), spreads the
 * marks ahead of the fronts, and carries the state over.
 */
template <int dim>
class Adaptation
{
public:
  Adaptation(const AdaptationParameters &parameters,
             LeafMesh<dim> &mesh,
             const LeafPoints<dim> &points,
             const GasMaterial &material);

  /// Adapts mesh, field and, unless they are empty, maps once. Returns
  /// whether anything changed. The field's ghosts must be up to date.
  /// Collective.
  bool adapt(GasField &field, BlastMaps<dim> &maps);
  bool adapt(GasField &field)
  {
    BlastMaps<dim> none;
    return adapt(field, none);
  }

  /// Halves every leaf below the largest level for which @p wanted is
  /// true, without carrying the field over. Returns whether any was.
  bool refine_where(const std::function<bool(const unsigned int leaf)> &wanted);

  /// Halves the leaves in the fine box until they have its level.
  void refine_fine_box();

  /// Sensor of each owned leaf, from 0 (smooth) to 1 (a jump). The field's
  /// ghosts must be up to date.
  std::vector<double> sensors(const GasField &field) const;

private:
  using CellIterator = typename LeafMesh<dim>::CellIterator;
  using ActiveIterator =
    typename dealii::Triangulation<dim>::active_cell_iterator;
  using Marks = std::function<double(const CellIterator &)>;

  /// Level that a leaf must not fall below.
  unsigned int least_level(const unsigned int leaf) const;
  bool refine_flagged();
  void spread(std::vector<double> &marks) const;
  /// Largest mark beyond a face of leaves that are not coarser.
  double largest_mark(const CellIterator &cell,
                      const unsigned int face,
                      const Marks &mark) const;
  void set_flags(const std::vector<double> &marks);
  void carry_over(GasField &field, BlastMaps<dim> &maps);
  /// In 1-D, changes the flags so that neighbours stay within one level and
  /// siblings merge together.
  void balance_line();
  void carry_over_line(GasField &field, BlastMaps<dim> &maps);

  const AdaptationParameters parameters_;
  LeafMesh<dim> &mesh_;
  const LeafPoints<dim> points_;
  const GasMaterial material_;
};
} // namespace contrecoup::gas
