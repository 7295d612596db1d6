// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/ale/lagrange/corner_forces.h>
#include <contrecoup/ale/mesh/cell_corners.h>
#include <contrecoup/base/system/exceptions.h>
#include <contrecoup/materials/principal_difference.h>
#include <contrecoup/materials/relaxation.h>
#include <contrecoup/numerics/element/hex8_moments.h>

#include <cmath>

namespace contrecoup::ale
{
namespace
{
  using Lane = CellBatches::Lane;

  /// Least hourglass modulus over the bulk modulus.
  constexpr double least_hourglass = 1e-6;

  /// Gathers three components at the corners of a batch.
  HexVectors<Lane> gather(const dealii::AlignedVector<double> &field,
                          const unsigned int *offsets)
  {
    HexVectors<Lane> result;
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      Lane values[node_width];
      dealii::vectorized_load_and_transpose(
        node_width, field.data(), offsets + CellBatches::n * corner, values);
      for (unsigned int d = 0; d < 3; ++d)
        result[corner][d] = values[d];
    }
    return result;
  }

  Lane gather_cells(const double *field, const unsigned int *cells)
  {
    Lane result;
    result.gather(field, cells);
    return result;
  }

  /// Extremes in the lanes of batches; squares of strains and speeds.
  struct LaneExtremes
  {
    Lane least_pressure = Lane(std::numeric_limits<double>::max());
    Lane largest_pressure = Lane(std::numeric_limits<double>::lowest());
    Lane shear_strain = Lane(0.), speed = Lane(0.), void_volume = Lane(0.);

    void add_pressure(const Lane &pressure)
    {
      least_pressure = std::min(least_pressure, pressure);
      largest_pressure = std::max(largest_pressure, pressure);
    }
    void add_strain(const Symmetric3<Lane> &strain)
    {
      if (!any_less(shear_strain, square_difference_bound(strain)))
        return;
      const Lane difference = principal_difference(strain);
      shear_strain = std::max(shear_strain, difference * difference);
    }
    void add_velocities(const HexVectors<Lane> &velocities)
    {
      for (const Vector3<Lane> &v : velocities)
        speed = std::max(speed, dot(v, v));
    }
    RegionExtremes over_lanes() const
    {
      double volume = 0.;
      for (unsigned int lane = 0; lane < CellBatches::n; ++lane)
        volume += void_volume[lane];
      return {smallest_lane(least_pressure),
              largest_lane(largest_pressure),
              std::sqrt(largest_lane(shear_strain)),
              std::sqrt(largest_lane(speed)),
              volume};
    }
  };

  template <typename Number>
  MovingSolidModel<Number> solid_model(const Region &region, const double step)
  {
    const SolidMaterial &material = *region.solid();
    const double shear = material.instantaneous_shear;
    MovingSolidModel<Number> model;
    model.law.bulk = material.bulk_modulus;
    model.law.twice_shear = 2. * shear;
    model.law.twice_relaxing = 2. * material.relaxing_shear;
    model.law.decay_before = model.law.decay_after =
      std::exp(relaxation_exponent(0.5 * step, material.relaxation_time));
    model.density = material.density;
    model.sound_speed = material.dilatational_speed();
    model.linear_viscosity = region.viscosity.linear;
    model.quadratic_viscosity = region.viscosity.quadratic;
    model.hourglass_spring =
      hourglass_spring *
      std::max(shear, least_hourglass * material.bulk_modulus);
    if (material.bulk_modulus > nearly_incompressible * shear)
      model.hourglass_damper =
        region.viscosity.hourglass / 64. * material.density * model.sound_speed;
    return model;
  }
} // namespace


void CornerForces::reinit(const HexSpace &space,
                          const std::vector<Region> &regions)
{
  space_ = &space;
  regions_ = regions;
  extremes_.assign(regions.size(), RegionExtremes());
  batches_.reinit(space, node_width);
  for (const CellBatches::Range &range : batches_.ranges())
    if (range.region >= regions.size())
      throw InputError("Mesh: material id " + std::to_string(range.region) +
                       " is none of the " + std::to_string(regions.size()) +
                       " regions");
  undeformed_ = space.positions(node_width);
  forces_.resize(24 * batches_.n_batches());
}


void CornerForces::store(const unsigned int batch,
                         const HexVectors<Lane> &forces,
                         dealii::AlignedVector<double> &force)
{
  const Lane weight = batches_.weight(batch);
  Lane *stored = &forces_[24 * batch];
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    Lane values[node_width];
    for (unsigned int d = 0; d < 3; ++d)
      values[d] = -weight * forces[corner][d];
    if (keeps_forces_)
      for (unsigned int d = 0; d < 3; ++d)
        stored[3 * corner + d] = forces[corner][d];
    values[3] = Lane(0.);
    // One lane after the other, because lanes may share a node.
    dealii::vectorized_transpose_and_store(
      true, node_width, values, batches_.offsets(batch, corner), force.data());
  }
}


