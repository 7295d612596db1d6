// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/ale/rezone/remap.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

namespace contrecoup::ale
{
namespace
{
  /// Half of the squared velocity.
  double half_square(const double *v)
  {
    return 0.5 * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
} // namespace


void Remap::reinit(const HexSpace &space,
                   const std::vector<bool> &is_at_rest,
                   const RemapLimiter limiter)
{
  limiter_ = limiter;
  space_ = &space;
  is_at_rest_ = is_at_rest;
  cells_.clear();
  cells_at_rest_.clear();
  for (std::uint32_t c = 0; c < space.n_locally_owned_cells(); ++c)
    (rests(c) ? cells_at_rest_ : cells_).push_back(c);
  ties_.reinit(space);
  reconstruction_.reinit(space, n_fields, is_at_rest, limiter);
  if (limiter == RemapLimiter::strict)
    flows_.reinit(space, n_fields);
  node_exchange_.reinit(space.nodes(), n_sums);
  cell_exchange_.reinit(space.cells(), 1);
  fields_.resize(n_fields * space.n_cells());
  contents_.resize(n_contents * space.n_locally_owned_cells());
}


void Remap::fill_fields(const AleState &state)
{
  for (std::uint32_t c = 0; c < space_->n_cells(); ++c)
  {
    if (rests(c))
      continue;
    double *field = &fields_[n_fields * c];
    const auto corners = corners_of(space_->cell(c), state.position);
    const auto velocities = corners_of(space_->cell(c), state.velocity);
    for (unsigned int i = 0; i < 8; ++i)
      for (unsigned int d = 0; d < 3; ++d)
        field[velocity + 3 * i + d] = velocities[i][d];
    field[density] = state.mass[c] / hex_geometry(to_modes(corners)).volume;
    field[energy] = state.energy[c] / state.mass[c];
    field[products] = state.products[c];
  }
}


void Remap::carry_face(const AleState &state,
                       const dealii::AlignedVector<double> &position,
                       const HexSpace::Face &face)
{
  std::array<Vector3<double>, 4> before, after;
  bool moves = false;
  for (unsigned int i = 0; i < 4; ++i)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const std::size_t place = node_width * face.nodes[i] + d;
      before[i][d] = state.position[place];
      after[i][d] = position[place];
      moves = moves || before[i][d] != after[i][d];
    }
  if (!moves)
    return;
  // The corner nodes of the face belong to `inside`.
  if (rests(face.inside) || (rests(face.outside) && !space_->is_sliding(face)))
    throw NumericsError("time " + exact(state.time) +
                        " s: the rezone would move a solid's node, at cell " +
                        std::to_string(space_->cell_number(face.inside)));
  // The volume that `inside` gains leaves `outside`.
  const auto swept = swept_moments(before, after);
  if (is_closed(face))
    return check_boundary(state, face, swept.volume);
  if (swept.volume == 0.)
    return;
  const std::uint32_t donor = swept.volume > 0. ? face.outside : face.inside;
  const auto &centre = reconstruction_.centre(donor);
  const double *field = &fields_[n_fields * donor];
  Vector3<double> moment;
  for (unsigned int d = 0; d < 3; ++d)
    moment[d] = swept.first[d] - swept.volume * centre[d];
  const auto change = [&](const unsigned int f) {
    const double *g = reconstruction_.gradient(donor, f);
    return g[0] * moment[0] + g[1] * moment[1] + g[2] * moment[2];
  };
  // Integrate linear functions with the swept moments, not at a centroid: a
  // rotating face has a first moment but zero volume.
  std::array<double, n_fields> carried;
  carried[0] = swept.volume * field[density] + change(density);
  for (unsigned int f = 1; f < n_fields; ++f)
    carried[f] = carried[0] * field[f] + field[density] * change(f);
  if (limiter_ == RemapLimiter::strict)
    flows_.add(face, swept.volume, donor, carried.data());
  else
    add_flow(face, donor, carried.data());
}


void Remap::add_flow(const HexSpace::Face &face,
                     const std::uint32_t donor,
                     const double *carried)
{
  const double *field = &fields_[n_fields * donor];
  std::array<double, 8> energies;
  for (unsigned int i = 0; i < 8; ++i)
  {
    const double *v = &field[velocity + 3 * i];
    double &sum = energies[i];
    sum = -carried[0] * half_square(v);
    for (unsigned int d = 0; d < 3; ++d)
      sum += v[d] * carried[velocity + 3 * i + d];
  }
  const auto add = [&](const std::uint32_t cell, const double sign) {
    if (cell >= space_->n_locally_owned_cells())
      return;
    double *content = &contents_[n_contents * cell];
    for (unsigned int f = 0; f < n_fields; ++f)
      content[f] += sign * carried[f];
    for (unsigned int i = 0; i < 8; ++i)
      content[kinetic + i] += sign * energies[i];
  };
  add(face.inside, 1.);
  add(face.outside, -1.);
}


bool Remap::is_closed(const HexSpace::Face &face) const
{
  return face.outside == HexSpace::no_cell ||
         space_->region(face.inside) != space_->region(face.outside);
}


bool Remap::rests(const std::uint32_t cell) const
{
  return cell != HexSpace::no_cell && !is_at_rest_.empty() &&
         is_at_rest_[space_->region(cell)];
}


void Remap::check_boundary(const AleState &state,
                           const HexSpace::Face &face,
                           const double swept) const
{
  // Sliding along a curved wall sweeps a small volume; nothing passes.
  constexpr double largest_part = 1e-3;
  if (std::abs(swept) > largest_part * reconstruction_.volume(face.inside))
    throw NumericsError(
      "time " + exact(state.time) +
      " s: the rezone would move the boundary at cell " +
      std::to_string(space_->cell_number(face.inside)) +
      " away from the matter; Rezone/Kind = back needs sides at rest");
}


void Remap::carry_over(const AleState &state,
                       const dealii::AlignedVector<double> &position)
{
  for (const std::uint32_t c : cells_)
  {
    double *content = &contents_[n_contents * c];
    const double *field = &fields_[n_fields * c];
    content[0] = state.mass[c];
    for (unsigned int f = 1; f < n_fields; ++f)
      content[f] = state.mass[c] * field[f];
    for (unsigned int i = 0; i < 8; ++i)
      content[kinetic + i] =
        state.mass[c] * half_square(&field[velocity + 3 * i]);
  }
  flows_.clear();
  for (const HexSpace::Face &face : space_->faces())
    carry_face(state, position, face);
  if (limiter_ != RemapLimiter::strict)
    return;
  flows_.limit(fields_, state.mass);
  for (std::size_t i = 0; i < flows_.size(); ++i)
    add_flow(flows_.face(i), flows_.donor(i), flows_.carried(i));
}


void Remap::check_masses(const AleState &state) const
{
  std::string text;
  for (const std::uint32_t c : cells_)
    if (text.empty() && !(contents_[n_contents * c] > 0.))
      text = "cell " + std::to_string(space_->cell_number(c)) +
             " would lose more mass than it has";
  const int failed =
    dealii::Utilities::MPI::max(text.empty() ? 0 : 1, space_->communicator());
  if (failed == 1)
    throw NumericsError("time " + exact(state.time) + " s: in the remap " +
                        (text.empty() ? "a cell of another rank fails" : text));
}


void Remap::add_unadvected_mass(const AleState &state,
                                const double *v,
                                double *sum)
{
  const double eighths = sum[3];
  if (state.wedge.active())
  {
    // This part of the mass does not change and keeps its velocity.
    const double unadvected_mass = 1. / v[3] - sum[5];
    for (unsigned int d = 0; d < 3; ++d)
      sum[d] += unadvected_mass * v[d];
    sum[3] += unadvected_mass;
    sum[4] += unadvected_mass * half_square(v);
  }
  sum[5] = sum[3] / eighths;
}


void Remap::collect(AleState &state,
                    const SlipWalls &walls,
                    const dealii::AlignedVector<double> &position)
{
  constexpr unsigned int n = n_sums;
  dealii::AlignedVector<double> sums(node_exchange_.size());
  for (const std::uint32_t c : cells_)
  {
    const double *content = &contents_[n_contents * c];
    for (unsigned int i = 0; i < 8; ++i)
    {
      double *sum = &sums[n * space_->cell(c)[i]];
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += 0.125 * content[velocity + 3 * i + d];
      sum[3] += 0.125 * content[0];
      sum[4] += 0.125 * content[kinetic + i];
      sum[5] += 0.125 * state.mass[c];
    }
  }
  for (const std::uint32_t c : cells_at_rest_)
    for (const std::uint32_t node : space_->cell(c))
    {
      const double *v = &state.velocity[node_width * node];
      const double mass = 0.125 * state.mass[c];
      double *sum = &sums[n * node];
      for (unsigned int d = 0; d < 3; ++d)
        sum[d] += mass * v[d];
      sum[3] += mass;
      sum[4] += mass * half_square(v);
      sum[5] += mass;
    }
  node_exchange_.compress_add(sums);
  node_exchange_.update_ghost_values(sums);
  for (std::size_t node = 0; node < space_->n_nodes(); ++node)
  {
    double *v = &state.velocity[node_width * node];
    add_unadvected_mass(state, v, &sums[n * node]);
    for (unsigned int d = 0; d < 3; ++d)
      v[d] = sums[n * node + d] / sums[n * node + 3];
    v[3] = 1. / sums[n * node + 3];
  }
  walls.apply(state.velocity, state.time);
  ties_.find_normals(position, walls);
  ties_.apply(state.velocity);
  // Kinetic energy per mass that averaging of nodal velocities loses.
  const auto heat = [&](const std::uint32_t c) {
    double result = 0.;
    for (const std::uint32_t node : space_->cell(c))
      result +=
        sums[n * node + 5] * (sums[n * node + 4] / sums[n * node + 3] -
                              half_square(&state.velocity[node_width * node]));
    return 0.125 * result;
  };
  for (const std::uint32_t c : cells_)
  {
    const double *content = &contents_[n_contents * c];
    state.mass[c] = content[0];
    state.products[c] = content[products] / content[0];
    state.energy[c] = content[energy] + content[0] * heat(c);
  }
  for (const std::uint32_t c : cells_at_rest_)
    state.energy[c] += state.mass[c] * heat(c);
}


void Remap::apply(AleState &state,
                  const SlipWalls &walls,
                  const dealii::AlignedVector<double> &position)
{
  cell_exchange_.update_ghost_values(state.mass);
  cell_exchange_.update_ghost_values(state.energy);
  cell_exchange_.update_ghost_values(state.products);
  fill_fields(state);
  reconstruction_.compute(state.position, fields_);
  carry_over(state, position);
  check_masses(state);
  collect(state, walls, position);
  cell_exchange_.update_ghost_values(state.mass);
  cell_exchange_.update_ghost_values(state.energy);
  cell_exchange_.update_ghost_values(state.products);
  state.position = position;
}
} // namespace contrecoup::ale
