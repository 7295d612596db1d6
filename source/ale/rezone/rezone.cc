// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/ale/rezone/inclined_walls.h>
#include <contrecoup/ale/rezone/rezone.h>
#include <contrecoup/base/parameters/parameters.h>
#include <contrecoup/base/parameters/used_with.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/base/system/text.h>
#include <contrecoup/base/system/timers.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <deal.II/base/mpi.h>

#include <algorithm>

namespace contrecoup::ale
{
namespace
{
  /// Names of the values of RezoneKind and RemapLimiter, in the same order.
  const std::vector<std::string> names{"none", "elastic", "back"};
  const std::vector<std::string> limiters{"keep smooth extrema", "strict"};

  std::size_t place_of(const std::string &name,
                       const std::vector<std::string> &list)
  {
    return std::find(list.begin(), list.end(), name) - list.begin();
  }

  double cell_volume(const HexSpace::Cell &cell, const AleState &state)
  {
    const auto corners = corners_of(cell, state.position);
    return hex_geometry(to_modes(corners)).volume;
  }
} // namespace


void Rezone::declare_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Rezone");
  const UsedWith with_mesh("Method = ale");
  declare_selection(prm,
                    "Kind",
                    "none",
                    names,
                    "none: Lagrangian mesh; elastic: inner nodes follow the "
                    "boundary by elastic smoothing; back: all nodes return "
                    "to their initial positions (Eulerian).");
  {
    const UsedWith used("Rezone/Kind not none");
    declare_double(prm,
                   "Interval",
                   "0",
                   0.,
                   1e6,
                   "s",
                   "Simulated time between rezones; 0: every step.");
    declare_selection(prm,
                      "Limiter",
                      limiters[0],
                      limiters,
                      "Limiter of the reconstruction in the remap. keep "
                      "smooth extrema: second order at smooth extrema, with "
                      "overshoots of up to a hundredth of a jump. strict: no "
                      "overshoots of density, energy, mass fraction or "
                      "velocity components, but order 1.4 at smooth peaks.");
  }
  {
    const UsedWith used("Rezone/Kind = elastic");
    declare_double(prm,
                   "Stiffening",
                   "1",
                   0.,
                   4.,
                   "-",
                   "Young's modulus of the mesh is the inverse cell volume to "
                   "this power; larger values preserve the shape of small "
                   "cells.");
    declare_double(prm,
                   "Poisson's ratio",
                   "0.3",
                   0.,
                   0.49,
                   "-",
                   "Poisson's ratio of the elastic mesh.");
    declare_double(prm,
                   "Tolerance",
                   "1e-6",
                   1e-14,
                   0.1,
                   "-",
                   "Relative residual of the elastic problem; a smaller one "
                   "changed errors by at most 1e-4 of themselves, also with "
                   "flat cells.");
  }
}


void Rezone::parse_parameters(ParameterHandler &prm)
{
  const Section section(prm, "Rezone");
  kind_ = static_cast<RezoneKind>(place_of(prm.get("Kind"), names));
  limiter_ = static_cast<RemapLimiter>(place_of(prm.get("Limiter"), limiters));
  interval_ = read_double(prm, "Interval");
  options_.stiffening = read_double(prm, "Stiffening");
  options_.poisson_ratio = read_double(prm, "Poisson's ratio");
  options_.tolerance = read_double(prm, "Tolerance");
}


void Rezone::check_interval(const double step) const
{
  // The margin allows for steps that shorten as cells are compressed.
  if (kind_ != RezoneKind::none && interval_ > 0. && interval_ < 0.1 * step)
    throw InputError("Rezone/Interval = " + brief(interval_) +
                     " s is far below the step, about " + brief(step) +
                     " s; use 0 to rezone after each step");
}


void Rezone::check_regions(const std::vector<Region> &regions) const
{
  for (const Region &region : regions)
    if (region.slides && kind_ != RezoneKind::elastic)
      throw InputError("Region " + region.name +
                       "/Interface = slip needs Rezone/Kind = elastic, which "
                       "moves sliding nodes back to those of the other side");
  if (kind_ == RezoneKind::back && regions.size() > 1)
    throw InputError("Rezone/Kind = back needs a single region, because a "
                     "cell holds one material; let Density and Pressure "
                     "depend on x, y, z, or use elastic");
  if (kind_ != RezoneKind::none &&
      std::all_of(regions.begin(), regions.end(), [](const Region &region) {
        return region.solid() != nullptr;
      }))
    throw InputError("Rezone/Kind must be none if all regions are solids, "
                     "whose mesh moves with the matter");
}


