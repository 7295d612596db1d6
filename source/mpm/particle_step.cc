// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/exceptions.h>
#include <contrecoup/base/timers.h>
#include <contrecoup/mpm/particle_step.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int size = TileGrid::window_size;

  const std::vector<Parity> one_vector{1, 2, 4};

  /// Nodes with less mass than this part of the largest are left alone: forces
  /// and momenta there are as small.
  constexpr double least_mass = 1e-14;

  /// Divides vectors by masses; zero where there is none.
  void divide(const TileGrid &grid,
              const dealii::AlignedVector<double> &mass,
              const unsigned int first,
              NodeValues &values)
  {
    double largest = 0.;
    for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
      largest = std::max(largest, mass[n]);
    const double least = least_mass * largest;
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
        values[first + d][n] =
          mass[n] > least ? values[first + d][n] / mass[n] : 0.;
  }

  /// No motion through planes that reflect.
  void stop_at_planes(const TileGrid &grid,
                      const unsigned int first,
                      NodeValues &values)
  {
    for (unsigned int d = 0; d < 3; ++d)
      for (const std::uint32_t n : grid.plane_nodes()[d])
        values[first + d][n] = 0.;
  }
} // namespace


ParticleStep::ParticleStep(const TransferScheme &scheme,
                           const std::vector<ParticleMaterial> &materials,
                           const FieldContact &contact)
  : scheme_(scheme)
  , materials_(materials)
  , contact_(contact)
{
  if (scheme.transfer == Transfer::affine && scheme.degree == 1)
    throw InputError(
      "MPM/Transfer = apic needs MPM/Basis = quadratic or cubic");
  if (scheme.transfer == Transfer::pic || scheme.transfer == Transfer::affine)
    scheme_.series_order = 1;
  for (unsigned int m = 0; m < materials.size(); ++m)
  {
    if (materials[m].field >= fields_.size())
      fields_.resize(materials[m].field + 1);
    fields_[materials[m].field].materials.push_back(m);
  }
}


std::vector<ParticleStep::Tile> ParticleStep::tiles(const TileGrid &grid,
                                                    Particles &particles) const
{
  std::vector<Tile> result;
  auto source = grid.sources().begin();
  for (auto &tile : particles.tiles())
    result.emplace_back(&*source++, &tile.second);
  return result;
}


WindowPlace ParticleStep::place(const TileGrid &grid,
                                const TileGrid::Source &tile) const
{
  WindowPlace result;
  result.cell_size = grid.box().cell_size;
  for (unsigned int d = 0; d < 3; ++d)
    result.lower[d] = grid.box().lower[d] + result.cell_size * tile.origin[d];
  return result;
}


void ParticleStep::start(const TileGrid &grid, Particles &particles) const
{
  strain(grid, particles, 0.);
}


void ParticleStep::deposit_fields(const TileGrid &grid,
                                  Particles &particles,
                                  const Deposit what)
{
  const TimerScope timer("particles to grid");
  const unsigned int first = what == Deposit::force ? 4 : 0;
  const unsigned int n = what == Deposit::momentum_force ? 7
                         : what == Deposit::momentum     ? 4
                                                         : 3;
  std::vector<Parity> parities{0, 1, 2, 4, 1, 2, 4};
  parities = {parities.begin() + first, parities.begin() + first + n};
  Window window(n * size);
  for (Field &field : fields_)
  {
    if (what != Deposit::force)
      field.matter.clear(grid);
    for (const Tile &tile : tiles(grid, particles))
    {
      window.fill(0.);
      for (const unsigned int m : field.materials)
        deposit(scheme_.degree,
                what,
                scheme_.transfer == Transfer::affine,
                (*tile.second)[m],
                place(grid, *tile.first),
                window.data());
      add_window(*tile.first, window.data(), first, parities, field.matter);
    }
    field.matter.add_copies(grid);
  }
}


