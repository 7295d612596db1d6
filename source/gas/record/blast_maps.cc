// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/gas/record/blast_maps.h>
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


template <int dim>
void BlastMaps<dim>::reinit(const unsigned int n_points,
                            const unsigned int n_leaves)
{
  n_points_ = n_points;
  const std::size_t n_groups = (n_leaves + W - 1) / W;
  values_.clear();
  // A rank without leaves keeps one group, so that it knows of its maps.
  values_.resize(std::max<std::size_t>(n_groups, 1) * W * n_leaf_values());
}


template <int dim>
template <typename Gas>
void BlastMaps<dim>::update_group(const unsigned int group,
                                  const GasField &field,
                                  const Gas &gas,
                                  const double time,
                                  const double step)
{
  constexpr unsigned int nc = n_conserved<dim, Gas>;
  const auto now = static_cast<float>(time);
  const auto passed = static_cast<float>(step);
  const auto smallest = static_cast<float>(Record::threshold * ambient_);
  for (unsigned int q = 0; q < n_points_; ++q)
  {
    std::array<Lanes<double>, nc> u;
    for (unsigned int c = 0; c < nc; ++c)
      u[c] = field.values(group * W, c, q);
    Lanes<double> pressure = to_primitive<dim>(gas, u)[Component<dim>::energy];
    for (unsigned int lane = 0; lane < W && field.burn() != nullptr; ++lane)
      pressure[lane] = field.exerted_pressure(
        pressure[lane], field.burned(group * W + lane, q));
    std::array<float, W> overpressure;
    for (unsigned int lane = 0; lane < W; ++lane)
      overpressure[lane] = static_cast<float>(pressure[lane] - ambient_);

    float *first = &values_[position(group * W, 0, q)];
    const std::size_t stride = std::size_t(n_points_) * W;
    for (unsigned int lane = 0; lane < W; ++lane)
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
void BlastMaps<dim>::update(const LeafMesh<dim> &mesh,
                            const GasField &field,
                            const GasMaterial &material,
                            const double time,
                            const double step,
                            const QuietLeaves<dim> *quiet_leaves)
{
  // Quiet leaves hold the ambient state of the run, which need not be that of
  // the maps: then every leaf counts.
  const auto is_passed_over = [&](const unsigned int first) {
    const unsigned int end = std::min(first + W, mesh.n_owned());
    for (unsigned int leaf = first; leaf < end; ++leaf)
      if (quiet_leaves == nullptr || !quiet_leaves->is_quiet(leaf))
        return false;
    std::vector<double> state(field.layout().n_components);
    for (unsigned int c = 0; c < state.size(); ++c)
      state[c] = field.values(first, c, 0)[0];
    const double pressure =
      primitive_state<dim>(state.data(), material).pressure;
    return std::abs(pressure - ambient_) < Record::threshold * ambient_;
  };
  std::visit(
    [&](const auto &gas) {
      for (unsigned int leaf = 0; leaf < mesh.n_owned(); leaf += W)
        if (!is_passed_over(leaf))
          update_group(leaf / W, field, gas, time, step);
    },
    material.model());
}


template <int dim>
std::vector<float> BlastMaps<dim>::leaf(const unsigned int leaf) const
{
  std::vector<float> result;
  for (unsigned int v = 0; v < Record::n_values; ++v)
    for (unsigned int q = 0; q < n_points_; ++q)
      result.push_back(values_[position(leaf, v, q)]);
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
