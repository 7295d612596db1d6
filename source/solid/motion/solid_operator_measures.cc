// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/numerics/element/hex8_full.h>
#include <contrecoup/solid/motion/solid_operator.h>

#include <cmath>
#include <limits>

namespace contrecoup::solid
{
namespace
{
  template <typename Real>
  double sum_of(const Lanes<Real> &values, const unsigned int n_filled)
  {
    double sum = 0.;
    for (unsigned int lane = 0; lane < n_filled; ++lane)
      sum += static_cast<double>(values[lane]);
    return sum;
  }

  /// Energy stored in hourglass modes [J].
  template <SolidKinematics kinematics, typename Number>
  Number hourglass_energy(const Hourglass<Number> &control,
                          const HexVectors<Number> &x,
                          const HexGeometry<Number> &g,
                          const HexVectors<Number> &u,
                          const Matrix3<Number> &h)
  {
    const auto q = hourglass_modes(g, u, h);
    if (control.kind != HourglassKind::assumed_strain)
      return half_work(
        spring_forces(control.stiffness * g.stiffness_length(), q), q);
    Number energy;
    Matrix3<Number> unused{};
    constexpr bool finite = kinematics != SolidKinematics::small_strain;
    assumed_strain_forces(control.stiffness,
                          hex_frame(x),
                          g,
                          q,
                          finite ? &h : nullptr,
                          unused,
                          energy);
    return energy;
  }

  /// Relaxed strain at the present, from the stored value at the middle of the
  /// next step. Where the rest of that step relaxes all but rounding errors, it
  /// is the strain itself.
  template <typename Real>
  Symmetric3<Lanes<Real>> relaxed_now(const Lanes<Real> *stored,
                                      const Symmetric3<Lanes<Real>> &measure,
                                      const Lanes<Real> &decay_after)
  {
    if (!(decay_after[0] > std::sqrt(std::numeric_limits<Real>::epsilon())))
      return measure;
    Symmetric3<Lanes<Real>> now;
    for (unsigned int k = 0; k < 6; ++k)
      now[k] = measure[k] + (stored[k] - measure[k]) / decay_after;
    return now;
  }

  /// Relaxation loss of the coming half step, which is booked already [J/m^3].
  template <typename Number>
  Number half_step_loss(const SolidLaw<Number> &law,
                        const SolidStrain<Number> &strain,
                        const Symmetric3<Number> &relaxed,
                        const StepTimes &times)
  {
    if (!(times.relax_after > 0.))
      return Number();
    Symmetric3<Number> stretch, rate;
    for (unsigned int k = 0; k < 6; ++k)
    {
      stretch[k] = strain.total[k] - relaxed[k];
      rate[k] = strain.shear_measure[k] - relaxed[k];
    }
    const double part =
      times.relax_after / (times.relax_before + times.relax_after);
    // Where all has relaxed, the rate is 0.
    constexpr double not_zero = 1e-30;
    return Number(part) * law.relaxing_fraction /
           (law.decay_before + Number(not_zero)) * law.twice_relaxing *
           contract(stretch, rate);
  }

  /// Strain energy density of a displacement gradient, and half_step_loss()
  /// [J/m^3]. @param stored relaxed strain, or null
  template <SolidKinematics kinematics, typename Number>
  std::pair<Number, Number> energy_density(const SolidLaw<Number> &law,
                                           const Matrix3<Number> &h,
                                           const Number *stored,
                                           const StepTimes &times)
  {
    const auto strain = solid_strain<kinematics>(h, cofactor(h));
    Symmetric3<Number> relaxed{};
    Number loss{};
    if (stored != nullptr)
    {
      relaxed = relaxed_now(stored, strain.shear_measure, law.decay_after);
      loss = half_step_loss(law, strain, relaxed, times);
    }
    return {stored_energy<kinematics>(law, strain, relaxed), loss};
  }

  /// Shear stress [Pa]; arguments as in energy_density().
  template <SolidKinematics kinematics, typename Number>
  Symmetric3<Number> shear_stress(const SolidLaw<Number> &law,
                                  const Matrix3<Number> &h,
                                  const Number *stored)
  {
    const auto strain = solid_strain<kinematics>(h, cofactor(h));
    Symmetric3<Number> shear, relaxed{};
    if (stored != nullptr)
      relaxed = relaxed_now(stored, strain.shear_measure, law.decay_after);
    for (unsigned int k = 0; k < 6; ++k)
      shear[k] =
        law.twice_shear * strain.shear_measure[k] -
        (stored == nullptr ? Number() : law.twice_relaxing * relaxed[k]);
    return shear;
  }

