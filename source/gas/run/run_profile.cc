// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/run/run_profile.h>

namespace contrecoup::gas
{
namespace
{
  /// Names of the maps of a profile with the members of BlastRecord.
  using Record = BlastRecord<double>;
  const std::vector<std::pair<std::string, double Record::*>> record_maps = {
    {"peak_overpressure", &Record::peak},
    {"arrival", &Record::arrival},
    {"running_impulse", &Record::running},
    {"impulse", &Record::impulse},
    {"end", &Record::end}};
} // namespace


template <int dim>
KnownRecord<dim> records_of(const ProfileField<dim> &profile)
{
  return [&profile](const dealii::Point<dim> &place) -> std::optional<Record> {
    const auto here = profile.window(place, {});
    if (profile.profile().data().maps.count(record_maps[0].first) == 0 ||
        profile.is_beyond(here))
      return {};
    Record record;
    for (const auto &[name, number] : record_maps)
      record.*number = profile.profile().map_value(name, here.place, 0.);
    return record;
  };
}


template <int dim>
ProfileData make_profile(const GasCore<dim> &core, const BlastMaps<dim> &maps)
{
  if (core.is_burning())
    throw InputError("The profile cannot be made before all explosive has "
                     "burned; end the run, or hand over, later");
  const GasScene<dim> &scene = core.scene();
  ProfileData data = extract_profile(
    core.mesh(), scene.points, core.field(), scene.material, scene.ambient());
  data.time = core.time();
  data.material = scene.material_words;
  data.afterburn_fraction = core.afterburn().fraction();
  data.afterburn_released = core.afterburn().released();
  // 1-D meshes are uniform: their subcells are the cells of the profile.
  const std::size_t n = data.values[0].size();
  if (dim == 1 && !maps.empty())
    for (const auto &[name, number] : record_maps)
      for (std::size_t cell = 0; cell < n; ++cell)
      {
        const auto record =
          maps.record(cell / scene.layout.n, cell % scene.layout.n);
        data.maps[name].push_back(converted<double>(record).*number);
      }
  data.version = version() + " (" + git_revision() + ")";
  return data;
}


#define CONTRECOUP_INSTANTIATE(dim)                          \
  template ProfileData make_profile(const GasCore<dim> &,    \
                                    const BlastMaps<dim> &); \
  template KnownRecord<dim> records_of(const ProfileField<dim> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
