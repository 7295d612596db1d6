// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#pragma once

#include <contrecoup/gas/record/recorder.h>
#include <contrecoup/gas/state/exposure_record.h>
#include <contrecoup/gas/state/point_sampler.h>

namespace contrecoup::gas
{
/// Records of probes on the exposure of people, see ExposureRecord.
enum class Exposure
{
  none,
  load,          ///< alone
  load_and_chest ///< the motion of the chest wall as well
};


/// Probes at fixed positions, independent of mesh adaptation: for each, its
/// position, the initial pressure and the records so far.
template <int dim>
class BlastProbes
{
public:
  using Record = BlastRecord<double>;

  /// Sets up probes at @p places [m] that no blast has reached.
  /// @throws InputError for a position outside of the domain, see
  /// GasScene::require_inside(), and for Exposure::load_and_chest at an ambient
  /// pressure out of the 45 to 115 kPa at which people live, is_habitable()
  void place(std::vector<dealii::Point<dim>> places,
             const GasScene<dim> &scene,
             const std::string &what,
             const Exposure exposure = Exposure::none);

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

  /// Adds the state at probe @p i at the end @p time of a step [s].
  void add(const std::size_t i,
           const GasState<dim> &state,
           const double time,
           const double step);

  /// Continues the records of an earlier stage.
  void inherit(const KnownRecord<dim> &record);

  /// Expects that cells other than those before smear the fronts that have
  /// reached a probe. Collective.
  void expect_smearing(const GasSnapshot<dim> &gas);

  Exposure exposure() const
  {
    return exposure_;
  }
  /// Exposure at each probe; empty if none is recorded.
  std::vector<ExposureRecord> &exposures()
  {
    return exposures_;
  }
  const std::vector<ExposureRecord> &exposures() const
  {
    return exposures_;
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
  Exposure exposure_ = Exposure::none;
  std::vector<ExposureRecord> exposures_;
  PointSampler<dim> sampler_;
};
} // namespace contrecoup::gas
