// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/lagrange_step.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/base/system/coordinates.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/gather.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  /// Broadcasts the text of the lowest rank with @p is_owner.
  std::string text_of_owner(const MPI_Comm communicator,
                            const bool is_owner,
                            const std::string &text)
  {
    const int rank = dealii::Utilities::MPI::this_mpi_process(communicator),
              n = dealii::Utilities::MPI::n_mpi_processes(communicator);
    const int owner =
      dealii::Utilities::MPI::min(is_owner ? rank : n, communicator);
    return owner == n ? text : broadcast_text(communicator, text, owner);
  }
} // namespace


double LagrangeStep::external_work() const
{
  return dealii::Utilities::MPI::sum(work_, space_->communicator());
}


void LagrangeStep::set_external_work(const double work)
{
  // The first rank continues the sum; on one rank, bitwise.
  const auto rank =
    dealii::Utilities::MPI::this_mpi_process(space_->communicator());
  work_ = rank == 0 ? work : 0.;
}


double LagrangeStep::slip_work() const
{
  return dealii::Utilities::MPI::sum(slip_work_, space_->communicator());
}


void LagrangeStep::set_slip_work(const double work)
{
  const auto rank =
    dealii::Utilities::MPI::this_mpi_process(space_->communicator());
  slip_work_ = rank == 0 ? work : 0.;
}


ContactMeasures LagrangeStep::contact() const
{
  std::vector<double> sums{contact_.force,
                           contact_.area,
                           contact_.work,
                           contact_.friction_work,
                           contact_.sliding_work};
  dealii::Utilities::MPI::sum(sums, space_->communicator(), sums);
  return {sums[0], sums[1], sums[2], sums[3], sums[4]};
}


void LagrangeStep::set_contact(const ContactMeasures &contact)
{
  const auto rank =
    dealii::Utilities::MPI::this_mpi_process(space_->communicator());
  contact_ = rank == 0 ? contact : ContactMeasures();
}


AleTotals LagrangeStep::totals(const AleState &state) const
{
  std::vector<double> sums(6, 0.);
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
  {
    sums[0] += state.mass[c];
    sums[1] += state.energy[c];
  }
  for (std::size_t n = 0; n < space_->n_locally_owned_nodes(); ++n)
  {
    const double *v = &state.velocity[node_width * n];
    const double mass = 1. / v[3];
    sums[2] += 0.5 * mass * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (unsigned int d = 0; d < 3; ++d)
      sums[3 + d] += mass * v[d];
  }
  dealii::Utilities::MPI::sum(sums, space_->communicator(), sums);
  AleTotals result;
  result.mass = sums[0];
  result.internal_energy = sums[1];
  result.kinetic_energy = sums[2];
  for (unsigned int d = 0; d < 3; ++d)
    result.momentum[d] = sums[3 + d];
  return result;
}


void LagrangeStep::throw_step_failure(const AleState &state,
                                      const double step) const
{
  // Find the cell with the smallest volume on all ranks.
  double least = std::numeric_limits<double>::max();
  std::size_t worst = 0;
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
  {
    const double volume =
      hex_moments(corners_of(space_->cell(c), state.position)).volume;
    if (!(volume >= least))
    {
      least = volume;
      worst = c;
    }
  }
  const double all = dealii::Utilities::MPI::min(least, space_->communicator());
  std::string text = "the mesh tangles";
  const bool is_here = least == all && space_->n_locally_owned_cells() > 0;
  if (is_here)
  {
    const auto x = corners_of(space_->cell(worst), state.position)[0];
    text = "cell " + std::to_string(space_->cell_number(worst)) + " of " +
           forces_.region_name(worst) + " near (" +
           coordinates(dealii::Point<3>(x[0], x[1], x[2])) +
           ") m would have a volume of " + brief(least) +
           " m^3 and an energy of " + brief(state.energy[worst]) + " J";
  }
  text = text_of_owner(space_->communicator(), is_here, text);
  const std::string coupling = coupling_.failure_text();
  throw NumericsError("time " + exact(state.time) + " s: with a step of " +
                      brief(step) + " s " +
                      (coupling_.has_diverged() ? coupling : text + coupling));
}


void LagrangeStep::give_up_signals(const AleState &state,
                                   const double step) const
{
  double fastest = 0.;
  std::size_t worst = 0;
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
  {
    const double rate = forces_.signal_rate(state, c);
    if (!(rate <= fastest))
    {
      fastest = std::isnan(rate) ? std::numeric_limits<double>::max() : rate;
      worst = c;
    }
  }
  const MPI_Comm all = space_->communicator();
  const bool is_here = fastest == dealii::Utilities::MPI::max(fastest, all) &&
                       space_->n_locally_owned_cells() > 0;
  std::string text = "no cell";
  if (is_here)
  {
    const CellValues values = forces_.values(state, worst);
    const auto x = corners_of(space_->cell(worst), state.position)[0];
    double square = 0.;
    for (const auto &v : corners_of(space_->cell(worst), state.velocity))
      square = std::max(square, dot(v, v));
    text = "cell " + std::to_string(space_->cell_number(worst)) + " of " +
           forces_.region_name(worst) + " near (" +
           coordinates(dealii::Point<3>(x[0], x[1], x[2])) + ") m, of " +
           brief(values.volume) + " m^3, " +
           brief(values.mass / values.volume) + " kg/m^3, " +
           brief(values.pressure) + " Pa, corners at up to " +
           brief(std::sqrt(square)) + " m/s";
  }
  throw NumericsError(
    "time " + exact(state.time) + " s: a step of " + brief(step) +
    " s, the largest that the CFL limit "
    "allows in " +
    text_of_owner(all, is_here, text) + ", is too short to go on");
}
} // namespace contrecoup::ale
