// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/record/head_measures.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
namespace
{
  namespace mpi = dealii::Utilities::MPI;

  dealii::Tensor<1, 3> mean_over(const std::array<std::uint32_t, 8> &cell,
                                 const dealii::AlignedVector<double> &field)
  {
    dealii::Tensor<1, 3> result;
    for (const std::uint32_t node : cell)
      for (unsigned int d = 0; d < 3; ++d)
        result[d] += 0.125 * field[node_width * node + d];
    return result;
  }
} // namespace


void HeadMeasures::reinit(const AleSnapshot &now)
{
  const HexSpace &space = now.space;
  cells_.clear();
  heights_.clear();
  record_.samples.clear();
  std::vector<solid::NodalAverage::Corners> corners;
  std::vector<double> volumes;
  double volume = 0., moment = 0.;
  for (std::uint32_t c = 0; c < space.n_locally_owned_cells(); ++c)
    if (space.region(c) == brain_)
    {
      cells_.push_back(c);
      solid::BrainSample sample;
      sample.cell = space.cell_number(c);
      sample.volume = now.lagrange.values(now.state, c).volume;
      record_.samples.push_back(sample);
      corners.push_back(space.cell(c));
      volumes.push_back(sample.volume);
      heights_.push_back(height(mean_over(space.cell(c), now.state.position)));
      volume += sample.volume;
      moment += sample.volume * heights_.back();
    }
  volume = mpi::sum(volume, space.communicator());
  moment = mpi::sum(moment, space.communicator());
  for (double &one : heights_)
    one -= moment / volume;
  solid::NodalAverage::AddRanks add_ranks;
  if (mpi::n_mpi_processes(space.communicator()) > 1)
  {
    FieldExchange exchange;
    exchange.reinit(space.nodes(), 1);
    add_ranks = [exchange](dealii::AlignedVector<double> &values) {
      exchange.compress_add(values);
      exchange.update_ghost_values(values);
    };
  }
  average_.reinit(std::move(corners),
                  std::move(volumes),
                  space.n_nodes(),
                  std::move(add_ranks));
}


void HeadMeasures::record(const AleSnapshot &now)
{
  if (!is_due())
    return;
  follow_brain(now.lagrange, now.state);
  follow_motion(now.space, now.state);
}


void HeadMeasures::follow_brain(const LagrangeStep &lagrange,
                                const AleState &state)
{
  std::vector<double> pressures;
  for (std::size_t i = 0; i < record_.samples.size(); ++i)
  {
    const CellValues values = lagrange.values(state, cells_[i]);
    record_.samples[i].record_strain(values.principal_strain);
    pressures.push_back(values.pressure);
  }
  record_brain(state.time,
               pressures,
               average_.average(pressures),
               heights_,
               record_.samples);
}


void HeadMeasures::follow_motion(const HexSpace &space, const AleState &state)
{
  // Each cell is a point mass at its centre.
  solid::MeanMotion moving, head;
  for (std::size_t c = 0; c < space.n_locally_owned_cells(); ++c)
  {
    const unsigned int region = space.region(c);
    if (!is_of_head(region))
      continue;
    const auto place = mean_over(space.cell(c), state.position),
               velocity = mean_over(space.cell(c), state.velocity);
    head.add(state.mass[c], place, velocity);
    if (region == moving_region())
      moving.add(state.mass[c], place, velocity);
  }
  record_motion(state.time, space.communicator(), moving, head);
}
} // namespace contrecoup::ale
