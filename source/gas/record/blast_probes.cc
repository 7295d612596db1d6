// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/gas/record/blast_probes.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>

namespace contrecoup::gas
{
namespace
{
  template <typename Record>
  void write(std::ostream &stream, const std::vector<Record> &records)
  {
    stream.write(reinterpret_cast<const char *>(records.data()),
                 records.size() * sizeof(Record));
  }

  template <typename Record>
  void read(std::istream &stream, std::vector<Record> &records)
  {
    stream.read(reinterpret_cast<char *>(records.data()),
                records.size() * sizeof(Record));
  }
} // namespace


template <int dim>
void BlastProbes<dim>::place(std::vector<dealii::Point<dim>> places,
                             const GasScene<dim> &scene,
                             const std::string &what,
                             const Exposure exposure)
{
  places_ = std::move(places);
  records_.assign(places_.size(), {});
  exposure_ = exposure;
  exposures_.assign(exposure == Exposure::none ? 0 : places_.size(), {});
  ambient_.clear();
  for (const auto &place : places_)
  {
    scene.require_inside(place, what);
    ambient_.push_back(scene.initial_state.ambient_pressure(place));
    if (exposure == Exposure::load_and_chest && !is_habitable(ambient_.back()))
      throw InputError("Probes/Injury: the ambient pressure is " +
                       brief(1e-3 * ambient_.back()) +
                       " kPa at a probe; people live at 45 to 115 kPa");
  }
}


template <int dim>
void BlastProbes<dim>::add(const std::size_t i,
                           const GasState<dim> &state,
                           const double time,
                           const double step)
{
  const double ambient = ambient_[i], overpressure = state.pressure - ambient;
  records_[i].add(overpressure, time, step, Record::threshold * ambient);
  if (exposures_.empty())
    return;
  ExposureRecord &exposure = exposures_[i];
  exposure.waves.add(overpressure, time, records_[i]);
  if (state.density > ExposureRecord::densest_air)
    exposure.give_up();
  if (!(records_[i].peak > 0.) || std::isnan(exposure.load))
    return;
  exposure.add_load(overpressure,
                    0.5 * state.density * state.velocity.norm_square(),
                    ambient,
                    state.products,
                    step);
  if (exposure_ == Exposure::load_and_chest)
    exposure.add_chest(overpressure, step, ambient);
}


template <int dim>
void BlastProbes<dim>::inherit(const KnownRecord<dim> &record)
{
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (const auto known = record(places_[i]))
    {
      records_[i] = *known;
      if (exposures_.empty())
        continue;
      exposures_[i].waves.first = known->peak;
      if (std::isnan(known->peak))
        exposures_[i].give_up();
      else if (known->peak > 0.)
        exposures_[i].continue_after(*known, ambient_[i]);
    }
}


template <int dim>
void BlastProbes<dim>::expect_smearing(const GasSnapshot<dim> &gas)
{
  constexpr double diagonals = 1.5, sound_speed = 330.; // [m/s]
  double distance = std::numeric_limits<double>::max();
  for (unsigned int leaf = 0; leaf < gas.mesh.n_owned(); ++leaf)
    distance = std::min(distance, diagonals * gas.mesh.cell(leaf)->diameter());
  distance = dealii::Utilities::MPI::min(distance, gas.mesh.communicator());
  for (std::size_t i = 0; i < exposures_.size(); ++i)
    if (const double peak = records_[i].peak; peak > 0.)
      // Until the front has passed these cells (Rankine-Hugoniot, gamma 1.4).
      exposures_[i].waves.smeared_until =
        gas.time +
        distance / (sound_speed * std::sqrt(1. + 6. / 7. * peak / ambient_[i]));
}


template <int dim>
void BlastProbes<dim>::save(std::ostream &stream) const
{
  write(stream, records_);
  write(stream, exposures_);
}


template <int dim>
void BlastProbes<dim>::load(std::istream &stream)
{
  read(stream, records_);
  read(stream, exposures_);
}


template class BlastProbes<1>;
template class BlastProbes<2>;
template class BlastProbes<3>;
} // namespace contrecoup::gas