template <typename Law>
void CornerForces::add_fluid(const CellBatches::Range &range,
                             const Law &law,
                             const AleState &state,
                             dealii::AlignedVector<double> &force)
{
  const FluidViscosity &viscosity = regions_[range.region].viscosity;
  LaneExtremes extremes;
  Lane rate(0.), least(std::numeric_limits<double>::max());
  for (unsigned int batch = range.begin; batch < range.end; ++batch)
  {
    const unsigned int *offsets = batches_.offsets(batch, 0);
    const unsigned int *cells = batches_.cells(batch);
    FluidElement<Lane> element;
    element.mass = gather_cells(state.mass.data(), cells);
    element.energy = gather_cells(state.energy.data(), cells);
    element.products = gather_cells(state.products.data(), cells);
    const HexVectors<Lane> velocities = gather(state.velocity, offsets);
    store(batch,
          fluid_forces(law,
                       viscosity,
                       gather(state.position, offsets),
                       velocities,
                       element,
                       state.wedge),
          force);
    rate = std::max(rate, element.signal_rate);
    least = std::min(least, element.volume);
    if (!keeps_extremes_)
      continue;
    extremes.add_pressure(element.pressure);
    extremes.add_velocities(velocities);
    if constexpr (std::is_same_v<Law, Tait>)
      if (law.cavitation_density() > 0.)
        extremes.void_volume +=
          batches_.weight(batch) *
          std::max(Lane(0.),
                   element.volume - element.mass / law.cavitation_density());
  }
  if (keeps_extremes_)
    extremes_[range.region].include(extremes.over_lanes());
  signal_rate_ = std::max(signal_rate_, largest_lane(rate));
  least_volume_ = std::min(least_volume_, smallest_lane(least));
}


template <SolidKinematics kinematics, bool viscoelastic>
void CornerForces::add_solid(const CellBatches::Range &range,
                             const MovingSolidModel<Lane> &model,
                             AleState &state,
                             dealii::AlignedVector<double> &force)
{
  const std::size_t n_cells = space_->n_cells();
  LaneExtremes extremes;
  Lane rate(0.), least(std::numeric_limits<double>::max());
  for (unsigned int batch = range.begin; batch < range.end; ++batch)
  {
    const unsigned int *offsets = batches_.offsets(batch, 0);
    const unsigned int *cells = batches_.cells(batch);
    MovingSolid<Lane> element;
    if constexpr (viscoelastic)
      for (unsigned int k = 0; k < 6; ++k)
        element.relaxed[k] = gather_cells(&state.relaxed[k * n_cells], cells);
    store(batch,
          moving_solid_forces<kinematics, viscoelastic>(
            model,
            gather(undeformed_, offsets),
            gather(state.position, offsets),
            gather(state.velocity, offsets),
            element),
          force);
    rate = std::max(rate, element.signal_rate);
    least = std::min(least, element.dilatation);
    if (keeps_extremes_)
    {
      extremes.add_pressure(element.pressure);
      extremes.add_strain(element.strain);
    }
    if (viscoelastic && keeps_forces_)
      for (unsigned int k = 0; k < 6; ++k)
        element.relaxed[k].scatter(cells, &state.relaxed[k * n_cells]);
  }
  if (keeps_extremes_)
    extremes_[range.region].include(extremes.over_lanes());
  signal_rate_ = std::max(signal_rate_, largest_lane(rate));
  least_volume_ = std::min(least_volume_, 1. + smallest_lane(least));
}


template <SolidKinematics kinematics>
void CornerForces::add_solid(const CellBatches::Range &range,
                             const double step,
                             AleState &state,
                             dealii::AlignedVector<double> &force)
{
  const Region &region = regions_[range.region];
  auto model = solid_model<Lane>(region, step);
  model.wedge = state.wedge;
  if (region.is_viscoelastic())
    add_solid<kinematics, true>(range, model, state, force);
  else
    add_solid<kinematics, false>(range, model, state, force);
}


void CornerForces::compute(AleState &state,
                           const double step,
                           dealii::AlignedVector<double> &force)
{
  signal_rate_ = 0.;
  least_volume_ = std::numeric_limits<double>::max();
  keeps_extremes_ = !(step > 0.);
  if (keeps_extremes_)
    extremes_.assign(regions_.size(), RegionExtremes());
  for (const CellBatches::Range &range : batches_.ranges())
  {
    keeps_forces_ = step > 0. || uses_energy(range.region);
    const SolidKinematics kinematics = regions_[range.region].kinematics;
    std::visit(
      [&](const auto &law) {
        using Law = std::decay_t<decltype(law)>;
        if constexpr (!std::is_same_v<Law, SolidMaterial>)
          add_fluid(range, law, state, force);
        else if (kinematics == SolidKinematics::small_strain)
          add_solid<SolidKinematics::small_strain>(range, step, state, force);
        else if (kinematics == SolidKinematics::finite_rotation)
          add_solid<SolidKinematics::finite_rotation>(
            range, step, state, force);
        else
          add_solid<SolidKinematics::neo_hookean>(range, step, state, force);
      },
      regions_[range.region].law);
  }
}