void Rezone::reinit(
  HexSpace &space,
  const AleState &state,
  const std::vector<Region> &regions,
  const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls)
{
  space_ = &space;
  is_solid_.clear();
  for (const Region &region : regions)
    is_solid_.push_back(region.solid() != nullptr);
  start_ = state.position;
  reference_ = state.position;
  due_ = state.time + interval_;
  if (kind_ == RezoneKind::none)
    return;
  remap_.reinit(space, is_solid_, limiter_);
  if (kind_ != RezoneKind::elastic)
    return;
  find_prescribed(walls);
  smoothing_.reinit(space, prescribed_, options_);
}


SmoothingMemory Rezone::memory() const
{
  return kind_ == RezoneKind::elastic ? smoothing_.memory()
                                      : SmoothingMemory(*space_);
}


void Rezone::resume(const AleState &state,
                    const unsigned int n_rezones,
                    const unsigned int n_skipped,
                    const SmoothingMemory &memory)
{
  if (kind_ == RezoneKind::elastic)
    smoothing_.resume(memory);
  n_rezones_ = n_rezones;
  n_skipped_ = n_skipped;
  due_ = interval_;
  while (interval_ > 0. && due_ <= state.time * (1. + 1e-12))
    due_ += interval_;
}


int Rezone::axis_normal_to(const HexSpace::Face &face) const
{
  for (unsigned int d = 0; d < 3; ++d)
  {
    double lowest = std::numeric_limits<double>::max(), highest = -lowest;
    double size = 0.;
    for (const std::uint32_t node : face.nodes)
    {
      lowest = std::min(lowest, start_[node_width * node + d]);
      highest = std::max(highest, start_[node_width * node + d]);
      for (unsigned int e = 0; e < 3; ++e)
        size = std::max(size,
                        std::abs(start_[node_width * node + e] -
                                 start_[node_width * face.nodes[0] + e]));
    }
    if (highest - lowest < 1e-9 * size)
      return static_cast<int>(d);
  }
  return -1;
}


void Rezone::find_prescribed(
  const std::map<dealii::types::boundary_id, SlipWalls::Motion> &walls)
{
  std::vector<dealii::types::boundary_id> boundaries;
  for (const auto &wall : walls)
    boundaries.push_back(wall.first);
  const InclinedWalls inclined(
    *space_, start_, boundaries, [this](const HexSpace::Face &face) {
      return axis_normal_to(face) < 0;
    });
  // Per node: three directions, all directions, and each inclined wall.
  constexpr unsigned int all = 3;
  const unsigned int n = 4 + inclined.size();
  FieldExchange exchange;
  exchange.reinit(space_->nodes(), n);
  dealii::AlignedVector<double> count(exchange.size());
  for (const HexSpace::Face &face : space_->faces())
  {
    if (face.outside != HexSpace::no_cell &&
        space_->region(face.inside) == space_->region(face.outside))
      continue;
    const bool is_wall =
      face.outside == HexSpace::no_cell && walls.count(face.boundary) > 0;
    const int axis = is_wall ? axis_normal_to(face) : -1;
    for (unsigned int i = 0; i < 4; ++i)
    {
      const unsigned int wall =
        is_wall && axis < 0 ? inclined.wall_around(face, i) : inclined.none;
      const unsigned int direction = axis >= 0 ? static_cast<unsigned int>(axis)
                                     : wall == inclined.none ? all
                                                             : 4 + wall;
      count[n * face.nodes[i] + direction] += 1.;
    }
  }
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
    if (is_solid_[space_->region(c)])
      for (const std::uint32_t node : space_->cell(c))
        count[n * node + all] += 1.;
  exchange.compress_add(count);
  exchange.update_ghost_values(count);
  // Both nodes of a sliding pair lie on an interface.
  for (const auto &[sliding, held] : space_->sliding_pairs())
    count[n * sliding + all] = count[n * held + all] = 1.;
  prescribed_ = PrescribedNodes();
  for (std::size_t node = 0; node < space_->n_nodes(); ++node)
  {
    const double *c = &count[n * node];
    std::array<bool, 3> is_prescribed{{c[0] > 0. || c[all] > 0.,
                                       c[1] > 0. || c[all] > 0.,
                                       c[2] > 0. || c[all] > 0.}};
    inclined.add_node(static_cast<std::uint32_t>(node),
                      c + 4,
                      is_prescribed,
                      prescribed_.inclined);
    prescribed_.components.push_back(is_prescribed);
  }
}


bool Rezone::is_valid(const dealii::AlignedVector<double> &position) const
{
  int valid = 1;
  for (std::size_t c = 0; c < space_->n_locally_owned_cells() && valid == 1;
       ++c)
  {
    // Solids keep their nodes, however deformed.
    if (!is_solid_[space_->region(c)] &&
        !(smallest_corner_jacobian(corners_of(space_->cell(c), position)) > 0.))
      valid = 0;
  }
  return dealii::Utilities::MPI::min(valid, space_->communicator()) == 1;
}


