// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/materials/relaxation.h>
#include <contrecoup/solid/motion/batch_loop.h>

#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  /// Least hourglass modulus over the bulk modulus, used for fluids.
  constexpr double fluid_hourglass = 1e-6;

  /// Least linear bulk viscosity of matter that cavitates. Without any, the
  /// energy of central differences grows with each collapse near the stable
  /// step; with this it is kept within 0.2 %, and the step safety covers it.
  constexpr double least_cavity_viscosity = 0.02;

  /// Sets what relaxes from the stored strain to now, and half a step on.
  /// Losses are those of central differences where strains change at a steady
  /// rate, for any ratio of step to relaxation time; the first step also has
  /// what an initial strain loses.
  template <typename Real>
  void set_relaxation(const double tau,
                      const StepTimes &times,
                      SolidLaw<Lanes<Real>> &law)
  {
    const double before =
                   std::exp(relaxation_exponent(times.relax_before, tau)),
                 after = std::exp(relaxation_exponent(times.relax_after, tau));
    const double relaxing = -std::expm1(
      relaxation_exponent(times.relax_before + times.relax_after, tau));
    const bool is_first =
      times.before > 0. && times.relax_before >= times.before;
    law.decay_before = Real(before);
    law.decay_after = Real(after);
    law.relaxing_fraction = Real(relaxing);
    law.lost_fraction =
      Real(is_first ? 0.5 - std::pow(after, 7) / (1. + after * after)
                    : before * relaxing);
  }

  /// Velocities of the corners of a batch.
  template <typename Real>
  HexVectors<Lanes<Real>> corner_velocities(const Real *velocity,
                                            const unsigned int *offsets)
  {
    std::array<std::array<Lanes<Real>, 4>, 8> loaded;
    load_vectors(velocity, offsets, loaded);
    HexVectors<Lanes<Real>> v;
    for (unsigned int corner = 0; corner < 8; ++corner)
      for (unsigned int d = 0; d < 3; ++d)
        v[corner][d] = loaded[corner][d];
    return v;
  }
} // namespace


template <typename Real>
void SolidOperator<Real>::reinit(const SolidMesh &mesh,
                                 const std::vector<SolidMaterial> &materials,
                                 const ElementOptions &options)
{
  mesh_ = &mesh;
  materials_ = materials;
  options_ = options;
  std::vector<bool> viscoelastic, damped, smoothed;
  largest_bulk_ = 0.;
  for (const SolidMaterial &material : materials)
  {
    viscoelastic.push_back(material.is_viscoelastic());
    damped.push_back(!full() && hourglass(material).has_damper());
    smoothed.push_back(smooths(material));
    if (smoothed.back())
      largest_bulk_ = std::max(largest_bulk_, material.bulk_modulus);
  }
  batches_.reinit(mesh, viscoelastic, damped, smoothed, full() ? 8 : 1);
  losses_.assign(materials.size(), {});
  least_dilatations_.assign(materials.size(), 0.);
}


template <typename Real>
void SolidOperator<Real>::reinit_nodes(NodeFields<Real> &nodes) const
{
  HexBatches<Real>::reinit_nodes(*mesh_, nodes);
}


template <typename Real>
std::vector<double> SolidOperator<Real>::nodal_masses() const
{
  std::vector<double> masses(mesh_->nodes.size(), 0.);
  for (std::size_t i = 0; i < mesh_->elements.size(); ++i)
  {
    HexVectors<double> x;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh_->nodes[mesh_->elements[i][c]][d];
    const double mass =
      materials_[mesh_->tissue[i]].density * hex_geometry(to_modes(x)).volume;
    for (const std::uint32_t node : mesh_->elements[i])
      masses[node] += mass / 8.;
  }
  return masses;
}


template <typename Real>
bool SolidOperator<Real>::smooths(const SolidMaterial &material) const
{
  return options_.pressure_smoothing > 0. && !material.gas.exists() &&
         !material.cavitates() &&
         material.bulk_modulus >
           nearly_incompressible * material.instantaneous_shear;
}