  /// Cauchy stress P F^T / J of a first Piola-Kirchhoff stress P.
  template <typename Number>
  Symmetric3<Number> cauchy_stress(const Matrix3<Number> &h,
                                   const Matrix3<Number> &p,
                                   const Number &dilatation)
  {
    constexpr unsigned int row[] = {0, 1, 2, 0, 1, 2};
    constexpr unsigned int column[] = {0, 1, 2, 1, 2, 0};
    const Number factor = Number(1.) / (Number(1.) + dilatation);
    Symmetric3<Number> s;
    for (unsigned int k = 0; k < 6; ++k)
    {
      const unsigned int i = row[k], j = column[k];
      s[k] = factor * (p[i][j] + p[i][0] * h[j][0] + p[i][1] * h[j][1] +
                       p[i][2] * h[j][2]);
    }
    return s;
  }

  /// Ratio of deformed to undeformed element stiffness: from gradients and
  /// modulus of compression, and from shear.
  template <typename Number>
  Number stiffening(const SolidMaterial &material,
                    const bool finite,
                    const HexGeometry<Number> &g,
                    const Matrix3<Number> &h)
  {
    Number of_volume(1.), of_shear(1.);
    Number dilatation = h[0][0] + h[1][1] + h[2][2];
    if (finite)
    {
      const Matrix3<Number> cofactors = cofactor(h);
      const Matrix3<Number> c = deformed_cofactor(h, cofactors);
      Number deformed{};
      for (const Vector3<Number> &b : g.volume_gradient)
        for (unsigned int i = 0; i < 3; ++i)
        {
          const Number component = dot(c[i], b);
          deformed += component * component;
        }
      of_volume = Number(8.) * deformed / g.gradient_square;
      const Symmetric3<Number> e = green_strain<true>(h);
      of_shear += Number(2. / 3.) * (e[0] + e[1] + e[2]);
      dilatation = finite_dilatation(h, cofactors);
    }
    if (material.gas.exists())
      of_volume *= apply_to_lanes(
        [&](const double x) { return material.stiffening(x); }, dilatation);
    const double shear = 2. / 3. * material.instantaneous_shear;
    const double lame = std::max(0., material.bulk_modulus - shear);
    return (Number(lame) * of_volume + Number(shear) * of_shear) /
           Number(lame + shear);
  }

  /// Number of lanes that hold elements; they are the first ones.
  template <typename Real>
  unsigned int count_filled(const HexBatches<Real> &batches,
                            const unsigned int batch)
  {
    unsigned int n = 0;
    while (n < n_lanes<Real> &&
           batches.cell(batch, n) != HexBatches<Real>::spare)
      ++n;
    return n;
  }
} // namespace


template <typename Real>
template <SolidKinematics kinematics>
void SolidOperator<Real>::energies_of(const Range &range,
                                      const NodeFields<Real> &nodes,
                                      const StepTimes &times,
                                      const std::vector<Real> &squares,
                                      TissueEnergies &sum) const
{
  const SolidMaterial &material = materials_[range.tissue];
  const HexModel<Lane> model = this->model(material, times);
  for (unsigned int batch = range.begin; batch < range.end; ++batch)
  {
    const unsigned int *offsets = batches_.offsets(batch, 0);
    HexVectors<Lane> x, u;
    load_corners(nodes.position_and_displacement.data(), offsets, x, u);
    x = to_modes(x);
    u = to_modes(u);
    const HexGeometry<Lane> g = hex_geometry(x);
    const Matrix3<Lane> h = mean_gradient(g, u);
    const Lane *stored =
      range.viscoelastic ? batches_.relaxed_of(range, batch) : nullptr;
    const unsigned int n_filled = count_filled(batches_, batch);
    if (range.smoothed)
    {
      // The elastic part of the smoothing's work, but for one step's change.
      const double elastic =
        sum_of<Real>(Real(0.5) * g.volume * batches_.dilatation[batch] *
                       batches_.smoothing_pressure[batch],
                     n_filled);
      sum.stored -= elastic;
      sum.pressure_smoothing += elastic;
    }
    const auto add = [&](const SolidLaw<Lane> &law,
                         const Lane &volume,
                         const Matrix3<Lane> &gradient,
                         const Lane *memory) {
      const auto [energy, loss] =
        energy_density<kinematics>(law, gradient, memory, times);
      sum.stored += sum_of<Real>(volume * energy, n_filled);
      sum.relaxation -= sum_of<Real>(volume * loss, n_filled);
    };
    if (full())
    {
      add(volume_law(model.law), g.volume, h, nullptr);
      for (unsigned int i = 0; i < 8; ++i)
      {
        const HexPoint<Lane> point = hex_point(x, u, i);
        add(shear_law(model.law),
            point.volume,
            point.h,
            stored == nullptr ? nullptr : stored + 6 * i);
      }
    }
    else
    {
      add(model.law, g.volume, h, stored);
      sum.hourglass += sum_of<Real>(
        hourglass_energy<kinematics>(model.hourglass, x, g, u, h), n_filled);
    }

    Lane square{};
    for (unsigned int i = 0; i < 8 * n_lanes<Real>; ++i)
      square[i % n_lanes<Real>] += squares[offsets[i] / nodes.width];
    sum.kinetic +=
      material.density / 16. * sum_of<Real>(g.volume * square, n_filled);
  }
}


template <typename Real>
std::vector<Real>
SolidOperator<Real>::velocity_squares(const NodeFields<Real> &nodes,
                                      const StepTimes &times) const
{
  std::vector<Real> squares(nodes.size(), Real());
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Real factor = Real(times.before) * nodes.inverse_mass_of(i);
    const Real *v = nodes.velocity_of(i), *f = nodes.force_of(i);
    for (unsigned int d = 0; d < 3; ++d)
      squares[i] += v[d] * (v[d] + factor * f[d]);
  }
  // Masters carry the inertia of hanging nodes.
  for (const HexMesh::HangingNode &one : mesh_->hanging_nodes)
  {
    squares[one.node] = Real();
    for (std::size_t i = 0; i < one.masters.size(); ++i)
      squares[one.node] += Real(one.weights[i]) * squares[one.masters[i]];
  }
  return squares;
}


