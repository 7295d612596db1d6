// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lanes/lane_math.h>
#include <contrecoup/gas/adaptation/jump_sensor.h>
#include <contrecoup/gas/state/line_reader.h>

namespace contrecoup::gas
{
namespace
{
  /// Computes the sensor of one batch of leaves at a time.
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
      : reader_(mesh, points, gas, field)
      , noise_(noise)
      , pressure_only_(pressure_only)
      , density_(field.layout().n + 2)
      , pressure_(field.layout().n + 2)
    {}

    Number compute(const unsigned int batch)
    {
      reader_.bind(batch);
      Number largest(0.);
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int line = 0; line < reader_.layout().n_face_points;
             ++line)
        {
          reader_.template read<2>(
            d,
            line,
            {{Component<dim>::density, Component<dim>::pressure}},
            {{density_.data(), pressure_.data()}});
          if (!pressure_only_)
            largest = std::max(largest, line_sensor(density_));
          largest = std::max(largest, line_sensor(pressure_));
        }
      return largest;
    }

  private:
    using Line = dealii::AlignedVector<Number>;

    Number line_sensor(const Line &line) const
    {
      Number largest(0.);
      for (unsigned int i = 1; i <= reader_.layout().n; ++i)
      {
        const double before = reader_.distance(i - 1);
        const double after = reader_.distance(i);
        const Number s_low = (line[i] - line[i - 1]) * (1. / before);
        const Number s_high = (line[i + 1] - line[i]) * (1. / after);
        const Number filter = (std::abs(line[i + 1]) + std::abs(line[i]) * 2. +
                               std::abs(line[i - 1])) *
                              (noise_ * 2. / (before + after));
        largest =
          std::max(largest,
                   Number(std::abs(s_high - s_low) /
                          (std::abs(s_high) + std::abs(s_low) + filter)));
      }
      return largest;
    }

    LineReader<dim, Gas, Real> reader_;
    const double noise_;
    const bool pressure_only_;
    Line density_; ///< along a line, extended at both ends
    Line pressure_;
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
