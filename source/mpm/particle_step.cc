// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/mpm/particle_motion.h>
#include <contrecoup/mpm/particle_step.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace contrecoup::mpm
{
namespace
{
  constexpr unsigned int size = window_stride;

  const std::vector<Parity> one_vector{vector_x, vector_y, vector_z};

  /// Nodes with less than this fraction of the largest mass have no velocity.
  constexpr double least_mass = 1e-60;

  /// Nodes with less than this fraction of the largest mass are not
  /// accelerated. With linear splines the forces on such nodes do not vanish
  /// with their mass. With other splines they are as small as the square root
  /// of the mass; leaving them out would be noticeable.
  double least_accelerated_mass(const unsigned int degree)
  {
    return degree == 1 ? 1e-14 : least_mass;
  }

  /// Divides nodal vectors by masses; the result is zero where the mass is less
  /// than a fraction of the largest.
  void divide(const TileGrid &grid,
              const double smallest_fraction,
              const dealii::AlignedVector<double> &mass,
              const unsigned int first,
              NodeValues &values)
  {
    double largest = 0.;
    for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
      largest = std::max(largest, mass[n]);
    const double least = smallest_fraction * largest;
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
        values[first + d][n] =
          mass[n] > least ? values[first + d][n] / mass[n] : 0.;
  }

  /// Sets the normal velocity at reflecting sides to zero, and all components
  /// at no-slip sides.
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


std::vector<ParticleStep::Tile>
ParticleStep::tiles(const std::vector<TileGrid::Source> &sources,
                    Particles &particles,
                    const std::vector<unsigned int> &materials) const
{
  std::vector<Tile> result;
  auto source = sources.begin();
  for (auto &tile : particles.tiles())
  {
    if (std::any_of(
          materials.begin(), materials.end(), [&](const unsigned int m) {
            return tile.second[m].size() > 0;
          }))
      result.emplace_back(&*source, &tile.second);
    ++source;
  }
  return result;
}


void ParticleStep::start(const TileGrid &grid, Particles &particles) const
{
  strain(grid, particles, 0.);
  resume(grid, particles);
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
  std::vector<Parity> parities{
    0, vector_x, vector_y, vector_z, vector_x, vector_y, vector_z};
  parities = {parities.begin() + first, parities.begin() + first + n};
  Window window(n * size);
  for (Field &field : fields_)
  {
    if (what != Deposit::force)
      field.matter.clear(grid);
    for (const Tile &tile : tiles(grid.sources(), particles, field.materials))
    {
      window.fill(0.);
      for (const unsigned int m : field.materials)
        deposit(scheme_.degree,
                what,
                scheme_.transfer == Transfer::affine,
                (*tile.second)[m],
                window_geometry(grid, *tile.first),
                window.data());
      add_window(*tile.first, window.data(), first, parities, field.matter);
    }
  }
  // After all fields, so that ranks wait for each other only once.
  for (Field &field : fields_)
    field.matter.compress_add(grid);
}


void ParticleStep::multiply_mass_matrix(const TileGrid &grid,
                                        Particles &particles,
                                        std::vector<NodeValues> &from,
                                        std::vector<NodeValues> &to) const
{
  for (NodeValues &values : from)
    values.update_ghost_values(grid);
  Window in(3 * size), out(3 * size);
  for (unsigned int f = 0; f < fields_.size(); ++f)
  {
    to[f].clear(grid);
    for (const Tile &tile :
         tiles(grid.sources(), particles, fields_[f].materials))
    {
      read_window(*tile.first, from[f], 0, one_vector, in.data());
      out.fill(0.);
      for (const unsigned int m : fields_[f].materials)
        multiply_mass(scheme_.degree,
                      1,
                      (*tile.second)[m],
                      window_geometry(grid, *tile.first),
                      in.data(),
                      out.data());
      add_window(*tile.first, out.data(), 0, one_vector, to[f]);
    }
  }
  for (NodeValues &values : to)
    values.compress_add(grid);
}


void ParticleStep::apply_series(const TileGrid &grid,
                                Particles &particles,
                                const double smallest_fraction,
                                NodeValues Field::*const vector)
{
  if (scheme_.series_order == 1)
    return;
  const TimerScope timer("mass series");
  std::vector<NodeValues> rest, product(fields_.size(), NodeValues(3));
  for (const Field &field : fields_)
    rest.push_back(field.*vector);
  for (unsigned int j = 1; j < scheme_.series_order; ++j)
  {
    multiply_mass_matrix(grid, particles, rest, product);
    for (unsigned int f = 0; f < fields_.size(); ++f)
    {
      divide(grid, smallest_fraction, fields_[f].matter[0], 0, product[f]);
      for (unsigned int d = 0; d < 3; ++d)
        for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
          rest[f][d][n] -= product[f][d][n];
      stop_at_planes(grid, 0, rest[f]);
      for (unsigned int d = 0; d < 3; ++d)
        for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
          (fields_[f].*vector)[d][n] += rest[f][d][n];
    }
  }
}


void ParticleStep::find_interfaces(const TileGrid &grid, Particles &particles)
{
  if (contact_.n_fields() < 2)
    return;
  const TimerScope timer("interfaces");
  std::vector<const dealii::AlignedVector<double> *> masses;
  for (const Field &field : fields_)
    masses.push_back(&field.matter[0]);
  contact_.find_interfaces(grid, particles, masses);
}


void ParticleStep::find_velocities(const TileGrid &grid, Particles &particles)
{
  for (Field &field : fields_)
  {
    field.before.clear(grid);
    for (unsigned int d = 0; d < 3; ++d)
      std::copy_n(field.matter[1 + d].begin(),
                  grid.n_locally_owned_nodes(),
                  field.before[d].begin());
    divide(grid, least_mass, field.matter[0], 0, field.before);
    stop_at_planes(grid, 0, field.before);
  }
  apply_series(grid, particles, least_mass, &Field::before);
}


double ParticleStep::apply_contact(const TileGrid &grid)
{
  if (contact_.n_fields() < 2)
    return 0.;
  std::vector<NodeValues *> velocities;
  for (Field &field : fields_)
    velocities.push_back(&field.motion);
  return contact_.apply(velocities, 3, grid.n_locally_owned_nodes());
}


void ParticleStep::reset_to_velocities_before(const TileGrid &grid)
{
  for (Field &field : fields_)
  {
    field.motion.clear(grid);
    for (unsigned int d = 0; d < 3; ++d)
      std::copy_n(field.before[d].begin(),
                  grid.n_locally_owned_nodes(),
                  field.motion[3 + d].begin());
  }
  apply_contact(grid);
  for (Field &field : fields_)
    field.motion.update_ghost_values(grid);
}


void ParticleStep::accelerate(const TileGrid &grid, Particles &particles)
{
  const double smallest_fraction = least_accelerated_mass(scheme_.degree);
  for (Field &field : fields_)
  {
    field.motion.clear(grid);
    field.acceleration.clear(grid);
    for (unsigned int d = 0; d < 3; ++d)
      std::copy_n(field.matter[4 + d].begin(),
                  grid.n_locally_owned_nodes(),
                  field.acceleration[d].begin());
    divide(grid, smallest_fraction, field.matter[0], 0, field.acceleration);
    stop_at_planes(grid, 0, field.acceleration);
  }
  apply_series(grid, particles, smallest_fraction, &Field::acceleration);
}


void ParticleStep::set_motion(const TileGrid &grid, const double step)
{
  for (Field &field : fields_)
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
        field.motion[3 + d][n] =
          field.before[d][n] + step * field.acceleration[d][n];
  field_force_ = apply_contact(grid) / step;
  const bool has_contact = contact_.n_fields() > 1;
  step_contact_loss_ = 0.;
  for (Field &field : fields_)
  {
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
      {
        const double before = field.before[d][n],
                     after = field.motion[3 + d][n];
        const double change = (after - before) / step;
        field.motion[d][n] = change;
        if (has_contact)
          step_contact_loss_ -= 0.5 * step * field.matter[0][n] *
                                (change - field.acceleration[d][n]) *
                                (before + after);
      }
  }
  for (Field &field : fields_)
    field.motion.update_ghost_values(grid);
}


void ParticleStep::collect(const TileGrid &grid,
                           Particles &particles,
                           const double step)
{
  const TimerScope timer("grid to particles");
  Window window(6 * size);
  const std::vector<Parity> parities{
    vector_x, vector_y, vector_z, vector_x, vector_y, vector_z};
  for (const Field &field : fields_)
    for (const Tile &tile : tiles(grid.sources(), particles, field.materials))
    {
      read_window(*tile.first, field.motion, 0, parities, window.data());
      const WindowGeometry where = window_geometry(grid, *tile.first);
      if (scheme_.transfer == Transfer::affine)
        for (const unsigned int m : field.materials)
          collect_affine(
            scheme_.degree, window.data() + 3 * size, where, (*tile.second)[m]);
      // From here on the window holds the mean velocity.
      for (unsigned int i = 0; i < 3 * size; ++i)
        window[3 * size + i] -= 0.5 * step * window[i];
      for (const unsigned int m : field.materials)
        collect_motion(
          scheme_.degree, step, window.data(), where, (*tile.second)[m]);
    }
}


void ParticleStep::move_particles(const TileGrid &grid,
                                  Particles &particles,
                                  const double step)
{
  double kinetic = 0.;
  const double grid_velocity_fraction = scheme_.grid_velocity_fraction(step);
  particles.for_each_block([&](const unsigned int m, ParticleBlock &block) {
    const EnergyGains gains = update_velocities(
      step, grid_velocity_fraction, materials_[m].is_smoothed, block);
    ledger_.external_work += gains.work;
    kinetic += gains.kinetic;
  });
  double gained = 0.;
  for (const Field &field : fields_)
    for (unsigned int d = 0; d < 3; ++d)
      for (std::size_t n = 0; n < grid.n_locally_owned_nodes(); ++n)
        gained += step * field.matter[4 + d][n] *
                  (field.motion[3 + d][n] - 0.5 * step * field.motion[d][n]);
  ledger_.contact_loss += step_contact_loss_;
  ledger_.transfer_loss += gained - step_contact_loss_ - kinetic;
}


void ParticleStep::collect_rates(const TileGrid &grid,
                                 Particles &particles) const
{
  const TimerScope timer("velocity gradients");
  Window window(3 * size);
  for (const Field &field : fields_)
    for (const Tile &tile : tiles(grid.sources(), particles, field.materials))
    {
      read_window(*tile.first, field.motion, 3, one_vector, window.data());
      for (const unsigned int m : field.materials)
        collect_rate(scheme_.degree,
                     window.data(),
                     window_geometry(grid, *tile.first),
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
  for (auto &tile : particles.tiles())
    for (unsigned int m = 0; m < materials_.size(); ++m)
      if (tile.second[m].size() > 0)
        strain_particles(
          materials_[m], step, grid.box().cell_size, tile.second[m]);
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
    find_interfaces(grid, particles);
    find_velocities(grid, particles);
    reset_to_velocities_before(grid);
    collect_rates(grid, particles);
    strain(grid, particles, step);
    smooth(grid, particles, true);
    deposit_fields(grid, particles, Deposit::force);
  }
  else
  {
    deposit_fields(grid, particles, Deposit::momentum_force);
    find_interfaces(grid, particles);
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
      throw_step_failure(particles, step, grid.communicator());
    step *= 0.5;
    ++n_retries_;
  }
  move_particles(grid, particles, step);
  if (scheme_.update == StressUpdate::modified_last)
  {
    deposit_fields(grid, particles, Deposit::momentum);
    find_velocities(grid, particles);
    reset_to_velocities_before(grid);
  }
  if (scheme_.update != StressUpdate::first)
  {
    collect_rates(grid, particles);
    strain(grid, particles, step);
  }
  particles.for_each_block(
    [](unsigned int, ParticleBlock &block) { advance_positions(block); });
  particles.sort(grid);
  // At the present positions of the particles, like forces and rates.
  smooth(grid, particles, true);
  return step;
}
} // namespace contrecoup::mpm
