// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lane_math.h>
#include <contrecoup/gas/jump_sensor.h>
#include <contrecoup/gas/primitive.h>

namespace contrecoup::gas
{
namespace
{
  /// The sensor of one batch of leaves after another.
  template <int dim, typename Gas, typename Real>
  class BatchSensor
  {
  public:
    using Number = Lanes<Real>;

    BatchSensor(const LeafMesh<dim> &mesh,
                const LeafPoints<dim> &points,
                const Gas &gas,
                const GasField &field,
                const double noise,
                const bool pressure_only)
      : mesh_(mesh)
      , points_(points)
      , gas_(gas)
      , field_(field)
      , layout_(field.layout())
      , noise_(noise)
      , first_quantity_(pressure_only ? 1 : 0)
      , values_(2 * layout_.n_points)
      , line_(layout_.n + 2)
    {}

    Number compute(const unsigned int batch)
    {
      batch_ = batch;
      for (unsigned int q = 0; q < layout_.n_points; ++q)
      {
        std::array<Number, nc> u;
        for (unsigned int c = 0; c < nc; ++c)
          u[c].load(field_.template state<Real>() +
                    batch * layout_.batch_size() + layout_.value(c, q));
        store(to_primitive<dim>(gas_, u),
              values_[q],
              values_[q + layout_.n_points]);
        for (unsigned int lane = 0;
             lane < n_lanes<Real> && field_.burn() != nullptr;
             ++lane)
        {
          Real &pressure = values_[q + layout_.n_points][lane];
          pressure = field_.exerted_pressure(
            pressure, field_.burned(batch * n_lanes<Real> + lane, q));
        }
      }
      Number largest(0.);
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int line = 0; line < layout_.n_face_points; ++line)
        {
          const auto low = beyond(2 * d, line);
          const auto high = beyond(2 * d + 1, line);
          for (unsigned int quantity = first_quantity_; quantity < 2;
               ++quantity)
            largest = std::max(
              largest,
              line_sensor(d, line, quantity, low[quantity], high[quantity]));
        }
      return largest;
    }

  private:
    static constexpr unsigned int nc = n_conserved<dim, Gas>;

    static void
    store(const std::array<Number, nc> &p, Number &density, Number &pressure)
    {
      density = p[Component<dim>::density];
      pressure = p[Component<dim>::energy];
    }

    /// Density and pressure of the next point across a face; nodes that
    /// coincide with the leaf's own are passed over.
    std::array<Number, 2> beyond(const unsigned int face,
                                 const unsigned int line) const
    {
      const unsigned int depth =
        points_.is_galerkin() ? std::min(1U, layout_.n - 1) : 0;
      const unsigned int point = layout_.face_point(face ^ 1U, line, depth);
      std::array<unsigned int, n_lanes<Real>> offset;
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
        offset[lane] = layout_.offset(mesh_.neighbors(batch_, face)[lane]);
      std::array<Number, nc> u;
      for (unsigned int c = 0; c < nc; ++c)
        u[c].gather(field_.template state<Real>() + layout_.value(c, point),
                    offset.data());
      std::array<Number, 2> result;
      store(to_primitive<dim>(gas_, u), result[0], result[1]);
      for (unsigned int lane = 0;
           lane < n_lanes<Real> && field_.burn() != nullptr;
           ++lane)
        result[1][lane] = field_.exerted_pressure(
          result[1][lane],
          field_.burned(mesh_.neighbors(batch_, face)[lane], point));
      return result;
    }