void ParticleStep::smooth(const TileGrid &grid,
                          Particles &particles,
                          const bool is_pressure) const
{
  Window window(2 * size);
  std::vector<double> weight, value;
  for (unsigned int m = 0; m < materials_.size(); ++m)
  {
    if (!materials_[m].is_smoothed)
      continue;
    NodeValues sums(2);
    sums.clear(grid);
    for (const Tile &tile : tiles(grid, particles))
    {
      const ParticleBlock &block = (*tile.second)[m];
      weight.resize(block.size());
      value.resize(block.size());
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        weight[p] =
          block[column::volume][p] * (1. + block[column::dilatation][p]);
        value[p] = is_pressure
                     ? block[column::pressure][p]
                     : block[column::rate][p] + block[column::rate + 4][p] +
                         block[column::rate + 8][p];
      }
      window.fill(0.);
      deposit_scalar(block,
                     weight.data(),
                     value.data(),
                     place(grid, *tile.first),
                     window.data());
      add_window(*tile.first, window.data(), 0, {0, 0}, sums);
    }
    sums.add_copies(grid);
    for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
      sums[1][n] = sums[0][n] > 0. ? sums[1][n] / sums[0][n] : 0.;
    sums.update_copies(grid);
    for (const Tile &tile : tiles(grid, particles))
    {
      ParticleBlock &block = (*tile.second)[m];
      read_window(*tile.first, sums, 1, {0}, window.data());
      collect_scalar(window.data(),
                     place(grid, *tile.first),
                     block,
                     block[column::smoothed]);
    }
  }
}


void ParticleStep::multiply_mass_matrix(const TileGrid &grid,
                                        Particles &particles,
                                        const Field &field,
                                        NodeValues &from,
                                        NodeValues &to) const
{
  from.update_copies(grid);
  to.clear(grid);
  Window in(3 * size), out(3 * size);
  for (const Tile &tile : tiles(grid, particles))
  {
    read_window(*tile.first, from, 0, one_vector, in.data());
    out.fill(0.);
    for (const unsigned int m : field.materials)
      multiply_mass(scheme_.degree,
                    1,
                    (*tile.second)[m],
                    place(grid, *tile.first),
                    in.data(),
                    out.data());
    add_window(*tile.first, out.data(), 0, one_vector, to);
  }
  to.add_copies(grid);
}


void ParticleStep::apply_series(const TileGrid &grid,
                                Particles &particles,
                                Field &field,
                                NodeValues &values) const
{
  const TimerScope timer("mass series");
  NodeValues rest(3), product(3);
  rest.clear(grid);
  for (unsigned int d = 0; d < 3; ++d)
    std::copy_n(values[d].begin(), grid.n_own_nodes(), rest[d].begin());
  for (unsigned int j = 1; j < scheme_.series_order; ++j)
  {
    multiply_mass_matrix(grid, particles, field, rest, product);
    divide(grid, field.matter[0], 0, product);
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
        rest[d][n] -= product[d][n];
    stop_at_planes(grid, 0, rest);
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
        values[d][n] += rest[d][n];
  }
}


void ParticleStep::find_velocities(const TileGrid &grid, Particles &particles)
{
  std::vector<const dealii::AlignedVector<double> *> masses;
  for (const Field &field : fields_)
    masses.push_back(&field.matter[0]);
  contact_.find_interfaces(grid, particles, masses);
  for (Field &field : fields_)
  {
    field.before.clear(grid);
    for (unsigned int d = 0; d < 3; ++d)
      std::copy_n(field.matter[1 + d].begin(),
                  grid.n_own_nodes(),
                  field.before[d].begin());
    divide(grid, field.matter[0], 0, field.before);
    stop_at_planes(grid, 0, field.before);
    apply_series(grid, particles, field, field.before);
  }
}


void ParticleStep::touch(const TileGrid &grid)
{
  if (contact_.n_fields() < 2)
    return;
  std::vector<NodeValues *> velocities;
  for (Field &field : fields_)
    velocities.push_back(&field.motion);
  contact_.apply(velocities, 3, grid.n_own_nodes());
}


void ParticleStep::use_velocities_before(const TileGrid &grid)
{
  for (Field &field : fields_)
  {
    field.motion.clear(grid);
    for (unsigned int d = 0; d < 3; ++d)
      std::copy_n(field.before[d].begin(),
                  grid.n_own_nodes(),
                  field.motion[3 + d].begin());
  }
  touch(grid);
  for (Field &field : fields_)
    field.motion.update_copies(grid);
}


void ParticleStep::accelerate(const TileGrid &grid, Particles &particles)
{
  for (Field &field : fields_)
  {
    field.motion.clear(grid);
    field.acceleration.clear(grid);
    for (unsigned int d = 0; d < 3; ++d)
      std::copy_n(field.matter[4 + d].begin(),
                  grid.n_own_nodes(),
                  field.acceleration[d].begin());
    divide(grid, field.matter[0], 0, field.acceleration);
    stop_at_planes(grid, 0, field.acceleration);
    apply_series(grid, particles, field, field.acceleration);
  }
}


