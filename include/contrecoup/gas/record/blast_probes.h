// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/gas/state/point_sampler.h>

namespace contrecoup::gas
{
/// Gauges that stand still while the mesh adapts: their places, the pressures
/// there before anything happened, and what the blast did at each so far.
template <int dim>
class BlastProbes
{
public:
  using Record = BlastRecord<double>;

  /// Sets up gauges at @p places, where nothing has arrived.
  /// @throws InputError for a place outside of the domain, see
  /// GasScene::require_inside()
  void place(std::vector<dealii::Point<dim>> places,
             const GasScene<dim> &scene,
             const std::string &what);

  const std::vector<dealii::Point<dim>> &places() const
  {
    return places_;
  }
  std::size_t size() const
  {
    return places_.size();
  }

  /// Finds the leaves of the gauges. Collective.
  void mesh_changed(const GasSnapshot<dim> &gas)
  {
    if (!places_.empty())
      sampler_.reinit(places_, gas.mesh, gas.scene.points);
  }

  const PointSampler<dim> &sampler() const
  {
    return sampler_;
  }

  /// Takes the pressure [Pa] at gauge @p i at the end @p time of a step [s].
  void add(const std::size_t i,
           const double pressure,
           const double time,
           const double step)
  {
    records_[i].add(
      pressure - ambient_[i], time, step, Record::threshold * ambient_[i]);
  }

  std::vector<Record> &records()
  {
    return records_;
  }
  const std::vector<Record> &records() const
  {
    return records_;
  }

  /// The records, for checkpoints.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  std::vector<dealii::Point<dim>> places_;
  std::vector<double> ambient_; ///< [Pa]
  std::vector<Record> records_;
  PointSampler<dim> sampler_;
};
} // namespace contrecoup::gas
