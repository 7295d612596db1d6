// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/record/probe_cells.h>
#include <contrecoup/base/system/log.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <limits>
#include <map>

namespace contrecoup::ale
{
namespace
{
  /// Distance of a place from the centre of the cell that it is in [m]; of
  /// other cells more than any distance, the more the farther outside it is, in
  /// lengths of the cell.
  double remoteness(const HexSpace::Cell &cell,
                    const dealii::AlignedVector<double> &position,
                    const dealii::Point<3> &place)
  {
    constexpr double beyond = 1e6, near = 3., round_off = 1e-6;
    constexpr unsigned int n_steps = 5;
    double outside = 0., distance = 0.;
    dealii::Tensor<1, 3> local; // from -1 to 1 in the cell
    // Newton's method, from the centre on; cells far away need no more than
    // that.
    for (unsigned int step = 0; step <= n_steps && outside < near; ++step)
    {
      dealii::Point<3> there;
      dealii::Tensor<2, 3> jacobian;
      for (unsigned int k = 0; k < 8; ++k)
      {
        const double sign[] = {k % 4 == 1 || k % 4 == 2 ? 1. : -1.,
                               k % 4 > 1 ? 1. : -1.,
                               k > 3 ? 1. : -1.};
        double shape[3];
        for (unsigned int e = 0; e < 3; ++e)
          shape[e] = 0.5 * (1. + sign[e] * local[e]);
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double x = position[node_width * cell[k] + d];
          there[d] += shape[0] * shape[1] * shape[2] * x;
          for (unsigned int e = 0; e < 3; ++e)
            jacobian[d][e] +=
              0.5 * sign[e] * shape[(e + 1) % 3] * shape[(e + 2) % 3] * x;
        }
      }
      if (step == 0)
        distance = there.distance(place);
      local += dealii::invert(jacobian) * (place - there);
      outside = 0.;
      for (unsigned int e = 0; e < 3; ++e)
        outside = std::max(outside, std::abs(local[e]));
    }
    // A flat cell has no local coordinates.
    if (!std::isfinite(local.norm()))
      return beyond * distance;
    return outside <= 1. + round_off ? distance : beyond * outside;
  }
} // namespace


void ProbeCells::reinit(const AleSnapshot &now)
{
  const std::vector<dealii::Point<3>> &probes = now.impact.probes;
  cells_.assign(probes.size(), HexSpace::no_cell);
  std::map<unsigned int, std::size_t> probe_in;
  for (std::size_t i = 0; i < probes.size(); ++i)
  {
    double nearest = std::numeric_limits<double>::max();
    std::uint32_t cell = HexSpace::no_cell;
    for (std::uint32_t c = 0; c < now.space.n_locally_owned_cells(); ++c)
    {
      const double distance =
        remoteness(now.space.cell(c), now.state.position, probes[i]);
      if (distance < nearest * (1. - 1e-12))
      {
        nearest = distance;
        cell = c;
      }
    }
    // Among equally near cells, the smallest cell number counts.
    const double all = dealii::Utilities::MPI::min(nearest, now.communicator);
    const bool is_here = nearest <= all * (1. + 1e-12);
    const unsigned int number =
      is_here ? now.space.cell_number(cell) : HexSpace::no_cell;
    const auto chosen = dealii::Utilities::MPI::min(number, now.communicator);
    if (chosen == number && is_here)
      cells_[i] = cell;
    if (const auto other = probe_in.emplace(chosen, i); !other.second)
      log_line("WARNING: Probes/Points: probes " +
               std::to_string(other.first->second + 1) + " and " +
               std::to_string(i + 1) + " are in one cell and have one record");
  }
}


std::vector<NamedValue> ProbeCells::values(const AleSnapshot &now) const
{
  std::vector<NamedValue> values;
  for (std::size_t i = 0; i < cells_.size(); ++i)
  {
    std::vector<double> found(2, 0.);
    if (cells_[i] != HexSpace::no_cell)
    {
      const auto element = now.lagrange.values(now.state, cells_[i]);
      found = {element.pressure, element.mass / element.volume};
    }
    dealii::Utilities::MPI::sum(found, now.communicator, found);
    const std::string name = "_" + std::to_string(i + 1);
    values.push_back({"pressure" + name, "Pa", found[0]});
    values.push_back({"density" + name, "kg/m^3", found[1]});
  }
  return values;
}
} // namespace contrecoup::ale