void ParticleStep::set_motion(const TileGrid &grid, const double step)
{
  for (Field &field : fields_)
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
        field.motion[3 + d][n] =
          field.before[d][n] + step * field.acceleration[d][n];
  touch(grid);
  step_contact_loss_ = 0.;
  for (Field &field : fields_)
  {
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
      {
        const double before = field.before[d][n],
                     after = field.motion[3 + d][n];
        const double change = (after - before) / step,
                     mean = 0.5 * (before + after);
        field.motion[d][n] = change;
        field.motion[6 + d][n] = mean;
        step_contact_loss_ -= step * field.matter[0][n] *
                              (change - field.acceleration[d][n]) * mean;
      }
    field.motion.update_copies(grid);
  }
}


void ParticleStep::collect(const TileGrid &grid,
                           Particles &particles,
                           const double step)
{
  const TimerScope timer("grid to particles");
  Window window(9 * size);
  const std::vector<Parity> parities{1, 2, 4, 1, 2, 4, 1, 2, 4};
  for (const Field &field : fields_)
    for (const Tile &tile : tiles(grid, particles))
    {
      read_window(*tile.first, field.motion, 0, parities, window.data());
      for (const unsigned int m : field.materials)
      {
        ParticleBlock &block = (*tile.second)[m];
        const WindowPlace where = place(grid, *tile.first);
        collect_motion(scheme_.degree, step, window.data(), where, block);
        if (scheme_.transfer == Transfer::affine)
          collect_affine(
            scheme_.degree, window.data() + 3 * size, where, block);
      }
    }
}


double ParticleStep::largest_strain_rate(const Particles &particles,
                                         const MPI_Comm communicator) const
{
  double largest = 0.;
  particles.for_each_block([&](unsigned int, const ParticleBlock &block) {
    for (unsigned int k = 0; k < 9; ++k)
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        const double rate = std::abs(block[column::mean_rate + k][p]);
        // A comparison that NaN fails.
        if (!(rate <= largest))
          largest = std::isfinite(rate)
                      ? rate
                      : std::numeric_limits<double>::infinity();
      }
  });
  return dealii::Utilities::MPI::max(largest, communicator);
}


void ParticleStep::move_particles(const TileGrid &grid,
                                  Particles &particles,
                                  const double step)
{
  double work = 0., kinetic = 0.;
  const bool keeps = scheme_.transfer == Transfer::flip;
  particles.for_each_block([&](const unsigned int m, ParticleBlock &block) {
    for (std::size_t p = 0; p < block.size(); ++p)
    {
      const double mass = block[column::mass][p];
      for (unsigned int d = 0; d < 3; ++d)
      {
        const double change = block[column::change + d][p],
                     way = block[column::way + d][p];
        double &velocity = block[column::velocity + d][p];
        const double after = keeps ? velocity + change : way / step;
        work += block[column::force + d][p] * (way - 0.5 * step * change);
        kinetic += 0.5 * mass * (after - velocity) * (after + velocity);
        velocity = after;
      }
      constexpr unsigned int entry[9] = {0, 3, 5, 3, 1, 4, 5, 4, 2};
      double power = 0.;
      for (unsigned int k = 0; k < 9; ++k)
        power +=
          block[column::stress + entry[k]][p] * block[column::mean_rate + k][p];
      if (materials_[m].is_smoothed)
        power -=
          (1. + block[column::dilatation][p]) * block[column::smoothed][p] *
          (block[column::mean_rate][p] + block[column::mean_rate + 4][p] +
           block[column::mean_rate + 8][p]);
      block[column::energy][p] += step * block[column::volume][p] * power;
    }
  });
  double gained = 0.;
  for (const Field &field : fields_)
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_own_nodes(); ++n)
        gained += step * field.matter[4 + d][n] * field.motion[6 + d][n];
  ledger_.external_work += work;
  ledger_.contact_loss += step_contact_loss_;
  ledger_.transfer_loss += gained - step_contact_loss_ - kinetic;
}


void ParticleStep::collect_rates(const TileGrid &grid,
                                 Particles &particles) const
{
  const TimerScope timer("velocity gradients");
  Window window(3 * size);
  for (const Field &field : fields_)
    for (const Tile &tile : tiles(grid, particles))
    {
      read_window(*tile.first, field.motion, 3, one_vector, window.data());
      for (const unsigned int m : field.materials)
        collect_rate(scheme_.degree,
                     window.data(),
                     place(grid, *tile.first),
                     (*tile.second)[m]);
    }
}


void ParticleStep::strain(const TileGrid &grid,
                          Particles &particles,
                          const double step) const
{
  const TimerScope timer("strains and stresses");
  if (step > 0.)
    smooth(grid, particles, false);
  particles.for_each_block([&](const unsigned int m, ParticleBlock &block) {
    strain_particles(materials_[m], step, grid.box().cell_size, block);
  });
  smooth(grid, particles, true);
}