template <typename Real>
std::vector<double> SolidOperator<Real>::smoothing_weights() const
{
  std::vector<double> weights(mesh_->nodes.size(), 0.);
  for (std::size_t i = 0; i < mesh_->elements.size(); ++i)
  {
    const SolidMaterial &material = materials_[mesh_->tissue[i]];
    if (!smooths(material))
      continue;
    HexVectors<double> x;
    for (unsigned int c = 0; c < 8; ++c)
      for (unsigned int d = 0; d < 3; ++d)
        x[c][d] = mesh_->nodes[mesh_->elements[i][c]][d];
    const double weight =
      hex_geometry(to_modes(x)).volume * largest_bulk_ / material.bulk_modulus;
    for (const std::uint32_t node : mesh_->elements[i])
      weights[node] += weight;
  }
  return weights;
}


template <typename Real>
Hourglass<Lanes<Real>>
SolidOperator<Real>::hourglass(const SolidMaterial &material) const
{
  const double shear = std::max(material.instantaneous_shear,
                                fluid_hourglass * material.bulk_modulus);
  const double factor = options_.hourglass_coefficient;
  double viscosity = 0.;
  Hourglass<Lane> hourglass;
  hourglass.kind = options_.hourglass;
  hourglass.stiffness = Real(0.);
  switch (options_.hourglass)
  {
    case HourglassKind::none:
      hourglass.kind = HourglassKind::stiffness;
      break;
    case HourglassKind::viscous:
      viscosity =
        factor * hourglass_damper * std::sqrt(material.density * shear);
      break;
    case HourglassKind::stiffness:
      hourglass.stiffness = Real(factor * hourglass_spring * shear);
      break;
    case HourglassKind::assumed_strain:
      hourglass.stiffness = Real(factor * shear);
  }
  if (options_.hourglass_damping > 0. &&
      material.bulk_modulus >
        nearly_incompressible * material.instantaneous_shear)
  {
    viscosity += options_.hourglass_damping / 64. * material.density *
                 material.dilatational_speed();
    hourglass.damped = true;
  }
  hourglass.viscosity = Real(viscosity);
  return hourglass;
}


template <typename Real>
HexModel<Lanes<Real>> SolidOperator<Real>::model(const SolidMaterial &material,
                                                 const StepTimes &times) const
{
  HexModel<Lane> model;
  model.law.bulk = Real(material.bulk_modulus);
  model.law.gas = material.gas;
  model.law.largest_tension = Real(material.largest_tension);
  model.law.vapour_dilatation = Real(material.vapour_dilatation());
  model.law.twice_shear = Real(2. * material.instantaneous_shear);
  model.law.twice_relaxing = Real(2. * material.relaxing_shear);
  set_relaxation<Real>(material.relaxation_time, times, model.law);
  const double wave = material.density * material.dilatational_speed();
  const double linear =
    material.cavitates()
      ? std::max(options_.linear_viscosity, least_cavity_viscosity)
      : options_.linear_viscosity;
  model.viscosity.linear = Real(linear * wave);
  model.viscosity.quadratic =
    Real(options_.quadratic_viscosity * material.density);
  model.viscosity.inverse_step =
    Real(times.before > 0. ? 1. / times.before : 0.);
  model.step = Real(times.before);
  model.smoothing.active = smooths(material);
  const double part = options_.pressure_smoothing;
  model.smoothing.bulk = Real(part * material.bulk_modulus);
  model.smoothing.reference = Real(part * largest_bulk_);

  model.hourglass = hourglass(material);
  // As bulk viscosity, damping starts with the first step.
  if (!(times.before > 0.))
    model.hourglass.viscosity = Real(0.);
  return model;
}


template <typename Real>
HexModel<Lanes<Real>>
SolidOperator<Real>::linear_model(const SolidMaterial &material) const
{
  HexModel<Lane> model = this->model(material, StepTimes());
  model.law.gas = GasFilling();
  model.law.largest_tension = Real(no_cavitation);
  if (model.smoothing.active)
    model.law.bulk *=
      Real(PressureSmoothing<Lane>::stiffening(options_.pressure_smoothing));
  model.smoothing.active = false;
  return model;
}