bool CornerForces::uses_energy(const unsigned int region) const
{
  const RegionLaw &law = regions_[region].law;
  return !std::holds_alternative<Tait>(law) &&
         !std::holds_alternative<SolidMaterial>(law);
}


bool CornerForces::add_work(const dealii::AlignedVector<double> &before,
                            const dealii::AlignedVector<double> &velocity,
                            const double step,
                            dealii::AlignedVector<double> &after,
                            const bool is_first_half) const
{
  bool is_finite = true;
  for (const CellBatches::Range &range : batches_.ranges())
  {
    if (is_first_half && !uses_energy(range.region))
      continue;
    for (unsigned int batch = range.begin; batch < range.end; ++batch)
    {
      const HexVectors<Lane> v = gather(velocity, batches_.offsets(batch, 0));
      const Lane *forces = &forces_[24 * batch];
      Lane power(0.);
      for (unsigned int corner = 0; corner < 8; ++corner)
        for (unsigned int d = 0; d < 3; ++d)
          power += forces[3 * corner + d] * v[corner][d];
      const unsigned int *cells = batches_.cells(batch);
      const Lane energy = gather_cells(before.data(), cells) + step * power;
      energy.scatter(cells, after.data());
      // The comparison is false for NaN.
      is_finite =
        is_finite &&
        all_greater(energy, Lane(-std::numeric_limits<double>::max())) &&
        all_greater(Lane(std::numeric_limits<double>::max()), energy);
    }
  }
  return is_finite;
}


double CornerForces::signal_rate(const AleState &state,
                                 const std::size_t cell) const
{
  const auto x = corners_of(space_->cell(cell), state.position),
             v = corners_of(space_->cell(cell), state.velocity);
  const Region &region = regions_[space_->region(cell)];
  return std::visit(
    [&](const auto &law) {
      using Law = std::decay_t<decltype(law)>;
      if constexpr (std::is_same_v<Law, SolidMaterial>)
      {
        MovingSolid<double> element;
        moving_solid_forces<SolidKinematics::finite_rotation, false>(
          solid_model<double>(region, 0.),
          corners_of(space_->cell(cell), undeformed_),
          x,
          v,
          element);
        return element.signal_rate;
      }
      else
      {
        FluidElement<double> element;
        element.mass = state.mass[cell];
        element.energy = state.energy[cell];
        element.products = state.products[cell];
        fluid_forces(law, region.viscosity, x, v, element);
        return element.signal_rate;
      }
    },
    region.law);
}


CellValues CornerForces::solid_values(const AleState &state,
                                      const std::size_t cell) const
{
  const auto undeformed = corners_of(space_->cell(cell), undeformed_);
  auto displacement = corners_of(space_->cell(cell), state.position);
  for (unsigned int i = 0; i < 8; ++i)
    for (unsigned int d = 0; d < 3; ++d)
      displacement[i][d] -= undeformed[i][d];
  const Matrix3<double> h =
    mean_gradient(hex_geometry(to_modes(undeformed)), to_modes(displacement));
  const Region &region = regions_[space_->region(cell)];
  const auto strain =
    region.kinematics == SolidKinematics::small_strain
      ? solid_strain<SolidKinematics::small_strain>(h, cofactor(h))
      : solid_strain<SolidKinematics::finite_rotation>(h, cofactor(h));
  dealii::SymmetricTensor<2, 3> green;
  for (unsigned int k = 0; k < 6; ++k)
    green[k % 3][k < 3 ? k : (k + 1) % 3] = strain.total[k];
  const auto principal = dealii::eigenvalues(green);
  CellValues values;
  values.pressure = -region.solid()->bulk_modulus * strain.dilatation;
  values.shear_strain = principal[0] - principal[2];
  values.principal_strain = principal[0];
  return values;
}


CellValues CornerForces::values(const AleState &state,
                                const std::size_t cell) const
{
  const auto corners = corners_of(space_->cell(cell), state.position);
  const double volume = hex_geometry(to_modes(corners)).volume;
  CellValues values = std::visit(
    [&](const auto &law) {
      using Law = std::decay_t<decltype(law)>;
      CellValues result;
      if constexpr (std::is_same_v<Law, SolidMaterial>)
        result = solid_values(state, cell);
      else
        result.pressure = law.pressure(state.mass[cell] / volume,
                                       state.energy[cell] / volume,
                                       state.products[cell]);
      if constexpr (std::is_same_v<Law, Tait>)
        result.void_fraction = law.void_fraction(state.mass[cell] / volume);
      return result;
    },
    regions_[space_->region(cell)].law);
  values.mass = state.mass[cell];
  values.energy = state.energy[cell];
  values.volume = volume;
  return values;
}
} // namespace contrecoup::ale
