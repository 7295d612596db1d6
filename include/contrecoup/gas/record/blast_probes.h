// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/gas/state/point_sampler.h>

namespace contrecoup::gas
{
/// Probes at fixed positions, independent of mesh adaptation: for each, its
/// position, the initial pressure and the BlastRecord so far.
template <int dim>
class BlastProbes
{
public:
  using Record = BlastRecord<double>;

  /// Sets up probes at @p places [m] that no blast has reached.
  /// @throws InputError for a position outside of the domain, see
  /// GasScene::require_inside()
  void place(std::vector<dealii::Point<dim>> places,
             const GasScene<dim> &scene,
             const std::string &what);

  const std::vector<dealii::Point<dim>> &places() const
  {
    return places_;
  }
  /// Initial pressure at each probe [Pa].
  const std::vector<double> &ambient() const
  {
    return ambient_;
  }
  std::size_t size() const
  {
    return places_.size();
  }

  /// Locates the probes in the leaves of the mesh. Collective.
  void mesh_changed(const GasSnapshot<dim> &gas)
  {
    if (!places_.empty())
      sampler_.reinit(places_, gas.mesh, gas.scene.points);
  }

  const PointSampler<dim> &sampler() const
  {
    return sampler_;
  }

  /// Adds the pressure [Pa] at probe @p i at the end @p time of a step [s].
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

  /// Writes and reads the records of a checkpoint.
  void save(std::ostream &stream) const;
  void load(std::istream &stream);

private:
  std::vector<dealii::Point<dim>> places_;
  std::vector<double> ambient_; ///< [Pa]
  std::vector<Record> records_;
  PointSampler<dim> sampler_;
};
} // namespace contrecoup::gas
