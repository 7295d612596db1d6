// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/adaptation/front_sensor.h>
#include <contrecoup/gas/state/line_reader.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// Computes the sensor of one batch of leaves at a time.
  template <int dim, typename Gas, typename Real>
  class BatchFronts
  {
  public:
    using Number = Lanes<Real>;

    BatchFronts(const LeafMesh<dim> &mesh,
                const LeafPoints<dim> &points,
                const Gas &gas,
                const GasField &field,
                const double noise)
      : reader_(mesh, points, gas, field)
      , noise_(noise)
      , ducros_factor_(field.layout().n_points)
      , pressure_(field.layout().n + 2)
      , velocity_(field.layout().n + 2)
    {}

    /// Sensor per face; see front_sensor_by_face().
    std::array<Number, 2 * dim> compute(const unsigned int batch)
    {
      reader_.bind(batch);
      for (unsigned int q = 0; q < layout().n_points; ++q)
        ducros_factor_[q] = ducros_factor(q);
      std::array<Number, 2 * dim> largest;
      largest.fill(Number(0.));
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int line = 0; line < layout().n_face_points; ++line)
        {
          reader_.template read<2>(d,
                                   line,
                                   {{C::pressure, C::velocity + d}},
                                   {{pressure_.data(), velocity_.data()}});
          const auto [up, down] = line_rises(d, line);
          largest[2 * d] = std::max(largest[2 * d], up);
          largest[2 * d + 1] = std::max(largest[2 * d + 1], down);
        }
      for (Number &rise : largest)
        rise = rise / (rise + noise_);
      return largest;
    }

  private:
    using C = Component<dim>;

    const LeafLayout &layout() const
    {
      return reader_.layout();
    }

    /// Derivative of a velocity component from neighbouring points within the
    /// leaf [1/s].
    Number derivative(const unsigned int component,
                      const unsigned int direction,
                      const unsigned int q) const
    {
      const unsigned int n = layout().n;
      const unsigned int s = layout().stride(direction);
      const unsigned int i = (q / s) % n;
      const unsigned int before = i > 0 ? 1 : 0;
      const unsigned int after = i + 1 < n ? 1 : 0;
      double edges = 0.;
      if (before)
        edges += reader_.distance(i);
      if (after)
        edges += reader_.distance(i + 1);
      if (edges == 0.)
        return Number(0.);
      const Number *u = reader_.values(C::velocity + component) + q;
      return (u[after * s] - *(u - before * s)) /
             (reader_.extent(direction) * edges);
    }

    /// (div u)^2 / ((div u)^2 + |curl u|^2) at a point; one for gas at rest
    /// and for leaves with a single point.
    Number ducros_factor(const unsigned int q) const
    {
      if (dim == 1 || layout().n == 1)
        return Number(1.);
      // [1/s^2]; avoids 0 / 0 in gas at rest.
      const double rest = 1e-24;
      Number divergence(0.), curl_square(0.);
      for (unsigned int d = 0; d < dim; ++d)
      {
        divergence += derivative(d, d, q);
        for (unsigned int e = 0; e < d; ++e)
        {
          const Number curl = derivative(d, e, q) - derivative(e, d, q);
          curl_square += curl * curl;
        }
      }
      const Number square = divergence * divergence + rest;
      return square / (square + curl_square);
    }

    /// Pressure rise along a line towards its upper and its lower end, where
    /// the gas does not expand.
    std::array<Number, 2> line_rises(const unsigned int direction,
                                     const unsigned int line) const
    {
      const int n = layout().n;
      const unsigned int stride = layout().stride(direction);
      const unsigned int first = layout().face_point(2 * direction, line, 0);
      const Number zero(0.);
      Number up(0.), down(0.);
      for (int i = 0; i <= n; ++i)
      {
        const Number weight =
          (ducros_factor_[first + std::max(i - 1, 0) * stride] +
           ducros_factor_[first + std::min(i, n - 1) * stride]) *
          0.5;
        const Number change = select_less(
          velocity_[i],
          velocity_[i + 1],
          zero,
          Number((pressure_[i + 1] - pressure_[i]) * weight /
                 std::min(std::abs(pressure_[i]), std::abs(pressure_[i + 1]))));
        up += std::max(change, zero);
        down -= std::min(change, zero);
      }
      return {{up, down}};
    }

    LineReader<dim, Gas, Real> reader_;
    const double noise_;
    dealii::AlignedVector<Number> ducros_factor_;
    /// Along a line, extended at both ends.
    dealii::AlignedVector<Number> pressure_;
    dealii::AlignedVector<Number> velocity_; ///< along the line
  };
} // namespace


template <int dim>
std::vector<FaceValues<dim>>
front_sensor_by_face(const LeafMesh<dim> &mesh,
                     const LeafPoints<dim> &points,
                     const GasMaterial &material,
                     const GasField &field,
                     const double noise,
                     const std::vector<bool> &wanted)
{
  std::vector<FaceValues<dim>> result(mesh.n_owned(), FaceValues<dim>{});
  const auto compute = [&](const auto &gas, const auto real) {
    using Real = kernel_number<dim, std::decay_t<decltype(real)>>;
    BatchFronts<dim, std::decay_t<decltype(gas)>, Real> fronts(
      mesh, points, gas, field, noise);
    for (unsigned int batch = 0; batch < mesh.n_batches(); ++batch)
    {
      if (!wanted[batch])
        continue;
      const auto values = fronts.compute(batch);
      for (unsigned int lane = 0; lane < mesh.n_filled_lanes(batch); ++lane)
        for (unsigned int face = 0; face < 2 * dim; ++face)
          result[batch * n_lanes<Real> + lane][face] = values[face][lane];
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


template <int dim>
std::vector<double> front_sensor(const LeafMesh<dim> &mesh,
                                 const LeafPoints<dim> &points,
                                 const GasMaterial &material,
                                 const GasField &field,
                                 const double noise,
                                 const std::vector<bool> &wanted)
{
  std::vector<double> result;
  for (const auto &values :
       front_sensor_by_face(mesh, points, material, field, noise, wanted))
    result.push_back(*std::max_element(values.begin(), values.end()));
  return result;
}


#define CONTRECOUP_INSTANTIATE(dim)                                  \
  template std::vector<FaceValues<dim>> front_sensor_by_face(        \
    const LeafMesh<dim> &,                                           \
    const LeafPoints<dim> &,                                         \
    const GasMaterial &,                                             \
    const GasField &,                                                \
    double,                                                          \
    const std::vector<bool> &);                                      \
  template std::vector<double> front_sensor(const LeafMesh<dim> &,   \
                                            const LeafPoints<dim> &, \
                                            const GasMaterial &,     \
                                            const GasField &,        \
                                            double,                  \
                                            const std::vector<bool> &)

CONTRECOUP_INSTANTIATE(1);
CONTRECOUP_INSTANTIATE(2);
CONTRECOUP_INSTANTIATE(3);
#undef CONTRECOUP_INSTANTIATE
} // namespace contrecoup::gas