template <typename Real>
Lanes<Real> SolidOperator<Real>::secant_bulk(const SolidLaw<Lane> &law,
                                             const NodeFields<Real> &nodes,
                                             const unsigned int batch) const
{
  HexVectors<Lane> x, u;
  load_corners(
    nodes.position_and_displacement.data(), batches_.offsets(batch, 0), x, u);
  const Matrix3<Lane> h = mean_gradient(hex_geometry(to_modes(x)), to_modes(u));
  const Lane dilatation = options_.kinematics == SolidKinematics::small_strain
                            ? h[0][0] + h[1][1] + h[2][2]
                            : finite_dilatation(h, cofactor(h));
  return law.bulk * apply_to_lanes(
                      [&](const double value) { return law.gas.secant(value); },
                      dilatation);
}


template <typename Real>
template <SolidKinematics kinematics, bool viscoelastic>
void SolidOperator<Real>::add_range(const Range &range,
                                    NodeFields<Real> &nodes,
                                    const HexModel<Lane> &model,
                                    TissueEnergies &losses)
{
  add_batches<viscoelastic>(
    range,
    nodes,
    model,
    losses,
    [&](const HexModel<Lane> &model_now,
        const unsigned int batch,
        const HexVectors<Lane> &x,
        const HexVectors<Lane> &u,
        HexState<Lane> &state,
        HexDissipation<Lane> &dissipation) {
      const auto velocities = [&]() {
        return corner_velocities(nodes.velocity.data(),
                                 batches_.offsets(batch, 0));
      };
      return one_point_forces<kinematics, viscoelastic>(
        model_now, x, u, velocities, state, dissipation);
    });
}


template <typename Real>
template <SolidKinematics kinematics>
void SolidOperator<Real>::add_all(NodeFields<Real> &nodes,
                                  const StepTimes &times)
{
  for (const Range &range : batches_.ranges())
  {
    const HexModel<Lane> model = this->model(materials_[range.tissue], times);
    if (range.viscoelastic)
      add_range<kinematics, true>(range, nodes, model, losses_[range.tissue]);
    else
      add_range<kinematics, false>(range, nodes, model, losses_[range.tissue]);
  }
}


template <typename Real>
void SolidOperator<Real>::add_forces(NodeFields<Real> &nodes,
                                     const StepTimes &times)
{
  least_dilatations_.assign(materials_.size(), 0.);
  if (full())
    add_full_forces(nodes, times);
  else if (options_.kinematics == SolidKinematics::small_strain)
    add_all<SolidKinematics::small_strain>(nodes, times);
  else if (options_.kinematics == SolidKinematics::finite_rotation)
    add_all<SolidKinematics::finite_rotation>(nodes, times);
  else
    add_all<SolidKinematics::neo_hookean>(nodes, times);
  // A dilatation that is not finite also spoils the bulk viscosity loss.
  for (std::size_t i = 0; i < losses_.size(); ++i)
    if (!std::isfinite(losses_[i].internal()))
      least_dilatations_[i] = -std::numeric_limits<double>::infinity();
}


template <typename Real>
void SolidOperator<Real>::find_least_dilatations()
{
  least_dilatations_.assign(materials_.size(), 0.);
  for (const Range &range : batches_.ranges())
    for (unsigned int batch = range.begin; batch < range.end; ++batch)
      least_dilatations_[range.tissue] =
        std::min(least_dilatations_[range.tissue],
                 least_of<Real>(batches_.dilatation[batch]));
}


template <typename Real>
void SolidOperator<Real>::add_linear_forces(NodeFields<Real> &nodes)
{
  // Compute all batches; without a step, there is no viscosity.
  batches_.activate_all();
  TissueEnergies unused;
  if (full())
    add_full_linear_forces(nodes);
  else
    for (const Range &range : batches_.ranges())
      add_range<SolidKinematics::small_strain, false>(
        range, nodes, linear_model(materials_[range.tissue]), unused);
  batches_.reset_state();
}


template class SolidOperator<double>;
template class SolidOperator<float>;
} // namespace contrecoup::solid
