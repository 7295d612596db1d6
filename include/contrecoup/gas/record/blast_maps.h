// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/state/blast_record.h>
#include <contrecoup/gas/state/gas_field.h>
#include <contrecoup/gas/state/quiet_leaves.h>
#include <contrecoup/materials/gas_material.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Peak overpressure, positive-phase impulse, arrival and duration at every
 * point of every owned leaf; BlastRecord has the rules. Kept in single
 * precision, which costs a relative rounding of 1e-7 and, in the impulse,
 * its accumulation over the steps.
 */
template <int dim>
class BlastMaps
{
public:
  using Record = BlastRecord<float>;

  /// Room for @p n_leaves leaves where nothing has arrived.
  void reinit(const unsigned int n_points, const unsigned int n_leaves);

  /// Whether there is room: maps that a scene does not want have none.
  bool empty() const
  {
    return values_.empty();
  }

  /// The pressure above which overpressures count [Pa].
  void set_ambient(const double pressure)
  {
    ambient_ = pressure;
  }

  /// Takes the state at the end @p time of a step, both [s]. Leaves that are
  /// quiet in @p quiet_leaves, if given, are passed over: nothing happens
  /// there.
  void update(const LeafMesh<dim> &mesh,
              const GasField &field,
              const GasMaterial &material,
              const double time,
              const double step,
              const QuietLeaves<dim> *quiet_leaves = nullptr);

  /// Numbers of one leaf, [value][point].
  unsigned int n_leaf_values() const
  {
    return Record::n_values * n_points_;
  }
  std::vector<float> leaf(const unsigned int leaf) const;
  void set_leaf(const unsigned int leaf, const std::vector<float> &values);

  Record record(const unsigned int leaf, const unsigned int point) const;
  void set_record(const unsigned int leaf,
                  const unsigned int point,
                  const Record &record);

  /// Bytes held on this rank.
  std::size_t memory() const
  {
    return values_.memory_consumption();
  }

private:
  /// Leaves are stored in groups of W: [group][value][point][leaf].
  std::size_t position(const unsigned int leaf,
                       const unsigned int value,
                       const unsigned int point) const
  {
    return ((std::size_t(leaf / W) * Record::n_values + value) * n_points_ +
            point) *
             W +
           leaf % W;
  }

  template <typename Gas>
  void update_group(const unsigned int group,
                    const GasField &field,
                    const Gas &gas,
                    const double time,
                    const double step);

  unsigned int n_points_ = 1;
  double ambient_ = 0.;
  dealii::AlignedVector<float> values_;
};


/// Names and units of what a map shows, in the order of map_values().
extern const std::vector<std::pair<std::string, std::string>> map_quantities;

/// The values of map_quantities.
std::array<double, 4> map_values(const BlastMeasures &measures);
} // namespace contrecoup::gas
