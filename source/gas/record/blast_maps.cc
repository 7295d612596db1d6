// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/gas/record/blast_maps.h>
#include <contrecoup/gas/record/gas_measures.h>
#include <contrecoup/gas/record/record_gaps.h>
#include <contrecoup/gas/state/leaf_sampling.h>
#include <contrecoup/gas/state/primitive.h>

namespace contrecoup::gas
{
const std::vector<std::pair<std::string, std::string>> map_quantities = {
  {"peak_overpressure", "Pa"},
  {"impulse", "Pa s"},
  {"arrival", "s"},
  {"duration", "s"}};


std::array<double, 4> map_values(const BlastMeasures &measures)
{
  return {
    {measures.peak, measures.impulse, measures.arrival, measures.duration}};
}


std::array<double, 4> recorded_map_values(const BlastMeasures &measures)
{
  if (measures.peak > 0.)
    return map_values(measures);
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  return {{unknown, unknown, unknown, unknown}};
}


const std::vector<std::pair<std::string, std::string>> map_fields = [] {
  auto fields = map_quantities;
  fields.emplace_back("cut_off", "-");
  return fields;
}();


std::array<double, 5> map_field_values(const BlastMeasures &measures,
                                       const double time)
{
  const auto [peak, impulse, arrival, duration] = recorded_map_values(measures);
  const double is_cut = is_cut_off(measures, time) ? 1. : 0.;
  return {{peak, impulse, arrival, duration, std::isnan(peak) ? peak : is_cut}};
}


template <int dim>
void BlastMaps<dim>::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Output");
  declare_bool(prm,
               "Maps",
               "false",
               "Whether the fields hold peak overpressure, positive-phase "
               "impulse, arrival and duration of the blast at every point, "
               "not a number where none has arrived, and cut_off, 1 where the "
               "positive phase lasts; they cost some per cent of the run "
               "time.");
}


template <int dim>
void BlastMaps<dim>::parse_parameters(ParameterHandler &prm,
                                      const GasScene<dim> & /*scene*/)
{
  const Section section(prm, "Output");
  wanted_ = prm.get_bool("Maps");
}


template <int dim>
void BlastMaps<dim>::reinit(const unsigned int n_points,
                            const unsigned int n_leaves)
{
  n_points_ = n_points;
  const std::size_t n_groups = (n_leaves + double_width - 1) / double_width;
  values_.clear();
  // A rank without leaves keeps one group, so that empty() is false there too.
  values_.resize(std::max<std::size_t>(n_groups, 1) * double_width *
                 n_leaf_values());
}


template <int dim>
void BlastMaps<dim>::mesh_changed(const GasSnapshot<dim> &gas)
{
  const auto &tria = gas.mesh.triangulation();
  const typename LeafMesh<dim>::CellIterator last(
    &tria, 0, tria.n_cells(0) - 1);
  ambient_ =
    gas.scene.initial_state.ambient_pressure(last->vertex((1U << dim) - 1));
}


template <int dim>
void BlastMaps<dim>::begin(const GasSnapshot<dim> &gas)
{
  if (wanted_)
    reinit(gas.scene.layout.n_points, gas.mesh.n_owned());
}


template <int dim>
void BlastMaps<dim>::inherit(const KnownRecord<dim> &record,
                             const GasSnapshot<dim> &gas)
{
  for (unsigned int leaf = 0; !empty() && leaf < gas.mesh.n_owned(); ++leaf)
  {
    const LeafBox<dim> box = leaf_box(gas.mesh, leaf);
    for (unsigned int q = 0; q < n_points_; ++q)
      if (const auto known = record(gas.scene.place(box, q)))
        set_record(leaf, q, converted<float>(*known));
  }
}


