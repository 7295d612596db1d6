// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Contrecoup authors

#include <contrecoup/base/lane_math.h>
#include <contrecoup/gas/front_sensor.h>
#include <contrecoup/gas/primitive.h>

#include <algorithm>

namespace contrecoup::gas
{
namespace
{
  /// The sensor of one batch of leaves after another.
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
      : mesh_(mesh)
      , points_(points)
      , gas_(gas)
      , field_(field)
      , layout_(field.layout())
      , noise_(noise)
      , primitive_(nc * layout_.n_points)
      , compression_share_(layout_.n_points)
      , pressure_(layout_.n + 2)
      , velocity_(layout_.n + 2)
    {
      for (unsigned int i = 0; i <= layout_.n; ++i)
        distance_.push_back(distance(i));
    }

    /// By face; see front_sensor_by_face().
    std::array<Number, 2 * dim> compute(const unsigned int batch)
    {
      batch_ = batch;
      for (unsigned int q = 0; q < layout_.n_points; ++q)
      {
        Values u;
        for (unsigned int c = 0; c < nc; ++c)
          u[c].load(field_.template state<Real>() +
                    batch * layout_.batch_size() + layout_.value(c, q));
        Values p = to_primitive<dim>(gas_, u);
        for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
          hold_back(batch * n_lanes<Real> + lane, q, lane, p);
        for (unsigned int c = 0; c < nc; ++c)
          primitive_[c * layout_.n_points + q] = p[c];
      }
      for (unsigned int q = 0; q < layout_.n_points; ++q)
        compression_share_[q] = compression_share(q);
      std::array<Number, 2 * dim> largest;
      largest.fill(Number(0.));
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int line = 0; line < layout_.n_face_points; ++line)
        {
          fill_line(d, line);
          const auto [up, down] = line_rises(d, line);
          largest[2 * d] = std::max(largest[2 * d], up);
          largest[2 * d + 1] = std::max(largest[2 * d + 1], down);
        }
      for (Number &rise : largest)
        rise = rise / (rise + noise_);
      return largest;
    }

  private:
    static constexpr unsigned int nc = n_conserved<dim, Gas>;
    using Values = std::array<Number, nc>;
    using C = Component<dim>;

    /// Takes the pressure that unburned explosive does not exert.
    void hold_back(const unsigned int leaf,
                   const unsigned int point,
                   const unsigned int lane,
                   Values &p) const
    {
      if (field_.burn() != nullptr)
        p[C::energy][lane] = field_.exerted_pressure(
          p[C::energy][lane], field_.burned(leaf, point));
    }

    /// Derivative of a velocity component from the neighbours on the leaf
    /// [1/s].
    Number derivative(const unsigned int component,
                      const unsigned int direction,
                      const unsigned int q) const
    {
      const unsigned int n = layout_.n;
      const unsigned int s = layout_.stride(direction);
      const unsigned int i = (q / s) % n;
      const unsigned int before = i > 0 ? 1 : 0;
      const unsigned int after = i + 1 < n ? 1 : 0;
      double edges = 0.;
      if (before)
        edges += distance_[i];
      if (after)
        edges += distance_[i + 1];
      if (edges == 0.)
        return Number(0.);
      const Number *u =
        &primitive_[(C::momentum + component) * layout_.n_points + q];
      return (u[after * s] - *(u - before * s)) /
             (mesh_.template extents<Real>(batch_)[direction] * edges);
    }

    /// (div u)^2 / ((div u)^2 + |curl u|^2) at a point; one at rest, and
    /// where leaves hold single points.
    Number compression_share(const unsigned int q) const
    {
      if (dim == 1 || layout_.n == 1)
        return Number(1.);
      // Slower than a change in ten thousand years.
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

    void fill_line(const unsigned int direction, const unsigned int line)
    {
      const unsigned int n = layout_.n;
      const unsigned int stride = layout_.stride(direction);
      const unsigned int first = layout_.face_point(2 * direction, line, 0);
      const Number *pressure = &primitive_[C::energy * layout_.n_points];
      const Number *velocity =
        &primitive_[(C::momentum + direction) * layout_.n_points];
      for (unsigned int i = 0; i < n; ++i)
      {
        pressure_[i + 1] = pressure[first + i * stride];
        velocity_[i + 1] = velocity[first + i * stride];
      }
      for (unsigned int side = 0; side < 2; ++side)
      {
        const Values p = beyond(2 * direction + side, line);
        pressure_[side * (n + 1)] = p[C::energy];
        velocity_[side * (n + 1)] = p[C::momentum + direction];
      }
      // Where no equal neighbour is, the field goes on linearly.
      for (auto s = mesh_.special_begin(batch_); s != mesh_.special_end(batch_);
           ++s)
        if (s->face / 2 == direction)
          for (auto *values : {&pressure_[0], &velocity_[0]})
          {
            const unsigned int end = s->face % 2 ? n + 1 : 0;
            const unsigned int next = s->face % 2 ? n : 1;
            const unsigned int inner =
              n == 1 ? next : (s->face % 2 ? n - 1 : 2);
            values[end][s->lane] =
              2. * values[next][s->lane] - values[inner][s->lane];
          }
    }

    /// The next point across a face; nodes that coincide with the leaf's own
    /// are passed over.
    Values beyond(const unsigned int face, const unsigned int line) const
    {
      const unsigned int depth =
        points_.is_galerkin() ? std::min(1U, layout_.n - 1) : 0;
      const unsigned int point = layout_.face_point(face ^ 1U, line, depth);
      const unsigned int *neighbors = mesh_.neighbors(batch_, face);
      std::array<unsigned int, n_lanes<Real>> offset;
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
        offset[lane] = layout_.offset(neighbors[lane]);
      Values u;
      for (unsigned int c = 0; c < nc; ++c)
        u[c].gather(field_.template state<Real>() + layout_.value(c, point),
                    offset.data());
      Values p = to_primitive<dim>(gas_, u);
      for (unsigned int lane = 0; lane < n_lanes<Real>; ++lane)
        hold_back(neighbors[lane], point, lane, p);
      return p;
    }

    /// Rise of the pressure along a line, towards its upper and its lower end,
    /// where the gas does not expand.
    std::array<Number, 2> line_rises(const unsigned int direction,
                                     const unsigned int line) const
    {
      const int n = layout_.n;
      const unsigned int stride = layout_.stride(direction);
      const unsigned int first = layout_.face_point(2 * direction, line, 0);
      const Number zero(0.);
      Number up(0.), down(0.);
      for (int i = 0; i <= n; ++i)
      {
        const Number share =
          (compression_share_[first + std::max(i - 1, 0) * stride] +
           compression_share_[first + std::min(i, n - 1) * stride]) *
          0.5;
        const Number change = select_less(
          velocity_[i],
          velocity_[i + 1],
          zero,
          Number((pressure_[i + 1] - pressure_[i]) * share /
                 std::min(std::abs(pressure_[i]), std::abs(pressure_[i + 1]))));
        up += std::max(change, zero);
        down -= std::min(change, zero);
      }
      return {{up, down}};
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
    unsigned int batch_ = 0;
    std::vector<double> distance_;
    dealii::AlignedVector<Number> primitive_; ///< [component][point]
    dealii::AlignedVector<Number> compression_share_;
    dealii::AlignedVector<Number> pressure_; ///< of a line and beyond
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
