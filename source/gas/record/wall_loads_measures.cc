// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/wall_loads.h>
#include <contrecoup/io/output/load_file.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace contrecoup::gas
{
namespace
{
  /// Projections of the whole body's skin on the three planes of coordinates,
  /// summed: those of stairs are those of the surface that the stairs follow.
  /// @param geometry of the facets, see WallFacets::geometry()
  /// @param to_whole see factors_to_whole_body()
  double skin_projections(const std::vector<double> &geometry,
                          const dealii::Tensor<1, 3> &to_whole)
  {
    double sum = 0.;
    for (std::size_t i = 3; i < geometry.size(); i += WallFacets<3>::n_geometry)
      for (unsigned int d = 0; d < 3; ++d)
        sum += std::abs(geometry[i + d]);
    // Three planes of symmetry leave no factor of a direction.
    const double factor = std::max({to_whole[0], to_whole[1], to_whole[2]});
    return (factor > 0. ? factor : 8.) * sum;
  }
} // namespace


template <int dim>
void WallLoads<dim>::write_measures()
{
  std::array<std::vector<double>, 4> values;
  double highest = 0.;
  for (const Record &record : records_)
  {
    const auto known = recorded_map_values(record.blast.measures(totals_.time));
    for (std::size_t k = 0; k < values.size(); ++k)
      values[k].push_back(known[k]);
    highest = std::max(highest, record.blast.peak);
  }
  totals_.peak_loss = gauges_.largest_peak_loss();
  for (const Record &record : records_)
    if (record.blast.peak > counted_fraction * highest)
      totals_.peak_loss = std::max(totals_.peak_loss,
                                   1. - record.sample_peak / record.blast.peak);
  io::LoadFile file(file_);
  const char *const names[] = {"peak", "impulse", "arrival", "duration"};
  for (unsigned int k = 0; k < 4; ++k)
    file.write(names[k], values[k]);
  io::LoadFile::Numbers numbers = {{"ambient_pressure_Pa", ambient_}};
  for (const auto &values_of : {check_values(), result_values()})
    for (const NamedValue &value : values_of)
      numbers.emplace_back(value.name, value.value);
  file.write(numbers);
}


template <int dim>
std::vector<double> WallLoads<dim>::overpressures() const
{
  std::vector<double> result;
  for (const auto &facet : facets_.owned())
    result.push_back(records_[facet.number].last);
  return result;
}


template <int dim>
std::vector<NamedValue> WallLoads<dim>::result_values() const
{
  std::vector<NamedValue> values;
  for (unsigned int d = 0; d < dim; ++d)
    values.push_back({std::string("loads_impulse_") + "xyz"[d],
                      is_plane_ ? "N s/m" : "N s",
                      0. + to_whole_[d] * totals_.facet_impulse[d]}); // not -0
  for (const NamedValue &value : gauges_.measures(totals_.time))
    values.push_back(value);
  return values;
}


template <int dim>
std::vector<NamedValue> WallLoads<dim>::check_values() const
{
  const auto relative = [](const double part, const double whole) {
    return whole > 0. ? part / whole : 0.;
  };
  std::vector<NamedValue> values = {
    {"loads_facets", "-", double(facets_.n_global())},
    {"loads_impulse_difference",
     "-",
     relative((totals_.facet_impulse - totals_.gas_impulse).norm(),
              totals_.gas_impulse.norm())},
    {"loads_force_difference",
     "-",
     relative(totals_.largest_difference, totals_.largest_force)},
    {"loads_sampled_peak_loss", "-", totals_.peak_loss}};
  if (dim == 3)
    values.push_back({"loads_skin_projections",
                      "m^2",
                      skin_projections(facets_.geometry(), to_whole_)});
  return values;
}


#define CONTRECOUP_INSTANTIATE(dim)                                       \
  template void WallLoads<dim>::write_measures();                         \
  template std::vector<double> WallLoads<dim>::overpressures() const;     \
  template std::vector<NamedValue> WallLoads<dim>::result_values() const; \
  template std::vector<NamedValue> WallLoads<dim>::check_values() const

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