template <typename Real>
std::vector<TissueEnergies>
SolidOperator<Real>::energies(const NodeFields<Real> &nodes,
                              const StepTimes &times) const
{
  std::vector<TissueEnergies> sums = losses_;
  const std::vector<Real> squares = velocity_squares(nodes, times);
  for (const Range &range : batches_.ranges())
  {
    TissueEnergies &sum = sums[range.tissue];
    switch (options_.kinematics)
    {
      case SolidKinematics::small_strain:
        energies_of<SolidKinematics::small_strain>(
          range, nodes, times, squares, sum);
        break;
      case SolidKinematics::finite_rotation:
        energies_of<SolidKinematics::finite_rotation>(
          range, nodes, times, squares, sum);
        break;
      case SolidKinematics::neo_hookean:
        energies_of<SolidKinematics::neo_hookean>(
          range, nodes, times, squares, sum);
    }
  }
  return sums;
}


template <typename Real>
double SolidOperator<Real>::deformed_step(const NodeFields<Real> &nodes,
                                          const double body_step) const
{
  const bool finite = options_.kinematics != SolidKinematics::small_strain;
  double least = 1.;
  for (const Range &range : batches_.ranges())
  {
    const SolidMaterial &material = materials_[range.tissue];
    if (!finite && !material.gas.exists())
      continue;
    const double shear = material.instantaneous_shear;
    const double largest_stiffness =
      std::max(0., material.bulk_modulus - 2. / 3. * shear) + 2. * shear;
    // Squared ratio of an element's own stable step to that of the body.
    const Lane own =
      Real(material.density / (2. * largest_stiffness * body_step * body_step));
    for (unsigned int batch = range.begin; batch < range.end; ++batch)
    {
      HexVectors<Lane> x, u;
      load_corners(nodes.position_and_displacement.data(),
                   batches_.offsets(batch, 0),
                   x,
                   u);
      const HexGeometry<Lane> g = hex_geometry(to_modes(x));
      const Lane stiffer =
        stiffening(material, finite, g, mean_gradient(g, to_modes(u)));
      const Lane alone = own * g.volume * g.volume / g.gradient_square;
      const unsigned int n_filled = count_filled(batches_, batch);
      for (unsigned int lane = 0; lane < n_filled; ++lane)
        least = std::min(least,
                         std::max<double>(1., alone[lane]) /
                           std::max<double>(1., stiffer[lane]));
    }
  }
  return least < 1. ? std::sqrt(least) * body_step : body_step;
}