dealii::AlignedVector<double> Rezone::smoothed(const AleState &state,
                                               const SlipWalls &walls)
{
  const TimerScope timer("rezone: smoothing");
  dealii::AlignedVector<double> displacement = state.position;
  for (std::size_t i = 0; i < displacement.size(); ++i)
    displacement[i] -= reference_[i];
  smoothing_.solve(reference_, displacement);
  for (std::size_t n = 0; n < space_->n_nodes(); ++n)
    for (unsigned int d = 0; d < 3; ++d)
    {
      const std::size_t i = node_width * n + d;
      // Fixed nodes must match bitwise, so that nothing is remapped.
      displacement[i] = prescribed_.components[n][d]
                          ? state.position[i]
                          : reference_[i] + displacement[i];
    }
  // The solver is inexact, but wall constraints must hold exactly.
  for (const InclinedNode &slide : prescribed_.inclined)
  {
    const std::size_t i = node_width * slide.node;
    double ahead = 0.;
    for (unsigned int d = 0; d < 3; ++d)
      ahead += slide.factor[d] * (displacement[i + d] - state.position[i + d]);
    displacement[i + slide.component] =
      state.position[i + slide.component] + ahead;
  }
  for (const auto &[sliding, held] : space_->sliding_pairs())
    for (unsigned int d = 0; d < 3; ++d)
      displacement[node_width * sliding + d] =
        state.position[node_width * held + d];
  walls.make_mirrored(displacement);
  return displacement;
}


double
Rezone::largest_outflow(const AleState &state,
                        const dealii::AlignedVector<double> &position) const
{
  std::vector<double> outflow(space_->n_locally_owned_cells(), 0.);
  for (const HexSpace::Face &face : space_->faces())
  {
    std::array<Vector3<double>, 4> before, after;
    for (unsigned int i = 0; i < 4; ++i)
      for (unsigned int d = 0; d < 3; ++d)
      {
        before[i][d] = state.position[node_width * face.nodes[i] + d];
        after[i][d] = position[node_width * face.nodes[i] + d];
      }
    const double swept = swept_moments(before, after).volume;
    const std::uint32_t donor = swept > 0. ? face.outside : face.inside;
    if (donor < space_->n_locally_owned_cells())
      outflow[donor] += std::abs(swept);
  }
  double largest = 0.;
  for (std::size_t c = 0; c < space_->n_locally_owned_cells(); ++c)
    if (outflow[c] > 0.)
      largest =
        std::max(largest, outflow[c] / cell_volume(space_->cell(c), state));
  return dealii::Utilities::MPI::max(largest, space_->communicator());
}


void Rezone::carry_over(AleState &state,
                        const SlipWalls &walls,
                        const dealii::AlignedVector<double> &position)
{
  const TimerScope timer("rezone: remap");
  // The outflow is integrated from linear functions, so it must stay small.
  // Cells shrink on the way: each substep starts from the last result.
  constexpr double largest_part = 0.5;
  constexpr unsigned int most_parts = 10000;
  for (unsigned int part = 0; part < most_parts; ++part)
  {
    const double outflow = largest_outflow(state, position);
    if (outflow <= largest_part)
      return remap_.apply(state, walls, position);
    const double n = std::ceil(outflow / largest_part);
    dealii::AlignedVector<double> between = position;
    for (std::size_t k = 0; k < between.size(); ++k)
      if (between[k] != state.position[k])
        between[k] = state.position[k] + (between[k] - state.position[k]) / n;
    remap_.apply(state, walls, between);
  }
  throw NumericsError("time " + exact(state.time) +
                      " s: the rezone would move the mesh by too many cells");
}


bool Rezone::apply(AleState &state, const SlipWalls &walls)
{
  if (kind_ == RezoneKind::none || state.time < due_ * (1. - 1e-12))
    return false;
  while (interval_ > 0. && due_ <= state.time * (1. + 1e-12))
    due_ += interval_;
  dealii::AlignedVector<double> position =
    kind_ == RezoneKind::back ? start_ : smoothed(state, walls);
  // Halve the displacement where a cell would invert.
  for (unsigned int i = 0; i < 6 && !is_valid(position); ++i)
    for (std::size_t k = 0; k < position.size(); ++k)
      position[k] = 0.5 * (position[k] + state.position[k]);
  if (!is_valid(position))
  {
    ++n_skipped_;
    return false;
  }
  carry_over(state, walls, position);
  reference_ = position;
  ++n_rezones_;
  return true;
}
} // namespace contrecoup::ale
