// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>

#include <deal.II/base/aligned_vector.h>

#include <vector>

namespace contrecoup::gas
{
/**
 * Fields of peak overpressure, positive-phase impulse, arrival and duration:
 * one BlastRecord for each point of every owned leaf. Single precision costs a
 * relative rounding error of 1e-7 and, in the impulse, its accumulation over
 * the steps.
 */
template <int dim>
class BlastMaps : public Recorder<dim>
{
public:
  using Record = BlastRecord<float>;

  /// Declares "Output/Maps".
  static void declare_parameters(dealii::ParameterHandler &prm);
  void parse_parameters(dealii::ParameterHandler &prm,
                        const GasScene<dim> &scene) override;

  /// Whether the scene asks for maps.
  bool wanted() const
  {
    return wanted_;
  }

  void mesh_changed(const GasSnapshot<dim> &gas) override;
  void begin(const GasSnapshot<dim> &gas) override;
  void inherit(const KnownRecord<dim> &record,
               const GasSnapshot<dim> &gas) override;
  /// Skips quiet leaves, whose records do not change.
  void add_step(const GasSnapshot<dim> &gas) override;

  /// Allocates records for @p n_leaves leaves that no blast has reached.
  void reinit(const unsigned int n_points, const unsigned int n_leaves);

  /// Allocates like reinit(), and keeps the records before as the former ones
  /// until end_change().
  void begin_change(const unsigned int n_leaves)
  {
    former_values_.swap(values_);
    reinit(n_points_, n_leaves);
  }
  void end_change()
  {
    former_values_.clear();
  }
  std::vector<float> former_leaf(const unsigned int leaf) const
  {
    return leaf_of(former_values_, leaf);
  }

  /// Whether no records are allocated, as in scenes without maps.
  bool empty() const
  {
    return values_.empty();
  }

  /// Number of values of one leaf. leaf() and set_leaf() order them
  /// [value][point].
  unsigned int n_leaf_values() const
  {
    return Record::n_values * n_points_;
  }
  std::vector<float> leaf(const unsigned int leaf) const
  {
    return leaf_of(values_, leaf);
  }
  void set_leaf(const unsigned int leaf, const std::vector<float> &values);

  Record record(const unsigned int leaf, const unsigned int point) const;
  void set_record(const unsigned int leaf,
                  const unsigned int point,
                  const Record &record);

  /// Memory on this rank [bytes].
  std::size_t memory() const
  {
    return values_.memory_consumption();
  }

private:
  /// Leaves are stored in groups of double_width: [group][value][point][leaf].
  std::size_t position(const unsigned int leaf,
                       const unsigned int value,
                       const unsigned int point) const
  {
    return ((std::size_t(leaf / double_width) * Record::n_values + value) *
              n_points_ +
            point) *
             double_width +
           leaf % double_width;
  }

  std::vector<float> leaf_of(const dealii::AlignedVector<float> &values,
                             const unsigned int leaf) const;
  template <typename Gas>
  void update_group(const unsigned int group,
                    const GasSnapshot<dim> &gas,
                    const Gas &model);

  bool wanted_ = false;
  unsigned int n_points_ = 1;
  double ambient_ = 0.; ///< pressure [Pa]
  dealii::AlignedVector<float> values_;
  dealii::AlignedVector<float> former_values_;
};


/// Converts a record to another precision.
template <typename To, typename From>
BlastRecord<To> converted(const BlastRecord<From> &record)
{
  return {To(record.peak),
          To(record.arrival),
          To(record.running),
          To(record.impulse),
          To(record.end)};
}


/// Names and units of the four map quantities, in the order of map_values().
extern const std::vector<std::pair<std::string, std::string>> map_quantities;

/// The values of map_quantities.
std::array<double, 4> map_values(const BlastMeasures &measures);

/// The same of a record: not a number where no blast has arrived.
std::array<double, 4> recorded_map_values(const BlastMeasures &measures);

/// Names and units of the fields of maps: map_quantities, and "cut_off", which
/// is 1 where impulse and duration are lower limits.
extern const std::vector<std::pair<std::string, std::string>> map_fields;

/// The values of map_fields of a record that ends at @p time [s].
std::array<double, 5> map_field_values(const BlastMeasures &measures,
                                       double time);
} // namespace contrecoup::gas