void ParticleStep::give_up(const Particles &particles,
                           const double step,
                           const MPI_Comm communicator) const
{
  namespace mpi = dealii::Utilities::MPI;
  const double largest = largest_strain_rate(particles, communicator);
  std::string place;
  particles.for_each_block(
    [&](const unsigned int m, const ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size() && place.empty(); ++p)
        for (unsigned int k = 0; k < 9; ++k)
          if (!(std::abs(block[column::mean_rate + k][p]) < largest))
          {
            place = "a particle of " + materials_[m].name + " at (" +
                    std::to_string(block[column::position][p]) + ", " +
                    std::to_string(block[column::position + 1][p]) + ", " +
                    std::to_string(block[column::position + 2][p]) +
                    ") m with density " +
                    std::to_string(materials_[m].density() /
                                   (1. + block[column::dilatation][p])) +
                    " kg/m^3";
            break;
          }
    });
  const auto all = mpi::all_gather(communicator, place);
  const auto found = std::find_if(
    all.begin(), all.end(), [](const auto &one) { return !one.empty(); });
  throw NumericsError(
    (found == all.end() ? std::string("a particle") : *found) +
    " would be strained by more than " + std::to_string(largest_strain) +
    " in a step, even in one of " + std::to_string(step) + " s");
}


double ParticleStep::advance(TileGrid &grid,
                             Particles &particles,
                             const double largest,
                             const unsigned int n_retries,
                             const OuterForces &forces)
{
  double step = largest;
  n_retries_ = 0;
  particles.for_each_block(forces);
  if (scheme_.update == StressUpdate::first)
  {
    deposit_fields(grid, particles, Deposit::momentum);
    find_velocities(grid, particles);
    use_velocities_before(grid);
    collect_rates(grid, particles);
    strain(grid, particles, step);
    deposit_fields(grid, particles, Deposit::force);
  }
  else
  {
    deposit_fields(grid, particles, Deposit::momentum_force);
    find_velocities(grid, particles);
  }
  accelerate(grid, particles);
  while (true)
  {
    set_motion(grid, step);
    collect(grid, particles, step);
    if (step * largest_strain_rate(particles, grid.communicator()) <
        largest_strain)
      break;
    if (n_retries_ == n_retries)
      give_up(particles, step, grid.communicator());
    step *= 0.5;
    ++n_retries_;
  }
  move_particles(grid, particles, step);
  if (scheme_.update == StressUpdate::modified_last)
  {
    deposit_fields(grid, particles, Deposit::momentum);
    find_velocities(grid, particles);
    use_velocities_before(grid);
  }
  if (scheme_.update != StressUpdate::first)
  {
    collect_rates(grid, particles);
    strain(grid, particles, step);
  }
  particles.for_each_block([](unsigned int, ParticleBlock &block) {
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t p = 0; p < block.size(); ++p)
        block[column::position + d][p] += block[column::way + d][p];
  });
  particles.sort(grid);
  return step;
}


ParticleTotals ParticleStep::totals(const TileGrid &grid,
                                    const Particles &particles) const
{
  std::vector<double> sums(7, 0.);
  particles.for_each_block(
    [&](const unsigned int m, const ParticleBlock &block) {
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        const double mass = block[column::mass][p];
        sums[0] += mass;
        for (unsigned int d = 0; d < 3; ++d)
        {
          const double velocity = block[column::velocity + d][p];
          sums[1 + d] += mass * velocity;
          sums[4] += 0.5 * mass * velocity * velocity;
        }
        sums[5] += block[column::energy][p];
      }
      sums[6] += mpm::stored_energy(materials_[m], block);
    });
  dealii::Utilities::MPI::sum(sums, grid.communicator(), sums);
  return {sums[0], {{sums[1], sums[2], sums[3]}}, sums[4], sums[5], sums[6]};
}


double ParticleStep::signal_time(const TileGrid &grid,
                                 const Particles &particles) const
{
  double speed = 0.;
  particles.for_each_block(
    [&](const unsigned int m, const ParticleBlock &block) {
      double fastest = 0.;
      for (std::size_t p = 0; p < block.size(); ++p)
      {
        double square = 0.;
        for (unsigned int d = 0; d < 3; ++d)
          square += std::pow(block[column::velocity + d][p], 2);
        fastest = std::max(fastest, square);
      }
      speed = std::max(
        speed, std::sqrt(fastest) + largest_sound_speed(materials_[m], block));
    });
  speed = dealii::Utilities::MPI::max(speed, grid.communicator());
  return grid.box().cell_size / std::max(speed, 1e-300);
}
} // namespace contrecoup::mpm
