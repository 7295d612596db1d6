// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/io/file/state_file.h>
#include <contrecoup/solid/motion/solid_body.h>

#include <cstddef>

namespace contrecoup::solid
{
/// Header of each checkpoint file: global values.
template <typename Real>
struct SolidBody<Real>::CheckpointHeader
{
  std::uint64_t n_global_nodes;
  std::uint64_t n_global_elements;
  std::uint64_t n_tissues;
  /// relaxed strain components per viscoelastic element
  std::uint64_t n_relaxed;
  std::uint64_t number_size;
  double time;
  double relaxed_time;
  StepTimes times;
  double external_work;
  double nodal_work;
  double step_change;
  double initial_energy;
  double least_volume;
  double computed_updates;
  double total_updates;
};

namespace
{
  /// Displacement, velocity, the four numbers of the force, and the reaction
  /// part of the force.
  template <typename Real>
  struct NodeRecord
  {
    std::uint32_t number;
    std::array<Real, 10> values;
    std::array<double, 3> reaction;
  };

  /// Dilatation, viscous pressure, both numbers of PressureSmoothing, and
  /// relaxed strains at up to 8 points.
  template <typename Real>
  struct CellRecord
  {
    std::uint32_t number;
    std::array<Real, 52> values;

    /// Number of bytes used with @p n_relaxed relaxed strain components.
    static std::size_t size(const std::uint64_t n_relaxed)
    {
      return offsetof(CellRecord, values) + sizeof(Real) * (4 + n_relaxed);
    }
  };

  /// Hourglass damping forces.
  template <typename Real>
  struct DampingRecord
  {
    std::uint32_t number;
    std::array<Real, 12> values;
  };

  template <typename Real>
  std::array<Real, 10> node_values(const NodeFields<Real> &nodes,
                                   const std::size_t i)
  {
    std::array<Real, 10> values;
    for (unsigned int d = 0; d < 3; ++d)
    {
      values[d] = nodes.displacement_of(i)[d];
      values[3 + d] = nodes.velocity_of(i)[d];
      values[6 + d] = nodes.force_of(i)[d];
    }
    values[9] = nodes.force_of(i)[3];
    return values;
  }

  /// Calls @p function with each history variable of an element.
  template <typename Batches, typename Function>
  void for_each_state(Batches &batches,
                      const std::uint32_t cell,
                      const Function &function)
  {
    const std::uint32_t slot = batches.slot(cell);
    const unsigned int batch = slot / batches.n, lane = slot % batches.n;
    function(0, batches.dilatation[batch][lane]);
    function(1, batches.viscous_pressure[batch][lane]);
    if (batches.smoothing_pressure.size() > 0)
    {
      function(2, batches.smoothing_pressure[batch][lane]);
      function(3, batches.smooth_dilatation[batch][lane]);
    }
    for (const auto &range : batches.ranges())
      if (range.viscoelastic && batch >= range.begin && batch < range.end)
        for (unsigned int k = 0; k < batches.n_relaxed(); ++k)
          function(4 + k, batches.relaxed_of(range, batch)[k][lane]);
  }