template <typename Real>
template <SolidKinematics kinematics>
void SolidOperator<Real>::visit_batch(const Range &range,
                                      const unsigned int batch,
                                      const NodeFields<Real> &nodes,
                                      const HexModel<Lane> &model,
                                      Values &values) const
{
  HexVectors<Lane> x, u;
  load_corners(
    nodes.position_and_displacement.data(), batches_.offsets(batch, 0), x, u);
  const HexGeometry<Lane> g = hex_geometry(to_modes(x));
  const Matrix3<Lane> h = mean_gradient(g, to_modes(u));
  const Matrix3<Lane> cofactors = cofactor(h);
  const auto strain = solid_strain<kinematics>(h, cofactors);
  const Lane *stored =
    range.viscoelastic ? batches_.relaxed_of(range, batch) : nullptr;
  Symmetric3<Lane> shear{};
  if (full())
    for (unsigned int i = 0; i < 8; ++i)
    {
      const HexPoint<Lane> point = hex_point(to_modes(x), to_modes(u), i);
      const Symmetric3<Lane> part = shear_stress<kinematics>(
        model.law, point.h, stored == nullptr ? nullptr : stored + 6 * i);
      for (unsigned int k = 0; k < 6; ++k)
        shear[k] += point.volume * g.inverse_volume * part[k];
    }
  else
    shear = shear_stress<kinematics>(model.law, h, stored);
  Lane volumetric = volumetric_stress(model.law, strain.dilatation);
  if (range.smoothed)
    volumetric -= batches_.smoothing_pressure[batch];
  const auto piola = piola_stress<kinematics>(h, cofactors, volumetric, shear);
  const Symmetric3<Lane> stress =
    kinematics == SolidKinematics::small_strain
      ? Symmetric3<Lane>{{piola[0][0],
                          piola[1][1],
                          piola[2][2],
                          piola[0][1],
                          piola[1][2],
                          piola[2][0]}}
      : cauchy_stress(h, piola, strain.dilatation);
  for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
  {
    for (unsigned int k = 0; k < 6; ++k)
    {
      values[lane].strain[k] = strain.total[k][lane];
      values[lane].stress[k] = stress[k][lane];
    }
    values[lane].dilatation = strain.dilatation[lane];
    values[lane].volume = g.volume[lane];
  }
}


template <typename Real>
void SolidOperator<Real>::visit_any(const Range &range,
                                    const unsigned int batch,
                                    const NodeFields<Real> &nodes,
                                    const HexModel<Lane> &model,
                                    Values &values) const
{
  switch (options_.kinematics)
  {
    case SolidKinematics::small_strain:
      return visit_batch<SolidKinematics::small_strain>(
        range, batch, nodes, model, values);
    case SolidKinematics::finite_rotation:
      return visit_batch<SolidKinematics::finite_rotation>(
        range, batch, nodes, model, values);
    default:
      return visit_batch<SolidKinematics::neo_hookean>(
        range, batch, nodes, model, values);
  }
}


template <typename Real>
void SolidOperator<Real>::visit_range(
  const Range &range,
  const NodeFields<Real> &nodes,
  const StepTimes &times,
  const bool skip_inactive,
  const std::function<void(std::uint32_t, const ElementValues &)> &function)
  const
{
  const HexModel<Lane> model = this->model(materials_[range.tissue], times);
  Values values;
  for (unsigned int batch = range.begin; batch < range.end; ++batch)
  {
    if (skip_inactive && !batches_.was_active(batch))
      continue;
    visit_any(range, batch, nodes, model, values);
    const unsigned int n_filled = count_filled(batches_, batch);
    for (unsigned int lane = 0; lane < n_filled; ++lane)
      function(batches_.cell(batch, lane), values[lane]);
  }
}


template <typename Real>
void SolidOperator<Real>::visit(
  const NodeFields<Real> &nodes,
  const StepTimes &times,
  const std::function<void(std::uint32_t, const ElementValues &)> &function,
  const unsigned int tissue) const
{
  for (const Range &range : batches_.ranges())
    if (tissue == all_tissues || range.tissue == tissue)
      visit_range(range, nodes, times, false, function);
}


template <typename Real>
void SolidOperator<Real>::visit_active(
  const NodeFields<Real> &nodes,
  const StepTimes &times,
  const std::function<void(std::uint32_t, const ElementValues &)> &function,
  const unsigned int tissue) const
{
  for (const Range &range : batches_.ranges())
    if (range.tissue == tissue)
      visit_range(range, nodes, times, true, function);
}


template <typename Real>
ElementValues SolidOperator<Real>::values(const NodeFields<Real> &nodes,
                                          const StepTimes &times,
                                          const std::uint32_t cell) const
{
  const std::uint32_t slot = batches_.slot(cell);
  const unsigned int batch = slot / n_lanes<Real>;
  std::array<ElementValues, n_lanes<Real>> values;
  for (const Range &range : batches_.ranges())
    if (batch >= range.begin && batch < range.end)
      visit_any(
        range, batch, nodes, model(materials_[range.tissue], times), values);
  return values[slot % n_lanes<Real>];
}


template class SolidOperator<double>;
template class SolidOperator<float>;
} // namespace contrecoup::solid
