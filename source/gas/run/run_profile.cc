// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/version.h>
#include <contrecoup/gas/conditions/profile_field.h>
#include <contrecoup/gas/hand_over/profile_extraction.h>
#include <contrecoup/gas/run/run_profile.h>

#include <limits>

namespace contrecoup::gas
{
namespace
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  /// Record of a wave that was not recorded: no number becomes known later.
  constexpr BlastRecord<double> unknown_record = {nan, nan, nan, nan, nan};
} // namespace


bool has_records(const Profile &profile)
{
  return profile.data().maps.count(record_names[0]) > 0;
}


template <int dim>
KnownRecord<dim> records_of(const ProfileField<dim> &profile)
{
  using Record = BlastRecord<double>;
  return [&profile](const dealii::Point<dim> &place) -> std::optional<Record> {
    const auto here = profile.window(place, {});
    if (profile.is_beyond(here))
      return {};
    if (!has_records(profile.profile()))
      return unknown_record;
    std::array<double, Record::n_values> numbers;
    for (unsigned int v = 0; v < numbers.size(); ++v)
      numbers[v] = profile.profile().map_value(record_names[v], here.place, 0.);
    return Record{numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]};
  };
}


template <int dim>
ProfileData make_profile(const GasCore<dim> &core, const BlastMaps<dim> &maps)
{
  if (core.is_burning())
    throw InputError("The profile cannot be made before all explosive has "
                     "burned; end the run, or hand over, later");
  const GasScene<dim> &scene = core.scene();
  ProfileData data = extract_profile(core.mesh(),
                                     scene.points,
                                     core.field(),
                                     scene.material,
                                     scene.ambient(),
                                     maps);
  data.time = core.time();
  data.material = scene.material_words;
  data.afterburn_fraction = core.afterburn().fraction();
  data.afterburn_released = core.afterburn().released();
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