    Number line_sensor(const unsigned int direction,
                       const unsigned int line,
                       const unsigned int quantity,
                       const Number &low,
                       const Number &high)
    {
      const int n = layout_.n;
      const unsigned int stride = layout_.stride(direction);
      const unsigned int first = quantity * layout_.n_points +
                                 layout_.face_point(2 * direction, line, 0);
      for (int i = 0; i < n; ++i)
        line_[i + 1] = values_[first + i * stride];
      line_[0] = low;
      line_[n + 1] = high;
      // Where no equal neighbour is, the field goes on linearly.
      for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
           ++s)
        if (s->face == 2 * direction)
          line_[0][s->lane] = n == 1
                                ? line_[1][s->lane]
                                : 2. * line_[1][s->lane] - line_[2][s->lane];
        else if (s->face == 2 * direction + 1)
          line_[n + 1][s->lane] =
            n == 1 ? line_[n][s->lane]
                   : 2. * line_[n][s->lane] - line_[n - 1][s->lane];
      Number largest(0.);
      for (int i = 1; i <= n; ++i)
      {
        const double before = distance(i - 1);
        const double after = distance(i);
        const Number s_low = (line_[i] - line_[i - 1]) * (1. / before);
        const Number s_high = (line_[i + 1] - line_[i]) * (1. / after);
        const Number filter =
          (std::abs(line_[i + 1]) + std::abs(line_[i]) * 2. +
           std::abs(line_[i - 1])) *
          (noise_ * 2. / (before + after));
        largest =
          std::max(largest,
                   Number(std::abs(s_high - s_low) /
                          (std::abs(s_high) + std::abs(s_low) + filter)));
      }
      return largest;
    }

    /// Distance of point i (from 0, before the first, on) to the next, in
    /// parts of the leaf's edge.
    double distance(const int i) const
    {
      const int n = layout_.n;
      if (n == 1)
        return 1.;
      if (!points_.is_galerkin())
        return 1. / n;
      const int from = i == 0 ? 0 : (i == n ? n - 2 : i - 1);
      return points_.position(from + 1) - points_.position(from);
    }

    const LeafMesh<dim> &mesh_;
    const LeafPoints<dim> &points_;
    const Gas gas_;
    const GasField &field_;
    const LeafLayout layout_;
    const double noise_;
    const unsigned int first_quantity_; ///< 0: density, 1: pressure
    unsigned int batch_ = 0;
    dealii::AlignedVector<Number> values_; ///< density, then pressure
    dealii::AlignedVector<Number> line_;
  };
} // namespace


template <int dim>
std::vector<double> jump_sensor(const LeafMesh<dim> &mesh,
                                const LeafPoints<dim> &points,
                                const GasMaterial &material,
                                const GasField &field,
                                const double noise,
                                const std::vector<bool> &wanted,
                                const bool pressure_only)
{
  std::vector<double> result(mesh.n_owned(), 0.);
  const auto compute = [&](const auto &gas, const auto real) {
    using Real = kernel_number<dim, std::decay_t<decltype(real)>>;
    BatchSensor<dim, std::decay_t<decltype(gas)>, Real> sensor(
      mesh, points, gas, field, noise, pressure_only);
    for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    {
      if (!wanted[batch])
        continue;
      const auto values = sensor.compute(batch);
      for (unsigned int lane = 0; lane < mesh.n_filled_lanes(batch); ++lane)
        result[batch * n_lanes<Real> + lane] = values[lane];
    }
  };
  std::visit(
    [&](const auto &gas) {
      visit_precision(field.layout().precision,
                      [&](const auto real) { compute(gas, real); });
    },
    material.model());
  return result;
}


template std::vector<double> jump_sensor(const LeafMesh<1> &,
                                         const LeafPoints<1> &,
                                         const GasMaterial &,
                                         const GasField &,
                                         double,
                                         const std::vector<bool> &,
                                         bool);
template std::vector<double> jump_sensor(const LeafMesh<2> &,
                                         const LeafPoints<2> &,
                                         const GasMaterial &,
                                         const GasField &,
                                         double,
                                         const std::vector<bool> &,
                                         bool);
template std::vector<double> jump_sensor(const LeafMesh<3> &,
                                         const LeafPoints<3> &,
                                         const GasMaterial &,
                                         const GasField &,
                                         double,
                                         const std::vector<bool> &,
                                         bool);
} // namespace contrecoup::gas