  /// Calls @p function(index, lane) for the damping forces of an element, if
  /// it has any.
  template <typename Batches, typename Function>
  void for_damping(Batches &batches,
                   const std::uint32_t cell,
                   const Function &function)
  {
    const std::uint32_t slot = batches.slot(cell);
    const unsigned int batch = slot / batches.n, lane = slot % batches.n;
    for (const auto &range : batches.ranges())
      if (range.damped && batch >= range.begin && batch < range.end)
        function(
          &batches.damping[range.first_damping + 12 * (batch - range.begin)],
          lane);
  }
} // namespace


template <typename Real>
void SolidBody<Real>::save(const std::string &folder) const
{
  std::vector<std::array<double, 3>> reactions(mesh_.nodes.size());
  Supports supports = supports_;
  supports.for_each_reaction(
    [&](const std::uint32_t node, const unsigned int d, const double value) {
      reactions[node][d] = value;
    });
  std::vector<DampingRecord<Real>> damping;
  for (std::size_t i = 0; i < mesh_.elements.size(); ++i)
    for_damping(
      operator_.batches(), i, [&](const auto *forces, const unsigned int lane) {
        damping.push_back({mesh_.global_element[i], {}});
        for (unsigned int k = 0; k < 12; ++k)
          damping.back().values[k] = forces[k][lane];
      });
  io::save_part(folder, "solid", communicator_, [&](io::StateWriter &out) {
    out.put(CheckpointHeader{mesh_.n_global_nodes,
                             mesh_.n_global_elements,
                             mesh_.tissues.size(),
                             operator_.batches().n_relaxed(),
                             sizeof(Real),
                             time_,
                             time_of_relaxed_strain_,
                             times_,
                             external_work_,
                             nodal_work_,
                             step_change_,
                             initial_energy_,
                             least_volume_,
                             computed_updates_,
                             total_updates_});
    for (const TissueEnergies &one : operator_.losses())
      out.put(one);
    out.put_records(mesh_.nodes.size(), [&](const std::size_t i) {
      return NodeRecord<Real>{
        mesh_.global_node[i], node_values(nodes_, i), reactions[i]};
    });
    const std::size_t bytes =
      CellRecord<Real>::size(operator_.batches().n_relaxed());
    out.put(static_cast<std::uint64_t>(mesh_.elements.size()));
    for (std::size_t i = 0; i < mesh_.elements.size(); ++i)
    {
      CellRecord<Real> record{mesh_.global_element[i], {}};
      for_each_state(
        operator_.batches(), i, [&](const unsigned int k, const Real value) {
          record.values[k] = value;
        });
      out.put_bytes(&record, bytes);
    }
    out.put_list(damping);
  });
  slip_.save(folder, communicator_);
}


template <typename Real>
void SolidBody<Real>::restore(const std::string &folder)
{
  std::vector<std::array<double, 3>> reactions(mesh_.nodes.size());
  const io::NumberIndex nodes =
                          io::index_by_number(mesh_.nodes.size(),
                                              [&](const std::size_t i) {
                                                return mesh_.global_node[i];
                                              }),
                        cells = io::index_by_number(
                          mesh_.elements.size(), [&](const std::size_t i) {
                            return mesh_.global_element[i];
                          });
  io::restore_parts(folder, "solid", [&](io::StateReader &in) {
    read_header(in);
    in.take_records<NodeRecord<Real>>(
      nodes, [&](const std::size_t i, const NodeRecord<Real> &record) {
        for (unsigned int d = 0; d < 3; ++d)
        {
          nodes_.displacement_of(i)[d] = record.values[d];
          nodes_.velocity_of(i)[d] = record.values[3 + d];
          nodes_.force_of(i)[d] = record.values[6 + d];
          reactions[i][d] = record.reaction[d];
        }
        nodes_.force_of(i)[3] = record.values[9];
      });
    auto &batches = operator_.batches();
    const std::size_t bytes = CellRecord<Real>::size(batches.n_relaxed());
    const std::uint64_t n_cells = in.take_size(bytes);
    for (std::uint64_t i = 0; i < n_cells; ++i)
    {
      CellRecord<Real> record;
      in.take_bytes(&record, bytes);
      if (const auto found = cells.find(record.number); found != cells.end())
        for_each_state(
          batches, found->second, [&](const unsigned int k, Real &value) {
            value = record.values[k];
          });
    }
    in.take_records<DampingRecord<Real>>(
      cells, [&](const std::size_t i, const DampingRecord<Real> &record) {
        for_damping(batches, i, [&](auto *forces, const unsigned int lane) {
          for (unsigned int k = 0; k < 12; ++k)
            forces[k][lane] = record.values[k];
        });
      });
  });
  supports_.for_each_reaction([&](const std::uint32_t i,
                                  const unsigned int d,
                                  double &value) { value = reactions[i][d]; });
  slip_.restore(folder, communicator_);
  slip_.find_normals(nodes_, exchange_);
  loads_.set_time(time_);
  // History variables may differ from zero where nodes are at rest.
  nodes_.mark_active_blocks();
  operator_.batches().activate_all();
  operator_.find_least_dilatations();
  find_least_dilatations();
  snapshot_.reset();
}


template <typename Real>
void SolidBody<Real>::read_header(io::StateReader &in)
{
  CheckpointHeader header;
  in.take(header);
  if (header.n_global_nodes != mesh_.n_global_nodes ||
      header.n_global_elements != mesh_.n_global_elements ||
      header.n_tissues != mesh_.tissues.size() ||
      header.n_relaxed != operator_.batches().n_relaxed() ||
      header.number_size != sizeof(Real))
    in.refuse();
  time_ = header.time;
  time_of_relaxed_strain_ = header.relaxed_time;
  times_ = header.times;
  initial_energy_ = header.initial_energy;
  least_volume_ = header.least_volume;
  std::vector<TissueEnergies> losses(operator_.losses().size());
  for (TissueEnergies &one : losses)
    in.take(one);
  // Rank 0 continues the sums over all saved ranks.
  if (dealii::Utilities::MPI::this_mpi_process(communicator_) != 0)
    return;
  external_work_ += header.external_work;
  nodal_work_ += header.nodal_work;
  step_change_ += header.step_change;
  computed_updates_ += header.computed_updates;
  total_updates_ += header.total_updates;
  for (std::size_t i = 0; i < losses.size(); ++i)
  {
    operator_.losses()[i].bulk_viscosity += losses[i].bulk_viscosity;
    operator_.losses()[i].relaxation += losses[i].relaxation;
    operator_.losses()[i].hourglass_damping += losses[i].hourglass_damping;
    operator_.losses()[i].pressure_smoothing += losses[i].pressure_smoothing;
  }
}


template class SolidBody<double>;
template class SolidBody<float>;
} // namespace contrecoup::solid