template <int dim>
template <typename Gas>
void BlastMaps<dim>::update_group(const unsigned int group,
                                  const GasSnapshot<dim> &gas,
                                  const Gas &model)
{
  constexpr unsigned int nc = n_conserved<dim, Gas>;
  const GasField &field = gas.field;
  const auto now = static_cast<float>(gas.time);
  const auto passed = static_cast<float>(gas.step);
  const auto smallest = static_cast<float>(Record::threshold * ambient_);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    std::array<Lanes<double>, nc> u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = field.values(group * double_width, c, q);
    Lanes<double> pressure =
      to_primitive<dim>(model, u)[Component<dim>::pressure];
    for (unsigned int lane = 0; lane < double_width && field.burn() != nullptr;
         ++lane)
      pressure[lane] = field.exerted_pressure(
        pressure[lane], field.burned(group * double_width + lane, q));
    std::array<float, double_width> overpressure;
    for (unsigned int lane = 0; lane < double_width; ++lane)
      overpressure[lane] = static_cast<float>(pressure[lane] - ambient_);

    float *first = &values_[position(group * double_width, 0, q)];
    const std::size_t stride = std::size_t(n_points_) * double_width;
    for (unsigned int lane = 0; lane < double_width; ++lane)
    {
      Record record = {first[lane],
                       first[lane + stride],
                       first[lane + 2 * stride],
                       first[lane + 3 * stride],
                       first[lane + 4 * stride]};
      record.add(overpressure[lane], now, passed, smallest);
      first[lane] = record.peak;
      first[lane + stride] = record.arrival;
      first[lane + 2 * stride] = record.running;
      first[lane + 3 * stride] = record.impulse;
      first[lane + 4 * stride] = record.end;
    }
  }
}


template <int dim>
void BlastMaps<dim>::add_step(const GasSnapshot<dim> &gas)
{
  if (empty())
    return;
  const TimerScope timer("maps");
  // Quiet leaves may be skipped only if the ambient state of the run is that of
  // the maps.
  const auto is_passed_over = [&](const unsigned int first) {
    const unsigned int end = std::min(first + double_width, gas.mesh.n_owned());
    for (unsigned int leaf = first; leaf < end; ++leaf)
      if (!gas.quiet_leaves.is_quiet(leaf))
        return false;
    std::vector<double> state(gas.field.layout().n_components);
    for (unsigned int c = 0; c < state.size(); ++c)
      state[c] = gas.field.values(first, c, 0)[0];
    const double pressure =
      primitive_state<dim>(state.data(), gas.scene.material).pressure;
    return std::abs(pressure - ambient_) < Record::threshold * ambient_;
  };
  std::visit(
    [&](const auto &model) {
      for (unsigned int leaf = 0; leaf < gas.mesh.n_owned();
           leaf += double_width)
        if (!is_passed_over(leaf))
          update_group(leaf / double_width, gas, model);
    },
    gas.scene.material.model());
}


template <int dim>
std::vector<float>
BlastMaps<dim>::leaf_of(const dealii::AlignedVector<float> &values,
                        const unsigned int leaf) const
{
  std::vector<float> result;
  for (unsigned int v = 0; v < Record::n_values; ++v)
    for (unsigned int q = 0; q < n_points_; ++q)
      result.push_back(values[position(leaf, v, q)]);
  return result;
}


template <int dim>
void BlastMaps<dim>::set_leaf(const unsigned int leaf,
                              const std::vector<float> &values)
{
  for (unsigned int v = 0; v < Record::n_values; ++v)
    for (unsigned int q = 0; q < n_points_; ++q)
      values_[position(leaf, v, q)] = values[v * n_points_ + q];
}


template <int dim>
typename BlastMaps<dim>::Record
BlastMaps<dim>::record(const unsigned int leaf, const unsigned int point) const
{
  return {values_[position(leaf, 0, point)],
          values_[position(leaf, 1, point)],
          values_[position(leaf, 2, point)],
          values_[position(leaf, 3, point)],
          values_[position(leaf, 4, point)]};
}


template <int dim>
void BlastMaps<dim>::set_record(const unsigned int leaf,
                                const unsigned int point,
                                const Record &record)
{
  values_[position(leaf, 0, point)] = record.peak;
  values_[position(leaf, 1, point)] = record.arrival;
  values_[position(leaf, 2, point)] = record.running;
  values_[position(leaf, 3, point)] = record.impulse;
  values_[position(leaf, 4, point)] = record.end;
}


template class BlastMaps<1>;
template class BlastMaps<2>;
template class BlastMaps<3>;
} // namespace contrecoup::gas
